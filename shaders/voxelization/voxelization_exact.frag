// Exact voxelization, the colours: every covering triangle speaks for the point of it nearest the cell's centre, with
// the weight of its area inside the cell. The source triangle is asked, not the fine one, so that subdivision leaves no
// trace. Blending adds up weighted colours, and weights in alpha; extraction divides.

#include "passes/occupancy_marking.glsl"

flat in float weight;
flat in uint sourceTriangle;
flat in uvec2 packedCell;

uniform usamplerBuffer sourceVertices; // two texels a vertex: position, triangle | coordinate, colour and level

#include "passes/surface_color.glsl"

// The barycentric coordinates of the point of a triangle nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
// Corners may coincide, once they are rounded to floats: no edge is asked that has no length.
vec3 nearestPoint(vec3 p, vec3 a, vec3 b, vec3 c)
{
    vec3 ab = b - a;
    vec3 ac = c - a;
    float d1 = dot(ab, p - a);
    float d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return vec3(1.0, 0.0, 0.0);

    float d3 = dot(ab, p - b);
    float d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return vec3(0.0, 1.0, 0.0);

    float shareC = d1 * d4 - d3 * d2;
    if (shareC <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
    {
        float v = d1 / (d1 - d3);
        return vec3(1.0 - v, v, 0.0);
    }

    float d5 = dot(ab, p - c);
    float d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return vec3(0.0, 0.0, 1.0);

    float shareB = d5 * d2 - d1 * d6;
    if (shareB <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
    {
        float w = d2 / (d2 - d6);
        return vec3(1.0 - w, 0.0, w);
    }

    float shareA = d3 * d6 - d5 * d4;
    if (shareA <= 0.0 && d4 >= d3 && d5 >= d6 && (d4 > d3 || d5 > d6))
    {
        float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return vec3(0.0, 1.0 - w, w);
    }

    float sum = shareA + shareB + shareC;
    return sum > 0.0 ? vec3(shareA, shareB, shareC) / sum : vec3(1.0, 0.0, 0.0);
}

void main()
{
    vec3 positions[3];
    vec2 coordinates[3];
    vec4 colorsAndLevels[3];
    for (int corner = 0; corner < 3; ++corner)
    {
        int texel = 6 * int(sourceTriangle) + 2 * corner;
        uvec4 rest = texelFetch(sourceVertices, texel + 1);
        positions[corner] = uintBitsToFloat(texelFetch(sourceVertices, texel).xyz);
        coordinates[corner] = uintBitsToFloat(rest.xy);
        colorsAndLevels[corner] = unpackColorAndLevel(rest.zw);
    }

    ivec3 cell = ivec3(packedCell.x & 0xffffu, packedCell.x >> 16, packedCell.y);
    markCovered(cell);
    vec3 center = vec3(cell) + 0.5;
    vec3 weights =
        nearestPoint(vec3(0.0), positions[0] - center, positions[1] - center, positions[2] - center);
    vec3 color = surfaceColor(weights.x * colorsAndLevels[0].rgb + weights.y * colorsAndLevels[1].rgb +
                                  weights.z * colorsAndLevels[2].rgb,
                              weights.x * coordinates[0] + weights.y * coordinates[1] + weights.z * coordinates[2],
                              colorsAndLevels[0].a);
    gl_FragColor = vec4(weight * color, weight);
}
