// The surface of a brick: rounded edges that form joints between bricks, a relief on the stud, and a slight variation from
// brick to brick. If cells are joined to parts, edges and variation are those of the parts. All of it is averaged over the
// pixel: slopes are summed, and their variance is added to the roughness. Lengths are in cell widths. Without #define JOINTS,
// faces are flat; without #define RELIEF, studs have none.

#include "osgLego/BrickDimensions.h"
#include "polygonization/brick_fragment.glsl"
#if defined(LINES)
#include "polygonization/part_lines.glsl"
#endif

uniform vec3 cellProportions; // the cell's edge lengths, divided by its width
#if !defined(SPLATS) && !defined(LINES)
uniform int upAxis;
#endif
uniform float variation;    // 1: as much as real bricks differ; 0: none
uniform float roughness;    // perceptual: the square root of the microfacets' slope
#if defined(RELIEF)
uniform float reliefHeight; // height of the relief's highest point, in radii of the stud's disk
uniform sampler2D reliefMap; // slopes along u and v for a height of 1, and their mean square
#endif

const float EDGE_SLOPE = 0.9;    // the slope at the outer end of a rounded edge
const float GAP_DARKNESS = 0.5;  // fraction of the light that does not reach the gap
const float EDGE_DARKNESS = 0.5; // likewise the bottom of the groove between two rounded edges
const float TILT = 0.006;        // tilt of faces, which are never perfectly flat
const float SHADE = 0.04;
const float TOWARDS_EYE = 0.35; // for faces smaller than a pixel; see mergeFaces()
const float ROUND_WALL = 0.785; // mean of the normals of a half cylinder

struct Surface
{
    vec3 color;
    vec3 normal;    // the geometric normal of the face or stud
    vec3 u;         // the axes along the face or below the stud, in eye coordinates
    vec3 v;
    vec3 outward;   // likewise, from the face or upwards
    vec3 shading;   // the normal used for shading, with edges, relief and tilt
    float openness; // 1; less in the gap of a joint
    float roughness;
    float lift; // where shadows are looked up above the surface, in eye coordinates
#if defined(LINES)
    Drawing drawing;
#endif
    // Of a brick whose faces are smaller than a pixel:
    float merged;    // how much they are shaded as one; 0: not at all
    vec3 faces;      // their shares of the area that is seen, for each axis; negative if they point against it
    float wall;      // likewise the share of the wall of the stud
    vec3 wallNormal; // the middle of its normals
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

// Likewise the integral of the light that does not reach the gap and the groove.
float sumOfDarkness(float place)
{
    float t = min(abs(place), EDGE);
    float rest = 1.0 - t / EDGE;
    return sign(place) * (GAP_DARKNESS * min(t, GAP) + EDGE_DARKNESS * EDGE / 3.0 * (1.0 - rest * rest * rest));
}

// The mean slope of one edge, its variance, and the blocked light, over a pixel of the given width. Unless `isFilled`,
// the surface ends at the edge; at a silhouette the pixel's centre may be beyond it.
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
    float darkness = isFilled ? (sumOfDarkness(last) - sumOfDarkness(first)) / width : 0.0;
    return vec3(slope, max(square - slope * slope, 0.0), darkness);
}

// The width of a pixel in a coordinate, given the coordinate's change from pixel to pixel.
float widthOf(vec2 slopes)
{
    return max(length(slopes), 1e-5);
}

// Likewise for an edge of a cell, which is no edge of its part if `isJoined`.
vec3 edgeUnlessJoined(bool isJoined, float place, float width, bool isFilled)
{
    return isJoined ? vec3(0.0) : edgeAt(place, width, isFilled);
}

