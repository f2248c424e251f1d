// The light that distant bricks of the same node hide (see class DistantOcclusion).

uniform sampler3D distantOcclusion;
uniform mat4 eyeToVoxels; // from eye coordinates to texture coordinates
uniform mat3 modelToEye;  // a rotation or reflection
uniform vec3 voxel;       // the extent of a voxel, in texture coordinates
uniform vec2 pixelWidth;  // in voxels, at the depth z in eye coordinates: |x + y * z|

// The distance from the surface at which occlusion is read, in voxels: voxels with bricks have none of their own.
const float LIFT = 0.5;
// The least width of a voxel, in pixels: smaller ones would flicker when the camera moves.
const float LEAST_WIDTH = 8.0;

// The vector b in eye coordinates, from -1 to 1 as 0 to 1, and a.
vec4 distantOcclusionAt(vec3 eyePosition, vec3 eyeNormal, vec3 toEye)
{
    float smallness = clamp(log2(LEAST_WIDTH * abs(pixelWidth.x + pixelWidth.y * eyePosition.z)), 0.0, 8.0);
    float level = round(smallness);
    // The normals of bricks as small as pixels are noise.
    vec3 lift = normalize(mix(eyeNormal, toEye, min(smallness, 1.0))) * modelToEye;
    vec3 place = (eyeToVoxels * vec4(eyePosition, 1.0)).xyz + LIFT * exp2(level) * voxel * lift;
    vec4 texel = textureLod(distantOcclusion, place, level);
    vec3 towards = modelToEye * (texel.rgb * (255.0 / 127.0) - 1.0);
    return vec4(0.5 + 0.5 * towards, texel.a);
}
