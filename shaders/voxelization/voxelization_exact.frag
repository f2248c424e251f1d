// Exact voxelization, the colours: every covering triangle contributes the colour of its point nearest the cell's
// centre, weighted by its area inside the cell. The point is found on the source triangle, not on the fine one, so that
// subdivision does not affect the colours. Blending sums up weighted colours, and weights in alpha; extraction divides.

#include "passes/occupancy_marking.glsl"

flat in float weight;
flat in uint sourceTriangle;
flat in uvec2 packedCell;

uniform usamplerBuffer sourceVertices; // two texels per vertex: position, triangle | coordinate, colour and level

#include "passes/surface_color.glsl"
#include "passes/voxel_color.glsl"
#include "voxelization/nearest_point.glsl"

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
    vec3 center = vec3(cell + firstCell) + 0.5;
    vec3 weights =
        nearestPoint(vec3(0.0), positions[0] - center, positions[1] - center, positions[2] - center);
    vec3 color = surfaceColor(weights.x * colorsAndLevels[0].rgb + weights.y * colorsAndLevels[1].rgb +
                                  weights.z * colorsAndLevels[2].rgb,
                              weights.x * coordinates[0] + weights.y * coordinates[1] + weights.z * coordinates[2],
                              colorsAndLevels[0].a);
    gl_FragColor = weightedColor(color, weight);
}
