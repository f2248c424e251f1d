// Places in the eye's coordinates from pixels and depths, for every kind of projection: gl_ProjectionMatrix that of the
// scene, handed over as a uniform, since a pass draws with none.

uniform mat4 sceneProjection;
uniform vec2 pixelSize; // of the picture, from -1 to 1: 2 / width, 2 / height

const float NOTHING = -1e14; // a depth beyond this stands for what nothing is drawn on

// From a depth as in a depth buffer, 0 to 1, to the coordinate z of the eye, which is below 0 in front of it.
float eyeDepthOf(float depth)
{
    float z = 2.0 * depth - 1.0;
    return (z * sceneProjection[3][3] - sceneProjection[3][2]) / (sceneProjection[2][2] - z * sceneProjection[2][3]);
}

float bufferDepthOf(float eyeDepth)
{
    vec2 clip = vec2(sceneProjection[2][2] * eyeDepth + sceneProjection[3][2],
                     sceneProjection[2][3] * eyeDepth + sceneProjection[3][3]);
    return 0.5 * clip.x / clip.y + 0.5;
}

// How many units of the eye's coordinates the picture's half is wide, times the projection's first number.
float spreadAt(float eyeDepth)
{
    return sceneProjection[2][3] * eyeDepth + sceneProjection[3][3];
}

// How many of the eye's units a pixel is wide.
float pixelWidthAt(float eyeDepth)
{
    return abs(spreadAt(eyeDepth) * pixelSize.x / sceneProjection[0][0]);
}

// Whether surfaces are told apart within the radius of occlusion: where bricks are as small as pixels, each is a surface of its
// own, and only what neighbours have in common tells anything.
float distinctnessOf(float radius, float eyeDepth)
{
    return smoothstep(4.0, 12.0, radius / pixelWidthAt(eyeDepth));
}

vec3 eyePositionOf(vec2 pixel, float eyeDepth)
{
    vec2 place = pixel * pixelSize - 1.0;
    vec2 offset = vec2(sceneProjection[2][0], sceneProjection[2][1]) * eyeDepth +
                  vec2(sceneProjection[3][0], sceneProjection[3][1]);
    vec2 scale = vec2(sceneProjection[0][0], sceneProjection[1][1]);
    return vec3((place * spreadAt(eyeDepth) - offset) / scale, eyeDepth);
}

vec3 towardsEyeFrom(vec3 position)
{
    return sceneProjection[3][3] == 0.0 ? normalize(-position) : vec3(0.0, 0.0, 1.0);
}
