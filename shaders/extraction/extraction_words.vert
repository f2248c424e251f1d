// Extraction, the blocks: one vertex for each block, with its sixteen words of occupancy.

layout(location = 0) in uvec4 blockWords0;
layout(location = 1) in uvec4 blockWords1;
layout(location = 2) in uvec4 blockWords2;
layout(location = 3) in uvec4 blockWords3;

out Block
{
    flat int number;
    flat uvec4 words[4];
} block;

void main()
{
    block.number = gl_VertexID;
    block.words = uvec4[](blockWords0, blockWords1, blockWords2, blockWords3);
}
