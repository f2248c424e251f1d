// Shadows of the scene, from the shadow maps that state above the bricks binds (see class ShadowMaps). Without
// #define SHADOWS, there are none.

#if defined(SHADOWS)

uniform int numShadowMaps;
uniform int shadowedLights[4]; // the light of each map, as in lightAt()
uniform float shadowBlurs[4];  // the radius in which edges of shadows are blurred, in texels
uniform sampler2DShadow shadowMaps[4];
uniform mat4 shadowPlanes[4]; // the columns are the planes of texture coordinates, in eye coordinates

// Positions are moved along the normal before they are compared with a map, so that the steps of its depths don't show:
// by so many widths of a texel, and by the blur.
const float SHADOW_OFFSET = 1.75;
const int SHARP_SAMPLES = 4;
const int BLURRED_SAMPLES = 16; // for blurs above 1

// The width of a texel where a map projects to a position, in eye coordinates.
float texelWidth(mat4 planes, vec2 texels, vec4 projected)
{
    vec2 place = projected.xy / projected.w;
    vec2 texelsPerUnit = texels * vec2(length(planes[0].xyz - place.x * planes[3].xyz),
                                       length(planes[1].xyz - place.y * planes[3].xyz));
    return abs(projected.w) / min(texelsPerUnit.x, texelsPerUnit.y);
}

// The mean of samples in a circle, at the points of a sunflower.
float blurredShareIn(int map, vec3 place, vec2 radius)
{
    const float GOLDEN_ANGLE = 2.39996;
    int count = shadowBlurs[map] > 1.0 ? BLURRED_SAMPLES : SHARP_SAMPLES;
    float sum = 0.0;
    for (int index = 0; index < count; ++index)
    {
        float range = sqrt((float(index) + 0.5) / float(count));
        float angle = GOLDEN_ANGLE * float(index);
        sum += textureLod(shadowMaps[map], vec3(place.xy + range * radius * vec2(cos(angle), sin(angle)), place.z), 0.0);
    }
    return sum / float(count);
}

float litShareIn(int map, vec3 position, vec3 normal, float lift)
{
    mat4 planes = shadowPlanes[map];
    vec2 texels = vec2(textureSize(shadowMaps[map], 0));
    float width = texelWidth(planes, texels, vec4(position, 1.0) * planes);
    vec3 moved = position + ((SHADOW_OFFSET + shadowBlurs[map]) * width + lift) * normal;
    vec4 projected = vec4(moved, 1.0) * planes;
    vec3 place = projected.xyz / projected.w;
    bool isInMap = projected.w > 0.0 && all(greaterThanEqual(place.xy, vec2(0.0))) && all(lessThanEqual(place.xy, vec2(1.0)));
    return isInMap ? blurredShareIn(map, place, shadowBlurs[map] / texels) : 1.0;
}

// The fraction of a light that reaches a position at a distance above a surface, in eye coordinates.
float litShare(int light, vec3 position, vec3 normal, float lift)
{
    float share = 1.0;
    for (int map = 0; map < numShadowMaps; ++map)
        if (shadowedLights[map] == light) share *= litShareIn(map, position, normal, lift);
    return share;
}

#else

float litShare(int light, vec3 position, vec3 normal, float lift)
{
    return 1.0;
}

#endif
