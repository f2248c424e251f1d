// Extraction, the vertices: one for a run of RUN_LENGTH cells along x; only its number counts.

flat out int run;

void main()
{
    run = gl_VertexID;
}
