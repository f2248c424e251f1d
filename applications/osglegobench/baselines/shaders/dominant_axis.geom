// Dominant axis: every triangle is projected along the axis of its normal's largest component, so that it covers most
// pixels.

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in vec3 position[];
in vec2 coordinate[];
in vec4 colorAndLevel[];

uniform float pictureSize; // cells, the same for both sides

flat out int axis;
noperspective out float place; // position along the axis
noperspective out vec2 surfaceCoordinate;
noperspective out vec3 surfaceTint;
flat out float level;

#ifdef IS_CONSERVATIVE
flat out vec3 lowest; // of the triangle's bounds, the last component along the axis
flat out vec3 highest;
flat out vec2 slope;  // change of the position from pixel to pixel

// A line in the plane, moved outwards by half of a square pixel, and slightly more, since GL rounds vertices to fractions
// of a pixel and can omit centres exactly on an edge.
vec3 outwardLine(vec2 from, vec2 to, float side)
{
    vec3 line = side * cross(vec3(from, 1.0), vec3(to, 1.0));
    const float REACH = 0.5 + 1.0 / 128.0;
    line.z += REACH * (abs(line.x) + abs(line.y));
    return line;
}
#endif

int findDominantAxis(vec3 normal)
{
    vec3 size = abs(normal);
    if (size.z >= size.x && size.z >= size.y) return 2;
    return size.y >= size.x ? 1 : 0;
}

void main()
{
    axis = findDominantAxis(cross(position[1] - position[0], position[2] - position[0]));
    level = colorAndLevel[0].a;
    vec3 corners[3];
    for (int corner = 0; corner < 3; ++corner)
        corners[corner] =
            vec3(position[corner][(axis + 1) % 3], position[corner][(axis + 2) % 3], position[corner][axis]);

    // Barycentric coordinates of the output vertices; the third one follows from these two.
    mat3 weights = mat3(1.0);
#ifdef IS_CONSERVATIVE
    vec3 along = corners[1] - corners[0];
    vec3 across = corners[2] - corners[0];
    float doubleArea = along.x * across.y - along.y * across.x;
    if (doubleArea == 0.0) return;
    slope = vec2(along.z * across.y - across.z * along.y, across.z * along.x - along.z * across.x) / doubleArea;
    lowest = min(corners[0], min(corners[1], corners[2]));
    highest = max(corners[0], max(corners[1], corners[2]));
    // Relative to the first corner, so that no digits are lost.
    vec2 origin = corners[0].xy;
    vec3 lines[3];
    for (int corner = 0; corner < 3; ++corner)
        lines[corner] = outwardLine(corners[corner].xy - origin, corners[(corner + 1) % 3].xy - origin,
                                    sign(doubleArea));
    for (int corner = 0; corner < 3; ++corner)
    {
        vec3 meeting = cross(lines[(corner + 2) % 3], lines[corner]);
        vec2 moved = meeting.xy / meeting.z;
        float second = (moved.x * across.y - moved.y * across.x) / doubleArea;
        float third = (along.x * moved.y - along.y * moved.x) / doubleArea;
        weights[corner] = vec3(1.0 - second - third, second, third);
    }
#endif
    for (int corner = 0; corner < 3; ++corner)
    {
        vec3 weight = weights[corner];
        vec3 moved = weight.x * corners[0] + weight.y * corners[1] + weight.z * corners[2];
        place = moved.z;
        surfaceCoordinate = weight.x * coordinate[0] + weight.y * coordinate[1] + weight.z * coordinate[2];
        surfaceTint = weight.x * colorAndLevel[0].rgb + weight.y * colorAndLevel[1].rgb + weight.z * colorAndLevel[2].rgb;
        gl_Position = vec4(2.0 * moved.xy / pictureSize - 1.0, 0.0, 1.0);
        EmitVertex();
    }
}
