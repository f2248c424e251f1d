// The surface of a brick: rounded edges that form joints between bricks, a relief on the stud, and a slight variation from
// brick to brick. All of it is averaged over the pixel: slopes are summed, and their variance is added to the roughness.
// Lengths are in cell widths.

in vec3 eyePosition;
in vec3 eyeNormal;
in vec2 coordinate;
flat in uint color;
flat in uint detail;

uniform vec3 cellProportions; // the cell's edge lengths, divided by its width
uniform int upAxis;
uniform float variation;    // 1: as much as real bricks differ; 0: none
uniform float roughness;    // perceptual: the square root of the microfacets' slope
uniform float reliefHeight; // height of the relief's highest point, in radii of the stud's disk; 0: no relief
uniform sampler2D reliefMap; // slopes along u and v for a height of 1, and their mean square

const float EDGE = 0.045;       // the width of a rounded edge; 0.36 mm of 8 mm
const float EDGE_SLOPE = 0.9;   // the slope at its outer end
const float GAP = 0.014;        // half the gap between two bricks, 0.1 mm, which light does not reach
const float GAP_DARKNESS = 0.75;
const float TILT = 0.006;       // tilt of faces, which are never perfectly flat
const float SHADE = 0.03;
const float DISK_RADIUS = 0.3;
const float STUD_HEIGHT = 0.2125;
const uint FACE = 0u;
const uint STUD_WALL = 1u;

struct Surface
{
    vec3 color;
    vec3 normal;    // the geometric normal of the face or stud
    vec3 shading;   // the normal used for shading, with edges, relief and tilt
    float openness; // 1; less in the gap of a joint
    float roughness;
};

// The combined effect of edges and relief within the pixel.
struct Bend
{
    vec2 slope;
    float variance;
    float openness;
};

// The integral of a rounded edge's slope, from the edge to a given distance; beyond the edge the profile is mirrored.
float sumOfSlopes(float place)
{
    float t = min(abs(place), EDGE);
    return EDGE_SLOPE * (t - 0.5 * t * t / EDGE);
}

float sumOfSquares(float place)
{
    float t = min(abs(place), EDGE);
    return sign(place) * EDGE_SLOPE * EDGE_SLOPE * (t - t * t / EDGE + t * t * t / (3.0 * EDGE * EDGE));
}

// The mean slope of one edge, its variance, and the visible part of the gap behind it, over a pixel of the given width. If
// the edge is the brick's last, the surface ends there; at a silhouette the pixel's centre may be beyond it.
vec3 edgeAt(float place, float width, bool isFilled)
{
    float first = place - 0.5 * width;
    float last = place + 0.5 * width;
    if (!isFilled)
    {
        first = max(first, 0.0);
        last = max(last, first + 0.25 * width);
        width = last - first;
    }
    float slope = (sumOfSlopes(last) - sumOfSlopes(first)) / width;
    float square = (sumOfSquares(last) - sumOfSquares(first)) / width;
    float gap = isFilled ? (clamp(last, -GAP, GAP) - clamp(first, -GAP, GAP)) / width : 0.0;
    return vec3(slope, max(square - slope * slope, 0.0), gap);
}

float widthOf(float value)
{
    return max(length(vec2(dFdx(value), dFdy(value))), 1e-5);
}

Bend bendFace(vec2 place, vec2 size, vec2 width, uint filled)
{
    vec3 left = edgeAt(place.x, width.x, (filled & 1u) != 0u);
    vec3 right = edgeAt(size.x - place.x, width.x, (filled & 2u) != 0u);
    vec3 lower = edgeAt(place.y, width.y, (filled & 4u) != 0u);
    vec3 upper = edgeAt(size.y - place.y, width.y, (filled & 8u) != 0u);
    // A pixel wider than half a brick also covers edges of other bricks, which are not known here: the slopes of opposite
    // sides cancel out; for the rest, the mean over the whole brick is used.
    vec2 near = clamp(2.0 - 2.0 * width / size, 0.0, 1.0);
    vec2 joints = vec2((filled & 1u) + (filled >> 1 & 1u), (filled >> 2 & 1u) + (filled >> 3 & 1u));
    vec2 variance = mix(EDGE_SLOPE * EDGE_SLOPE * EDGE * 2.0 / 3.0 / size, vec2(left.y + right.y, lower.y + upper.y), near);
    vec2 gap = mix(GAP * joints / size, vec2(left.z + right.z, lower.z + upper.z), near);
    return Bend(vec2(right.x - left.x, upper.x - lower.x) * near, variance.x + variance.y,
                1.0 - GAP_DARKNESS * min(gap.x + gap.y, 1.0));
}

