// The barycentric coordinates of the point of a triangle nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
// Corners may coincide after rounding to single precision; the conditions then prevent a division by zero.
//
// The class NearestPoint does the same on the CPU with another algorithm: it finds four points of one triangle at once,
// so it divides once per triangle and avoids branches. Here every fragment has its own triangle, and most fragments
// return early. A test compares the two.
vec3 nearestPoint(vec3 p, vec3 a, vec3 b, vec3 c)
{
    vec3 ab = b - a;
    vec3 ac = c - a;
    float d1 = dot(ab, p - a);
    float d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return vec3(1.0, 0.0, 0.0);

    float d3 = dot(ab, p - b);
    float d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return vec3(0.0, 1.0, 0.0);

    float shareC = d1 * d4 - d3 * d2;
    if (shareC <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
    {
        float v = d1 / (d1 - d3);
        return vec3(1.0 - v, v, 0.0);
    }

    float d5 = dot(ab, p - c);
    float d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return vec3(0.0, 0.0, 1.0);

    float shareB = d5 * d2 - d1 * d6;
    if (shareB <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
    {
        float w = d2 / (d2 - d6);
        return vec3(1.0 - w, 0.0, w);
    }

    float shareA = d3 * d6 - d5 * d4;
    if (shareA <= 0.0 && d4 >= d3 && d5 >= d6 && (d4 > d3 || d5 > d6))
    {
        float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return vec3(0.0, 1.0 - w, w);
    }

    float sum = shareA + shareB + shareC;
    return sum > 0.0 ? vec3(shareA, shareB, shareC) / sum : vec3(1.0, 0.0, 0.0);
}
