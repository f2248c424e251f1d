// Extraction, vertex shader: one vertex for each non-empty word of the occupancy.

layout(location = 0) in uint vertexWord;

flat out int word;

void main()
{
    word = int(vertexWord);
}