// The wall of a stud; heights are measured upwards, towards the rim.
Bend bendWall(float height, float width)
{
    vec3 rim = edgeAt(STUD_HEIGHT - height, width, false);
    vec3 foot = edgeAt(height, width, true);
    return Bend(vec2(0.0, rim.x), rim.y, 1.0 - GAP_DARKNESS * foot.z);
}

Bend bendDisk(vec2 place, float width)
{
    float radius = length(place);
    vec3 rim = edgeAt(DISK_RADIUS - radius, width, false);
    vec4 relief = texture(reliefMap, 0.5 + 0.5 * place / DISK_RADIUS);
    vec2 slope = -reliefHeight * relief.xy;
    float square = reliefHeight * reliefHeight * relief.z;
    return Bend(slope + rim.x * place / max(radius, 1e-5), rim.y + max(square - dot(slope, slope), 0.0), 1.0);
}

// Pseudo-random numbers of the brick, from -1 to 1.
vec3 ownNumbers()
{
    uint number = detail >> 16;
    return vec3(number & 31u, number >> 5 & 31u, number >> 10 & 63u) / vec3(15.5, 15.5, 31.5) - 1.0;
}

// The direction of an axis of the grid in eye coordinates.
vec3 axisOf(int axis)
{
    return normalize(gl_NormalMatrix[axis]);
}

Surface surfaceHere()
{
    uint part = detail & 3u;
    int axis = int(detail >> 2 & 3u);
    bool isUpper = (detail >> 4 & 1u) != 0u;
    int axisU = (axis + (isUpper ? 1 : 2)) % 3;
    int axisV = (axis + (isUpper ? 2 : 1)) % 3;
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 normal = normalize(side * eyeNormal);
    vec3 u = side * axisOf(axisU);
    vec3 v = side * axisOf(axisV);
    vec2 size = vec2(cellProportions[axisU], cellProportions[axisV]);
    vec2 place = coordinate * size;
    vec2 width = vec2(widthOf(place.x), widthOf(place.y));
    float wide = max(width.x, width.y);
    vec3 own = variation * ownNumbers() * clamp(2.0 - 2.0 * wide, 0.0, 1.0);

    Bend bend;
    if (part == FACE)
        bend = bendFace(place, size, width, detail >> 5 & 15u);
    else if (part == STUD_WALL)
    {
        bend = bendWall(coordinate.y * STUD_HEIGHT, widthOf(coordinate.y * STUD_HEIGHT));
        v = side * axisOf(upAxis);
    }
    else
    {
        vec2 center = DISK_RADIUS * (2.0 * coordinate - 1.0);
        bend = bendDisk(center, max(widthOf(center.x), widthOf(center.y)));
    }
#if !defined(JOINTS)
    if (part == FACE) bend = Bend(vec2(0.0), 0.0, 1.0);
#endif
    if (part != STUD_WALL) bend.slope += TILT * own.xy;

    Surface surface;
    surface.color = clamp(unpackUnorm4x8(color).rgb * (1.0 + SHADE * own.z), 0.0, 1.0);
    surface.normal = normal;
    surface.shading = normalize(normal + bend.slope.x * u + bend.slope.y * v);
    surface.openness = bend.openness;
    // The fourth power of the roughness is the mean square of the microfacets' slopes; the variance of the surface is added.
    surface.roughness = min(sqrt(sqrt(pow(roughness, 4.0) + bend.variance)), 1.0);
    return surface;
}