// `filled` and `joined` have bits for the sides beside the face (see sidesBeside); `lengths` are those of the part, in cells.
Bend bendFace(vec2 place, vec2 size, vec2 width, uint filled, uint joined, vec2 lengths)
{
    vec3 left = edgeUnlessJoined((joined & 1u) != 0u, place.x, width.x, (filled & 1u) != 0u);
    vec3 right = edgeUnlessJoined((joined & 2u) != 0u, size.x - place.x, width.x, (filled & 2u) != 0u);
    vec3 lower = edgeUnlessJoined((joined & 4u) != 0u, place.y, width.y, (filled & 4u) != 0u);
    vec3 upper = edgeUnlessJoined((joined & 8u) != 0u, size.y - place.y, width.y, (filled & 8u) != 0u);
    // A pixel wider than half a cell also covers edges of other cells, which are not known here: the slopes of opposite
    // sides cancel out; for variance and darkness, the mean over the whole part is used. Its ends beyond this cell count as
    // joints.
    vec2 near = clamp(2.0 - 2.0 * width / size, 0.0, 1.0);
    vec2 whole = lengths * size;
    vec2 joints = vec2((filled & 1u) + (filled >> 1 & 1u), (filled >> 2 & 1u) + (filled >> 3 & 1u));
    vec2 variance = mix(EDGE_SLOPE * EDGE_SLOPE * EDGE * 2.0 / 3.0 / whole, vec2(left.y + right.y, lower.y + upper.y), near);
    vec2 darkness = mix(sumOfDarkness(EDGE) * joints / whole, vec2(left.z + right.z, lower.z + upper.z), near);
    return Bend(vec2(right.x - left.x, upper.x - lower.x) * near, variance.x + variance.y,
                1.0 - min(darkness.x + darkness.y, 1.0));
}

// The wall of a stud; heights are measured upwards, towards the rim.
Bend bendWall(float height, float width)
{
    vec3 rim = edgeAt(STUD_HEIGHT - height, width, false);
    vec3 foot = edgeAt(height, width, true);
    return Bend(vec2(0.0, rim.x), rim.y, 1.0 - foot.z);
}

Bend bendDisk(vec2 place, float width, vec4 slopes)
{
    float radius = length(place);
    vec3 rim = edgeAt(STUD_RADIUS - radius, width, false);
    Bend bend = Bend(rim.x * place / max(radius, 1e-5), rim.y, 1.0);
#if defined(RELIEF)
    vec4 relief = textureGrad(reliefMap, 0.5 + 0.5 * place / STUD_RADIUS, slopes.xz, slopes.yw);
    vec2 slope = -reliefHeight * relief.xy;
    float square = reliefHeight * reliefHeight * relief.z;
    bend.slope += slope;
    bend.variance += max(square - dot(slope, slope), 0.0);
#endif
    return bend;
}

// Three pseudo-random numbers of the brick or the part, from -1 to 1.
vec3 ownNumbers()
{
    uint number = detail >> 16;
    return vec3(number & 31u, number >> 5 & 31u, number >> 10 & 63u) / vec3(15.5, 15.5, 31.5) - 1.0;
}

// The direction of an axis of the grid in eye coordinates.
vec3 axisOf(int axis)
{
    return normalize(normalMatrix[axis]);
}

// The mean normal, in eye coordinates, of the brick's open faces that are turned towards the eye, weighted by their projected
// areas. Its length is 1 if there is only one face, and less if there are several. Sets the shares of the faces.
vec3 meanNormal(vec3 toEye, inout Surface surface)
{
    vec3 sum = vec3(0.0);
    float area = 1e-5;
    for (int axis = 0; axis < 3; ++axis)
    {
        vec3 direction = axisOf(axis);
        float cosine = dot(direction, toEye);
        if ((detail >> (5 + 2 * axis + (cosine > 0.0 ? 1 : 0)) & 1u) == 0u) continue;
        float seen = abs(cosine) * cellProportions[(axis + 1) % 3] * cellProportions[(axis + 2) % 3];
        area += seen;
        sum += sign(cosine) * seen * direction;
        surface.faces[axis] = sign(cosine) * seen;
        if (axis != upAxis || cosine <= 0.0) continue;
        // The wall of the stud covers an equal area of the face behind it, and is round.
        float wall = min(2.0 * STUD_RADIUS * STUD_HEIGHT * sqrt(max(1.0 - cosine * cosine, 0.0)), 0.5 * seen);
        surface.wallNormal = normalize(toEye - cosine * direction + vec3(1e-5));
        surface.wall = wall;
        surface.faces[axis] -= wall;
        sum += wall * (ROUND_WALL * surface.wallNormal - direction);
    }
    surface.faces /= area;
    surface.wall /= area;
    return sum / area;
}

