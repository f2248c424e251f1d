// The area of the part of a triangle inside the unit cell. TriangleSlicer computes it on the CPU, where it cuts a triangle
// once for all its cells; here every cell is computed separately, without arrays. Tests compare both with clipping.
//
// The planes z = 0 and z = 1 cut a polygon out of the triangle. Its sides are pieces of the triangle's edges, and the
// chords in the two planes. The polygon is projected along z. Its area in the unit square is the sum of the areas below
// its sides, with x and y clamped to the square. Each of these is a continuous function of the corners, so that rounding
// changes the area no more than it moves the corners, even if a corner, an edge or a chord is on a face or an edge of
// the cell. (Stokes' theorem over the outline of the part would not do: a chord along an edge of the cell is on two
// faces, and rounding decides whether it counts for none, one or both.)

// The area in the unit square below a segment; negative if the segment runs to the left.
float areaBelow(vec2 from, vec2 to)
{
    float begin = clamp(from.x, 0.0, 1.0);
    float end = clamp(to.x, 0.0, 1.0);
    if (begin == end) return 0.0;
    float slope = (to.y - from.y) / (to.x - from.x);
    float first = from.y + slope * (begin - from.x);
    float last = to.y + slope * (end - to.x);
    float lowest = min(first, last);
    float highest = max(first, last);
    float lower = clamp(lowest, 0.0, 1.0);
    float upper = clamp(highest, 0.0, 1.0);
    // The integral of the clamped height, with respect to the height of the segment.
    float sum = 0.5 * (upper - lower) * (upper + lower) + max(highest - max(lowest, 1.0), 0.0);
    return (end - begin) * (highest > lowest ? sum / (highest - lowest) : lower);
}

// Cut an edge pq by a plane, given the heights of its ends above the plane (on its inner side), and keep the piece above
// it, from `begin` to `end`. The chord runs from the point where the triangle's outline goes below the plane (xy) to the
// point where it comes back (zw).
void cut(vec3 p, vec3 q, float heightOfP, float heightOfQ, inout vec2 begin, inout vec2 end, inout vec4 chord)
{
    if ((heightOfP < 0.0) == (heightOfQ < 0.0)) return;
    vec2 crossing = mix(p.xy, q.xy, heightOfP / (heightOfP - heightOfQ));
    if (heightOfP < 0.0)
    {
        begin = crossing;
        chord.zw = crossing;
    }
    else
    {
        end = crossing;
        chord.xy = crossing;
    }
}

float areaBelowEdge(vec3 p, vec3 q, inout vec4 lowerChord, inout vec4 upperChord)
{
    vec2 begin = p.xy;
    vec2 end = q.xy;
    cut(p, q, p.z, q.z, begin, end, lowerChord);
    cut(p, q, 1.0 - p.z, 1.0 - q.z, begin, end, upperChord);
    bool isOutside = max(p.z, q.z) < 0.0 || min(p.z, q.z) > 1.0;
    return isOutside ? 0.0 : areaBelow(begin, end);
}

// perProjected: the triangle's area, divided by the area of its projection along z.
float areaInCell(vec3 a, vec3 b, vec3 c, float perProjected)
{
    vec4 lowerChord = vec4(0.0);
    vec4 upperChord = vec4(0.0);
    float area = areaBelowEdge(a, b, lowerChord, upperChord) + areaBelowEdge(b, c, lowerChord, upperChord) +
                 areaBelowEdge(c, a, lowerChord, upperChord);
    area += areaBelow(lowerChord.xy, lowerChord.zw) + areaBelow(upperChord.xy, upperChord.zw);
    return perProjected * abs(area);
}
