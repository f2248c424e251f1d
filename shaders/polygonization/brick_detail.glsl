// What the surface of a brick is part of.

const uint FACE = 0u;
const uint STUD_WALL = 1u;
const uint STUD_DISK = 2u;

const uint INSIDE = 1u << 11;

// For its joints and its variation: the part (2 bits), the axis of a face (2), whether it is the upper one (1), the open
// sides of the brick (6), INSIDE where the inner side is seen (1), and a number that is the brick's own (16).
uint detailOf(uvec3 brick, uint part, int axis, bool upper)
{
    uint number = brick.x * 0x9e3779b1u ^ (brick.y & 0xffffu) * 0x85ebca77u;
    number = (number ^ number >> 15) * 0x2c1b3c6du;
    return part | uint(axis) << 2 | uint(upper) << 4 | (brick.y >> 16 & 63u) << 5 | (number ^ number >> 12) << 16;
}

// The axes of a face, by which it winds counter-clockwise.
ivec2 axesOf(int axis, bool upper)
{
    return ivec2(axis + (upper ? 1 : 2), axis + (upper ? 2 : 1)) % 3;
}

// Of the cells beside a face, along both of its axes, those that are filled.
uint filledBeside(uint openSides, ivec2 axes)
{
    return ~(openSides >> (2 * axes.x)) & 3u | (~(openSides >> (2 * axes.y)) & 3u) << 2;
}