// Faces and studs smaller than a pixel are shaded with the mean normal of their brick. With their own normals, a crawling
// pattern would appear, because it is arbitrary which face the centre of a pixel hits. The normals of neighbouring bricks
// are not known, but their visible faces are turned towards the eye.
void mergeFaces(inout Surface surface, vec3 toEye, float wide)
{
    float share = clamp(2.0 * wide - 0.75, 0.0, 1.0);
    if (share == 0.0 || !isOutside) return;
    vec3 mean = (meanNormal(toEye, surface) + TOWARDS_EYE * toEye) / (1.0 + TOWARDS_EYE);
    float agreement = min(length(mean), 1.0);
    vec3 direction = normalize(mean);
    surface.normal = normalize(mix(surface.normal, direction, share));
    surface.shading = mix(surface.shading, direction, share);
    surface.merged = share;
    surface.roughness += share * (1.0 / (agreement * agreement) - 1.0);
    // Outside of the shadow that the brick casts on its own faces.
    surface.lift = share / length(normalMatrix[0]);
}

Surface surfaceHere(vec3 toEye)
{
    uint part = detail & 3u;
    int axis = int(detail >> 2 & 3u);
    bool isUpper = (detail >> 4 & 1u) != 0u;
    ivec2 axes = axesOf(axis, isUpper);
    float side = isOutside ? 1.0 : -1.0;
    vec3 normal = normalize(side * eyeNormal);
    vec3 u = axisOf(axes.x);
    vec3 v = axisOf(axes.y);
    vec3 outward = axisOf(axis);
    vec2 size = vec2(cellProportions[axes.x], cellProportions[axes.y]);
    vec2 place = coordinate * size;
    vec4 slopes = coordinateSlopes;
    vec2 width = vec2(widthOf(size.x * slopes.xy), widthOf(size.y * slopes.zw));
    vec2 extent = part == FACE ? size : part == STUD_DISK ? vec2(2.0 * STUD_RADIUS) : vec2(6.283 * STUD_RADIUS, STUD_HEIGHT);
    float wide = min(length(extent * slopes.xz), length(extent * slopes.yw));
    vec3 own = variation * ownNumbers() * clamp(2.0 - 2.0 * max(width.x, width.y), 0.0, 1.0);

    Surface surface;
    surface.u = u;
    surface.v = v;
    surface.outward = isUpper ? outward : -outward;
    Bend bend;
    if (part == FACE)
#if defined(JOINTS)
        bend = bendFace(place, size, width, ~sidesBeside(detail >> 5, axes), detail >> 12,
                        vec2(color >> 24 & 15u, color >> 28));
#else
        bend = Bend(vec2(0.0), 0.0, 1.0);
#endif
    else if (part == STUD_WALL)
    {
        bend = bendWall(coordinate.y * STUD_HEIGHT, widthOf(STUD_HEIGHT * slopes.zw));
        v = outward;
    }
    else
    {
        float width = 2.0 * STUD_RADIUS * max(length(slopes.xy), length(slopes.zw));
        bend = bendDisk(STUD_RADIUS * (2.0 * coordinate - 1.0), max(width, 1e-5), slopes);
    }
    if (part != STUD_WALL) bend.slope += TILT * own.xy;

    surface.color = clamp(unpackUnorm4x8(color).rgb * (1.0 + SHADE * own.z), 0.0, 1.0);
    surface.normal = normal;
    surface.shading = normal + side * (bend.slope.x * u + bend.slope.y * v);
    surface.openness = bend.openness;
    // The fourth power of the roughness is the mean square of the microfacets' slopes; the variance of the surface is added.
    surface.roughness = pow(roughness, 4.0) + bend.variance;
    surface.lift = 0.0;
    surface.merged = 0.0;
    surface.faces = vec3(0.0);
    surface.wall = 0.0;
    surface.wallNormal = normal;
    mergeFaces(surface, toEye, wide);
    surface.shading = normalize(surface.shading);
    surface.roughness = min(sqrt(sqrt(surface.roughness)), 1.0);
#if defined(LINES)
    surface.drawing = drawingHere(toEye);
    surface.color = drawnColor(surface.color, surface.drawing);
    float unfaded = isNew ? surface.roughness : max(surface.roughness, FADED_ROUGHNESS);
    surface.roughness = mix(unfaded, 1.0, surface.drawing.line);
#endif
    return surface;
}
