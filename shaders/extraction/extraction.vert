// Extraction, the vertices: one for a word of the occupancy that is not empty.

layout(location = 0) in uint vertexWord;

flat out int word;

void main()
{
    word = int(vertexWord);
}
