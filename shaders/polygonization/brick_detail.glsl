// Packed details of a piece of a brick's surface.

const uint FACE = 0u;
const uint STUD_WALL = 1u;
const uint STUD_DISK = 2u;

const uint INSIDE = 1u << 11;

// Pack the details that joints and variation need: the part (2 bits), the axis of a face (2), whether the face is the upper
// one on this axis (1), the open sides of the brick (6), INSIDE if the surface is seen from inside (1), and a pseudo-random
// number of the brick (16).
uint detailOf(uvec3 brick, uint part, int axis, bool upper)
{
    uint number = brick.x * 0x9e3779b1u ^ (brick.y & 0xffffu) * 0x85ebca77u;
    number = (number ^ number >> 15) * 0x2c1b3c6du;
    return part | uint(axis) << 2 | uint(upper) << 4 | (brick.y >> 16 & 63u) << 5 | (number ^ number >> 12) << 16;
}

// The two axes along a face, in the order for counter-clockwise winding.
ivec2 axesOf(int axis, bool upper)
{
    return ivec2(axis + (upper ? 1 : 2), axis + (upper ? 2 : 1)) % 3;
}

// The occupied cells beside a face, along both of its axes: lower and upper of the first axis, lower and upper of the second.
uint filledBeside(uint openSides, ivec2 axes)
{
    return ~(openSides >> (2 * axes.x)) & 3u | (~(openSides >> (2 * axes.y)) & 3u) << 2;
}
