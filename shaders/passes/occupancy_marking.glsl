// Marks a cell as covered, if image stores are available; otherwise extraction_occupancy.vert finds the covered cells.
// Include this file first, since extensions must come before other code.

#ifdef GL_ARB_shader_image_load_store
#extension GL_ARB_shader_image_load_store : enable
#endif

#include "passes/occupancy.glsl"

#ifdef GL_ARB_shader_image_load_store
layout(r32ui) uniform uimageBuffer occupancy;
#endif

void markCovered(ivec3 cell)
{
#ifdef GL_ARB_shader_image_load_store
    imageAtomicOr(occupancy, wordOfCell(cell), bitOfCell(cell));
#endif
}
