// Positions in eye coordinates from pixels and depths, for every kind of projection. The scene's projection is a uniform,
// since passes draw without one.

uniform mat4 sceneProjection;
uniform vec2 pixelSize; // in a picture from -1 to 1: 2 / width, 2 / height
uniform ivec4 area; // the lowest and highest pixels of the picture that may show something

const float NOTHING = -1e14; // depths below this mark pixels without a surface

// Convert a depth buffer value, 0 to 1, to z in eye coordinates, which is negative in front of the eye.
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

// Half the picture's width in units of eye coordinates, times sceneProjection[0][0].
float spreadAt(float eyeDepth)
{
    return sceneProjection[2][3] * eyeDepth + sceneProjection[3][3];
}

// The width of a pixel in units of eye coordinates.
float pixelWidthAt(float eyeDepth)
{
    return abs(spreadAt(eyeDepth) * pixelSize.x / sceneProjection[0][0]);
}

// The degree, 0 to 1, to which surfaces within the occlusion radius can be distinguished. If bricks are as small as pixels,
// every pixel is a different surface, and only averages over neighbours are meaningful.
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
