// What the bricks leave for ambient occlusion, beside their light: directions of the eye's coordinates as points of an
// octahedron unfolded to the square from -1 to 1 (Meyer et al. 2010, "On Floating-Point Normal Vectors").
//
// Normals: x, y the surface's, z, w the one it is shaded by, w less 2: what is not of bricks writes its colour here, whose
// alpha is not below 0.

const float UNLIT = 2.0; // in place of w: the colour is to be shown as it is

vec2 toOctahedron(vec3 direction)
{
    vec3 place = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    if (place.z >= 0.0) return place.xy;
    return (1.0 - abs(place.yx)) * vec2(place.x < 0.0 ? -1.0 : 1.0, place.y < 0.0 ? -1.0 : 1.0);
}

vec3 fromOctahedron(vec2 place)
{
    vec3 direction = vec3(place, 1.0 - abs(place.x) - abs(place.y));
    float fold = max(-direction.z, 0.0);
    direction.x += direction.x < 0.0 ? fold : -fold;
    direction.y += direction.y < 0.0 ? fold : -fold;
    return normalize(direction);
}

vec4 packNormals(vec3 surface, vec3 shading)
{
    return vec4(toOctahedron(surface), toOctahedron(shading) - vec2(0.0, 2.0));
}

bool isBrick(vec4 normals)
{
    return normals.w < -0.5;
}

bool isUnlit(vec4 normals)
{
    return normals.w > 1.5;
}

vec3 surfaceNormalOf(vec4 normals)
{
    return fromOctahedron(normals.xy);
}

vec3 shadingNormalOf(vec4 normals)
{
    return fromOctahedron(normals.zw + vec2(0.0, 2.0));
}
