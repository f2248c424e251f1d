// Packed details of a piece of a brick's surface.

const uint FACE = 0u;
const uint STUD_WALL = 1u;
const uint STUD_DISK = 2u;

const uint INSIDE = 1u << 11;

// The two axes along a face, in the order for counter-clockwise winding.
ivec2 axesOf(int axis, bool upper)
{
    ivec2 axes = ivec2(axis + (upper ? 1 : 2), axis + (upper ? 2 : 1));
    return axes - 3 * ivec2(greaterThan(axes, ivec2(2))); // without a division
}

// Of six bits for the sides of a cell, those of the sides beside a face: lower and upper of the first axis along it, lower
// and upper of the second.
uint sidesBeside(uint sides, ivec2 axes)
{
    return (sides >> (2 * axes.x) & 3u) | (sides >> (2 * axes.y) & 3u) << 2;
}

// A pseudo-random number of 16 bits, the same for all cells of a part.
uint numberOf(uvec3 brick)
{
    uint seed = brick.x * 0x9e3779b1u ^ (brick.y & 0xffffu) * 0x85ebca77u;
    if (brick.z >> 24 != 255u) seed = (brick.z >> 24) * 0x9e3779b1u;
    seed = (seed ^ seed >> 15) * 0x2c1b3c6du;
    return (seed ^ seed >> 12) & 0xffffu;
}

// Pack the details that joints and variation need: the part of the surface (2 bits), the axis of a face (2), whether the face
// is the upper one on this axis (1), the open sides of the cell (6), INSIDE if the surface is seen from inside (1), the sides
// beside the face that are joined (4), and a pseudo-random number (16).
uint detailOf(uvec3 brick, uint part, int axis, bool upper)
{
    return part | uint(axis) << 2 | uint(upper) << 4 | (brick.y >> 16 & 63u) << 5 |
           sidesBeside(brick.y >> 22, axesOf(axis, upper)) << 12 | numberOf(brick) << 16;
}

// The length of the cell's part along an axis, in cells; nearly so for more than four.
uint lengthAlong(uvec3 brick, int axis, int up)
{
    if ((brick.y >> (22 + 2 * axis) & 3u) == 0u) return 1u;
    if (axis == up) return 3u; // a brick of cells as high as plates
    uint code = brick.y >> (axis == 0 ? 28 : 30) & 3u;
    return code == 3u ? 7u : code + 2u;
}

// The colour (24 bits), and the lengths of the cell's part along both axes of a face (4 bits each).
uint colorOf(uvec3 brick, int axis, bool upper, int up)
{
    ivec2 axes = axesOf(axis, upper);
    return (brick.z & 0xffffffu) | lengthAlong(brick, axes.x, up) << 24 | lengthAlong(brick, axes.y, up) << 28;
}
