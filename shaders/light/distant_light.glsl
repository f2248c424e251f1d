// The light that distant bricks hide: the fraction of the sky a + dot(b, n) from a surface with normal n. The vector has b in eye
// coordinates, and a.

// The mean open direction moves by this part of the vector b: for small occlusion, three halves (the second band of
// harmonics) times pi / 4 (the integral of its cosine across the surface) divided by 2 pi / 3 (that of the normal).
const float BEND = 0.5625;

// Include this light in a bent normal and visibility. The two parts of occlusion add up: the weight of a distant hit leaves out
// the part that near occlusion includes. `overlap` is the share of the light that near bricks hide, too, and which counts once.
void occludeFromAfar(vec4 distant, vec3 normal, float overlap, inout vec3 bent, inout float visibility)
{
    vec3 towards = distant.xyz;
    float facing = dot(towards, normal);
    visibility = clamp(visibility - max(distant.w + facing, 0.0) * mix(1.0, visibility, overlap), 0.0, 1.0);
    bent = normalize(bent - BEND * (towards - facing * normal));
}

// In eight bits, -1 to 1 are 1 to 255.
vec4 packDistant(vec4 distant)
{
    return (128.0 + 127.0 * distant) / 255.0;
}

vec4 unpackDistant(vec4 texel)
{
    return (texel * 255.0 - 128.0) / 127.0;
}
