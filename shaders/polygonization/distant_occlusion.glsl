// The light that distant bricks of the same node hide (see class DistantOcclusion).

// The hidden fractions of surfaces that face the lower and upper ends of the model's axes.
uniform sampler3D hiddenFromLower;
uniform sampler3D hiddenFromUpper;
uniform mat4 eyeToVoxels; // from eye coordinates to texture coordinates
uniform mat3 modelToEye;  // a rotation or reflection, or with columns of length 1 if the model is sheared
uniform vec3 voxel;       // the extent of a voxel, in texture coordinates
uniform vec2 pixelWidth;  // in voxels, at the depth z in eye coordinates: |x + y * z|
#if defined(PARTIAL)
uniform float distantShare; // of the bricks that are in place
#else
const float distantShare = 1.0;
#endif

// The distance from the surface at which occlusion is read, in voxels: voxels with bricks have none of their own.
const float LIFT = 0.4;
// The least width of a voxel, in pixels: smaller ones would flicker when the camera moves. Near occlusion in the picture, which
// changes from pixel to pixel, shows this earlier than that of the grid.
#if defined(GRID_OCCLUSION)
const float LEAST_WIDTH = 3.0;
#else
const float LEAST_WIDTH = 12.0;
#endif

// The fraction of the sky that is hidden from a surface with normal n, as a + dot(b, n), which holds for the given normal and
// similar ones: b in eye coordinates, and a. `lift` is the direction of voxels without bricks.
vec4 distantOcclusionAt(vec3 eyePosition, vec3 eyeNormal, vec3 lift, vec3 toEye)
{
    float smallness = clamp(log2(LEAST_WIDTH * abs(pixelWidth.x + pixelWidth.y * eyePosition.z)), 0.0, 8.0);
    float level = round(smallness);
    // The normals of bricks as small as pixels are noise.
    float averaged = clamp(smallness - 1.0, 0.0, 1.0);
    vec3 normal = normalize(mix(eyeNormal, toEye, averaged) * modelToEye);
    vec3 away = normalize(mix(lift, toEye, averaged) * modelToEye);
    vec3 place = (eyeToVoxels * vec4(eyePosition, 1.0)).xyz + LIFT * exp2(level) * voxel * away;
    vec3 lower = textureLod(hiddenFromLower, place, level).rgb;
    vec3 upper = textureLod(hiddenFromUpper, place, level).rgb;
    float hidden = dot(normal * normal, mix(lower, upper, greaterThan(normal, vec3(0.0))));
    vec3 towards = 0.5 * (upper - lower);
    return distantShare * vec4(modelToEye * towards, hidden - dot(towards, normal));
}
