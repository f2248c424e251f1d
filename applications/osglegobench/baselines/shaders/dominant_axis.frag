// Dominant axis: every fragment updates the running mean of its cell, and appends the cell to the list if it is the first.
#extension GL_ARB_shader_image_load_store : require
#extension GL_ARB_shader_storage_buffer_object : require
#extension GL_ARB_shading_language_420pack : require

flat in int axis;
noperspective in float place;
noperspective in vec2 surfaceCoordinate;
noperspective in vec3 surfaceTint;
flat in float level;

#ifdef IS_CONSERVATIVE
flat in vec3 lowest;
flat in vec3 highest;
flat in vec2 slope;
#endif

layout(binding = 0, r32ui) coherent uniform uimage3D volume; // mean colour; fragments in the highest byte; 0: empty
layout(std430, binding = 0) buffer Counters { uint numCells; uint numPoints; };
layout(std430, binding = 1) buffer Cells { uint cells[]; };

uniform ivec3 gridSize;

#include "passes/surface_color.glsl"

void listCell(ivec3 cell)
{
    uint number = atomicAdd(numCells, 1u);
    // Cells beyond the capacity are counted, too: the count is the required capacity.
    if (number >= uint(cells.length())) return;
    uvec3 place = uvec3(cell);
    uvec3 size = uvec3(gridSize);
    cells[number] = place.x + size.x * (place.y + size.y * place.z);
}

void join(ivec3 cell, vec3 color)
{
    const float MOST = 255.0;
    // Bounded, since the result of an atomic operation in a helper invocation is undefined.
    const int MOST_ATTEMPTS = 1024;
    uint expected = 0u;
    uint wanted = packUnorm4x8(vec4(color, 1.0 / MOST));
    for (int attempt = 0; attempt < MOST_ATTEMPTS; ++attempt)
    {
        uint found = imageAtomicCompSwap(volume, cell, expected, wanted);
        if (found == expected) break;
        expected = found;
        vec4 mean = unpackUnorm4x8(found);
        float count = round(mean.a * MOST);
        wanted = packUnorm4x8(vec4((mean.rgb * count + color) / (count + 1.0), min(count + 1.0, MOST) / MOST));
    }
    if (expected == 0u) listCell(cell);
}

void main()
{
    ivec3 cell;
    int first;
    int last;
    int across = (axis + 1) % 3;
    int up = (axis + 2) % 3;
    cell[across] = int(gl_FragCoord.x);
    cell[up] = int(gl_FragCoord.y);
#ifdef IS_CONSERVATIVE
    // Pixels outside the triangle's bounds belong to spikes at sharp corners.
    vec2 pixel = floor(gl_FragCoord.xy);
    if (any(lessThan(highest.xy, pixel)) || any(greaterThanEqual(lowest.xy, pixel + 1.0))) discard;
    float reach = 0.5 * (abs(slope.x) + abs(slope.y));
    first = int(clamp(place - reach, lowest.z, highest.z));
    last = int(clamp(place + reach, lowest.z, highest.z));
#else
    first = int(place);
    last = first;
#endif
    vec3 color = surfaceColor(clamp(surfaceTint, 0.0, 1.0), surfaceCoordinate, level);
    last = min(last, gridSize[axis] - 1);
    for (cell[axis] = first; cell[axis] <= last; ++cell[axis]) join(cell, color);
}
