// Exact voxelization, the point of a triangle that determines its colour in a cell: the nearest to the cell's centre. The
// point is found on the source triangle, not on the fine one, so that subdivision does not affect the colours.

flat in uint sourceTriangle;

uniform usamplerBuffer sourceVertices; // two texels per vertex: position, triangle | coordinate, colour and level

#include "passes/surface_color.glsl"
#include "voxelization/nearest_point.glsl"

struct SurfacePoint
{
    vec3 color; // of the vertices
    vec2 coordinate;
    float level;
    vec2 lowest; // coordinate of the triangle
    vec2 highest;
};

// The centre is that of the cell in the coordinates of positions.
SurfacePoint pointInCell(vec3 center)
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
    vec3 weights =
        nearestPoint(vec3(0.0), positions[0] - center, positions[1] - center, positions[2] - center);
    return SurfacePoint(weights.x * colorsAndLevels[0].rgb + weights.y * colorsAndLevels[1].rgb +
                            weights.z * colorsAndLevels[2].rgb,
                        weights.x * coordinates[0] + weights.y * coordinates[1] + weights.z * coordinates[2],
                        colorsAndLevels[0].a, min(min(coordinates[0], coordinates[1]), coordinates[2]),
                        max(max(coordinates[0], coordinates[1]), coordinates[2]));
}

vec3 filteredColor(SurfacePoint point)
{
    return surfaceColor(point.color, point.coordinate, point.level);
}
