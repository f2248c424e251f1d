// Subdivision (the paper, section III-A, Algorithm 2 and Figure 3): a triangle with one, two or three edges longer than
// the limit is cut at their midpoints into two, three or four triangles. The winding is kept.

layout(triangles) in;
layout(triangle_strip, max_vertices = 12) out;

uniform float edgeLimit; // in cells

in Corner
{
    vec3 position;
    flat uint triangle;
#ifdef HAS_COLORS
    vec2 coordinate;
    vec4 colorAndLevel;
#endif
} corners[];

// Captured by transform feedback, in the order and layout of the input vertices.
out vec3 finePosition;
flat out uint fineTriangle;
#ifdef HAS_COLORS
out vec2 fineCoordinate;
flat out uvec2 fineColorAndLevel;
#endif

#include "passes/vertex_packing.glsl"

struct Vertex
{
    vec3 position;
#ifdef HAS_COLORS
    vec2 coordinate;
    vec4 colorAndLevel;
#endif
};

Vertex cornerVertex(int index)
{
#ifdef HAS_COLORS
    return Vertex(corners[index].position, corners[index].coordinate, corners[index].colorAndLevel);
#else
    return Vertex(corners[index].position);
#endif
}

Vertex midpoint(Vertex a, Vertex b)
{
#ifdef HAS_COLORS
    return Vertex(0.5 * (a.position + b.position), 0.5 * (a.coordinate + b.coordinate),
                  0.5 * (a.colorAndLevel + b.colorAndLevel));
#else
    return Vertex(0.5 * (a.position + b.position));
#endif
}

float squaredLength(Vertex a, Vertex b)
{
    vec3 edge = b.position - a.position;
    return dot(edge, edge);
}

void emitVertex(Vertex vertex)
{
    finePosition = vertex.position;
    fineTriangle = corners[0].triangle;
#ifdef HAS_COLORS
    fineCoordinate = vertex.coordinate;
    fineColorAndLevel = packColorAndLevel(vertex.colorAndLevel);
#endif
    EmitVertex();
}

void emitTriangle(Vertex a, Vertex b, Vertex c)
{
    emitVertex(a);
    emitVertex(b);
    emitVertex(c);
    EndPrimitive();
}

// Only ab is too long.
void cutOneEdge(Vertex a, Vertex b, Vertex c)
{
    Vertex ab = midpoint(a, b);
    emitTriangle(a, ab, c);
    emitTriangle(ab, b, c);
}

// ab and bc are too long; the remaining quadrilateral is cut along its shorter diagonal.
void cutTwoEdges(Vertex a, Vertex b, Vertex c)
{
    Vertex ab = midpoint(a, b);
    Vertex bc = midpoint(b, c);
    emitTriangle(ab, b, bc);
    if (squaredLength(a, bc) <= squaredLength(ab, c))
    {
        emitTriangle(a, ab, bc);
        emitTriangle(a, bc, c);
    }
    else
    {
        emitTriangle(a, ab, c);
        emitTriangle(ab, bc, c);
    }
}

void cutThreeEdges(Vertex a, Vertex b, Vertex c)
{
    Vertex ab = midpoint(a, b);
    Vertex bc = midpoint(b, c);
    Vertex ca = midpoint(c, a);
    emitTriangle(a, ab, ca);
    emitTriangle(ab, b, bc);
    emitTriangle(ca, bc, c);
    emitTriangle(ab, bc, ca);
}

void main()
{
    Vertex a = cornerVertex(0);
    Vertex b = cornerVertex(1);
    Vertex c = cornerVertex(2);
    float limit = edgeLimit * edgeLimit;
    bool ab = squaredLength(a, b) > limit;
    bool bc = squaredLength(b, c) > limit;
    bool ca = squaredLength(c, a) > limit;
    int count = int(ab) + int(bc) + int(ca);

    if (count == 0) emitTriangle(a, b, c);
    else if (count == 3) cutThreeEdges(a, b, c);
    else if (count == 1)
    {
        if (ab) cutOneEdge(a, b, c);
        else if (bc) cutOneEdge(b, c, a);
        else cutOneEdge(c, a, b);
    }
    else
    {
        if (!ca) cutTwoEdges(a, b, c);
        else if (!ab) cutTwoEdges(b, c, a);
        else cutTwoEdges(c, a, b);
    }
}
