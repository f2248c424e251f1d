// Extraction, the words: emits a point for each non-empty word of a block of the occupancy.

layout(points) in;
layout(points, max_vertices = 16) out;

in Block
{
    flat int number;
    flat uvec4 words[4];
} blocks[];

flat out int word; // the number of the word; captured by transform feedback

void main()
{
    for (int place = 0; place < 16; ++place)
    {
        if (blocks[0].words[place >> 2][place & 3] == 0u) continue;
        word = blocks[0].number << 4 | place;
        EmitVertex();
        EndPrimitive();
    }
}
