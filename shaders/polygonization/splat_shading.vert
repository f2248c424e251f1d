// Shading of splats: draws a point over each tile of the picture that may contain bricks.

#include "gl/fixed_state.glsl"
#define PASSED flat out
#include "polygonization/splat_scene.glsl"

uniform int upAxis;
uniform float studHeight;
uniform vec4 eye;
uniform mat3 rayOrigin;
uniform mat3 rayDirection;
uniform vec2 pictureSize;
uniform int firstSplat;
uniform int numSplats;
uniform ivec2 origin; // the picture's lower left pixel
uniform ivec2 firstPixel; // of the first tile
uniform int tilesAcross;
uniform float tileSide; // pixels
uniform int fogMode;
#if defined(LINES)
uniform float lineWidth;
uniform float oldLineWidth;
uniform vec2 linePixelWidth;
#endif
#if defined(ONE_LIGHT)
uniform int lightNumbers[8];
#endif
#if defined(GRID_OCCLUSION)
uniform int numNeighbors;
uniform vec2 cellPixelWidth;
#endif
#if defined(DISTANT_OCCLUSION)
uniform vec3 voxelScale;
uniform vec3 voxelOffset;
uniform vec3 voxel;
uniform vec2 pixelWidth;
uniform bool hasFaceOcclusion;
uniform bool includesNear;
#if defined(PARTIAL)
uniform float distantShare;
#endif
#endif

void passRays()
{
    mat3 change = eye.w != 0.0 ? rayDirection : rayOrigin;
    sceneRays[0] = vec4(change[1], eye.w);
    sceneRays[1] = vec4(change[2], studHeight);
    sceneRays[2] = vec4(rayOrigin[0], gl_DepthRange.near);
    sceneRays[3] = vec4(rayDirection[0], gl_DepthRange.diff);
    sceneEye = eye;
}

void passMatrices()
{
    mat4 rows = transpose(modelViewMatrix);
    for (int row = 0; row < 3; ++row)
        sceneRows[row] = rows[row];
    sceneNormals[0] = vec4(eyeNormalMatrix[0], pictureSize.x);
    sceneNormals[1] = vec4(eyeNormalMatrix[1], pictureSize.y);
    sceneNormals[2] = vec4(eyeNormalMatrix[2], projectionMatrix[3][3]);
}

void passLight()
{
    sceneAmbient = lightModel.ambient;
#if defined(ONE_LIGHT)
    int number = lightNumbers[0];
    sceneLight[0] = lightSources[number].position;
    sceneLight[1] = vec4(lightSources[number].ambient.rgb, lightSources[number].spotCutoff);
    sceneLight[2] = vec4(lightSources[number].diffuse.rgb, lightSources[number].spotCosCutoff);
    sceneLight[3] = vec4(lightSources[number].specular.rgb, lightSources[number].spotExponent);
    sceneLight[4] = vec4(lightSources[number].constantAttenuation, lightSources[number].linearAttenuation,
                         lightSources[number].quadraticAttenuation, 0.0);
    sceneLight[5] = vec4(lightSources[number].spotDirection, 0.0);
#endif
}

void passOcclusion()
{
#if defined(GRID_OCCLUSION)
    sceneSplats.z = numNeighbors;
    sceneCellWidth = cellPixelWidth;
#endif
#if defined(DISTANT_OCCLUSION)
    sceneVoxels[0] = vec4(voxelScale, pixelWidth.x);
    sceneVoxels[1] = vec4(voxelOffset, pixelWidth.y);
    sceneVoxels[2] = vec4(voxel, float(hasFaceOcclusion) + float(includesNear));
#if defined(PARTIAL)
    sceneShare = distantShare;
#endif
#endif
}

void main()
{
    passRays();
    passMatrices();
    passLight();
    sceneNumbers = ivec4(upAxis, origin, fogMode);
    sceneSplats = ivec3(firstSplat, numSplats, 0);
    passOcclusion();
    sceneFog[0] = vec4(fogParameters.color.rgb, fogParameters.density);
#if defined(LINES)
    sceneLines = vec4(lineWidth, oldLineWidth, linePixelWidth);
#endif
    sceneFog[1] = vec4(fogParameters.end, fogParameters.scale, 0.0, 0.0);

    vec2 tile = vec2(gl_VertexID % tilesAcross, gl_VertexID / tilesAcross);
    // The last tile of a row or column is moved inwards, so that its centre is inside the picture.
    vec2 middle = min(vec2(firstPixel) + (tile + 0.5) * tileSide, pictureSize - 0.5 * tileSide);
    middle = max(middle, 0.5 * min(vec2(tileSide), pictureSize));
    gl_PointSize = tileSide;
    gl_Position = vec4(2.0 * middle / pictureSize - 1.0, 0.0, 1.0);
}
