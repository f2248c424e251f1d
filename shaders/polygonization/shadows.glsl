// Shadows of the scene, from the shadow maps that state above the bricks binds (see class ShadowMaps). Without
// #define SHADOWS, there are none.

#if defined(SHADOWS)

uniform int numShadowMaps;
uniform int shadowedLights[4];          // the light of each map, as in lightAt()
uniform sampler2DShadow shadowMaps[4];
uniform mat4 shadowPlanes[4];           // the columns are the planes of texture coordinates, in eye coordinates

// Positions are moved along the normal before they are compared with a map, so that the steps of its depths don't show:
// by so many widths of a texel.
const float SHADOW_OFFSET = 2.5;

// The width of a texel where a map projects to a position, in eye coordinates.
float texelWidth(int map, vec4 projected)
{
    mat4 planes = shadowPlanes[map];
    vec2 place = projected.xy / projected.w;
    vec2 size = vec2(textureSize(shadowMaps[map], 0));
    vec2 texelsPerUnit = size * vec2(length(planes[0].xyz - place.x * planes[3].xyz),
                                     length(planes[1].xyz - place.y * planes[3].xyz));
    return abs(projected.w) / min(texelsPerUnit.x, texelsPerUnit.y);
}

float litShareIn(int map, vec3 position, vec3 normal, float lift)
{
    vec4 projected = vec4(position, 1.0) * shadowPlanes[map];
    vec3 moved = position + (SHADOW_OFFSET * texelWidth(map, projected) + lift) * normal;
    projected = vec4(moved, 1.0) * shadowPlanes[map];
    vec3 place = projected.xyz / projected.w;
    bool isInMap = projected.w > 0.0 && all(greaterThanEqual(place.xy, vec2(0.0))) && all(lessThanEqual(place.xy, vec2(1.0)));
    return isInMap ? textureLod(shadowMaps[map], place, 0.0) : 1.0;
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
