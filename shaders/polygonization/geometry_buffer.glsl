// The normals and the occlusion that bricks write, in addition to their light, for ambient occlusion. Directions in eye coordinates are points
// of an octahedron unfolded to the square from -1 to 1 (Meyer et al. 2010, "On Floating-Point Normal Vectors").
//
// x, y: the normal of the surface; z, w: the normal for shading, with 2 subtracted from w. Other children write their
// colour here; its alpha is never negative, which tells them from bricks.

const float UNLIT = 2.0; // value of w for a colour to be shown unchanged
// The number of bricks that nothing in the picture occludes.
const int ALONE = 255;

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

// Bricks whose occlusion is that of their grid have a negative roughness in their light, and write that occlusion, so that the
// picture only adds the light that other nodes hide: those whose number, 1 to 254, is another one.
bool hasOwnOcclusion(vec4 normals, float roughness)
{
    return isBrick(normals) && roughness < 0.0;
}

struct OwnOcclusion
{
    vec3 bent; // in eye coordinates
    float visibility;
    int number; // of the node
};

vec4 packOcclusion(OwnOcclusion own)
{
    return vec4(0.5 + 0.5 * toOctahedron(own.bent), own.visibility, float(own.number) / 255.0);
}

OwnOcclusion unpackOcclusion(vec4 texel)
{
    return OwnOcclusion(fromOctahedron(2.0 * texel.xy - 1.0), texel.z, int(255.0 * texel.w + 0.5));
}

// The number of a pixel's node; 0 if the picture has all of its occlusion.
int numberOf(vec4 normals, float roughness, vec4 texel)
{
    return hasOwnOcclusion(normals, roughness) ? unpackOcclusion(texel).number : 0;
}

vec3 surfaceNormalOf(vec4 normals)
{
    return fromOctahedron(normals.xy);
}

vec3 shadingNormalOf(vec4 normals)
{
    return fromOctahedron(normals.zw + vec2(0.0, 2.0));
}
