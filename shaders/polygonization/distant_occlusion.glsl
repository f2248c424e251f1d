// The light that distant bricks of the same node hide (see class DistantOcclusion).

uniform sampler3D hiddenMean; // the hidden fractions of surfaces across the model's axes, and of all by distant bricks alone
uniform sampler3D hiddenBend; // half the difference between both directions, plus 128 / 255
#if defined(SPLATS) // see splat_scene.glsl
#define hasFaceOcclusion (sceneVoxels[2].w >= 1.0)
#define includesNear (sceneVoxels[2].w == 2.0)
#define voxel sceneVoxels[2].xyz
#define pixelWidth vec2(sceneVoxels[0].w, sceneVoxels[1].w)
#define placeInVoxels (gridPosition * sceneVoxels[0].xyz + sceneVoxels[1].xyz)
#else
uniform bool hasFaceOcclusion; // whether the voxels have what is hidden from the middles of faces, near occlusion included
uniform bool includesNear;     // whether this is to be used: it is that of the same bricks
uniform mat4 eyeToVoxels; // from eye coordinates to texture coordinates
uniform vec3 voxel;       // the extent of a voxel, in texture coordinates
uniform vec2 pixelWidth;  // in voxels, at the depth z in eye coordinates: |x + y * z|
#define placeInVoxels (eyeToVoxels * vec4(eyePosition, 1.0)).xyz
#endif
#if !defined(PARTIAL)
const float distantShare = 1.0;
#elif defined(SPLATS)
#define distantShare sceneShare
#else
uniform float distantShare; // of the bricks that are in place
#endif

// The distance from the surface at which occlusion is read, in voxels: voxels with bricks have none of their own. That of faces is
// read in their plane.
const float LIFT = 0.4;
const float FACE_LIFT = 0.5;
// The least width of a voxel, in pixels: smaller ones would flicker when the camera moves. Near occlusion in the picture, which
// changes from pixel to pixel, shows this earlier than that of the grid.
#if defined(GRID_OCCLUSION)
const float LEAST_WIDTH = 3.0;
#else
const float LEAST_WIDTH = 12.0;
#endif

// See OcclusionCurve.
float decodeOcclusion(float code)
{
    const float OFFSET = 0.02;
    return OFFSET * (exp2(log2(1.0 + 1.0 / OFFSET) * code) - 1.0);
}

// The fraction of the sky that is hidden from a surface with normal n, as a + dot(b, n), which holds for the given normal and
// similar ones: b in eye coordinates, and a. `shift` is a step from the surface, in voxels; `lift`, the direction of voxels without
// bricks; `isWhole`, whether near occlusion is included.
vec4 distantOcclusionAt(vec3 eyePosition, vec3 eyeNormal, vec3 shift, vec3 lift, vec3 toEye, bool isWhole)
{
    mat3 modelToEye = mat3(axisOf(0), axisOf(1), axisOf(2)); // a rotation or reflection, unless the model is sheared
    float smallness = clamp(log2(LEAST_WIDTH * abs(pixelWidth.x + pixelWidth.y * eyePosition.z)), 0.0, 8.0);
    float level = round(smallness);
    // The normals of bricks as small as pixels are noise.
    float averaged = clamp(smallness - 1.0, 0.0, 1.0);
    vec3 normal = normalize(mix(eyeNormal, toEye, averaged) * modelToEye);
    vec3 away = exp2(level) * (hasFaceOcclusion ? FACE_LIFT : LIFT) * normalize(mix(lift, toEye, averaged));
    vec3 place = placeInVoxels + voxel * ((shift + away) * modelToEye);
    vec4 mean = textureLod(hiddenMean, place, level);
    vec3 towards = textureLod(hiddenBend, place, level).rgb - 128.0 / 255.0;
    float hidden = !hasFaceOcclusion ? dot(normal * normal, mean.rgb + sign(normal) * towards)
                   : isWhole         ? decodeOcclusion(dot(normal * normal, mean.rgb))
                                     : mean.a + dot(towards, normal);
    return distantShare * vec4(modelToEye * towards, hidden - dot(towards, normal));
}
