// Says of a cell that it is covered, where fragments can write anywhere; elsewhere extraction_occupancy.vert finds out.
// To be included before anything else, as extensions are.

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
