// The near occlusion of the surface that a fragment shows: by the cells around its brick, and by studs on the same level.

#include "polygonization/grid_occlusion.glsl"

// A point on a face, or on a stud.
struct OccludedPoint
{
    FaceNeighbors cells;
    uint open;  // the open sides of the brick
    int axis;   // of the face
    bool isUpper;
    ivec2 axes; // along the face; the horizontal one is first
    vec2 place; // along these axes, 0 to 1
};

// The light that a stud hides from a level surface: fitted to rays, with an error of at most 0.02. The bent vector of this
// light, towards the stud and up, and its fraction of the sky. `distance` is that from the stud's axis, in cells.
vec3 hiddenByStud(float distance)
{
    float inner = distance - 0.9 * STUD_RADIUS;
    float width = min(STUD_RADIUS / distance, 1.0);
    float sine = STUD_HEIGHT * inversesqrt(STUD_HEIGHT * STUD_HEIGHT + inner * inner);
    float fraction = (width + 0.41 * pow(width, 5.0)) / 3.14159265 * sine * sine;
    return fraction * vec3(0.97 - 1.1 * fraction, 0.66 * sine, 1.0);
}

// Likewise for a stud that may be missing, with the vector along both axes and up.
vec4 hiddenByStudAt(vec2 toStud, bool isThere)
{
    if (!isThere) return vec4(0.0);
    float distance = max(length(toStud), STUD_RADIUS);
    vec3 hidden = hiddenByStud(distance);
    return vec4(hidden.x * toStud / distance, hidden.yz);
}

// The light that the studs around a point on top of a brick hide: its own, and those on the bricks beside it.
vec4 hiddenByStuds(OccludedPoint point)
{
    ivec2 sides = ivec2(greaterThan(point.place, vec2(0.5)));
    vec2 step = vec2(2 * sides - 1);
    uint near = point.cells.near;
    int upper = int(point.isUpper);
    int corner = 12 + (upper << point.axis) + (sides.x << point.axes.x) + (sides.y << point.axes.y);
    bool first = (point.open >> (2 * point.axes.x + sides.x) & 1u) == 0u &&
                 (near >> edgeBit(point.axis, upper, point.axes.x, sides.x) & 1u) == 0u;
    bool second = (point.open >> (2 * point.axes.y + sides.y) & 1u) == 0u &&
                  (near >> edgeBit(point.axis, upper, point.axes.y, sides.y) & 1u) == 0u;
    bool both = (near >> edgeBit(point.axes.x, sides.x, point.axes.y, sides.y) & 1u) != 0u && (near >> corner & 1u) == 0u;
    vec2 toOwn = 0.5 - point.place;
    return hiddenByStudAt(toOwn, true) + hiddenByStudAt(toOwn + vec2(step.x, 0.0), first) +
           hiddenByStudAt(toOwn + vec2(0.0, step.y), second) + hiddenByStudAt(toOwn + step, both);
}

// The wall of a stud sees half of the sky, in the quadrants that it faces, and some of the light from below where the brick
// ends. `outward` is the horizontal normal.
const float OPEN_BELOW = 0.29; // of a point halfway up a wall, if no brick is beside its own

vec4 wallOcclusion(OccludedPoint point, vec2 outward)
{
    vec4 weights = max(vec4(-outward.x - outward.y, outward.x - outward.y, outward.y - outward.x, outward.x + outward.y), 0.0);
    weights *= 0.5 / dot(weights, vec4(0.25));
    float visibility =
        sumQuadrants(point.cells, point.axis, point.isUpper, point.axes, 0.5 + STUD_RADIUS * outward, weights, true).x;
    vec4 sides = vec4(max(-outward, 0.0), max(outward, 0.0));
    uvec4 open = uvec4(point.open) >> uvec4(2 * point.axes, 2 * point.axes + 1) & 1u;
    float below = OPEN_BELOW * dot(sides * sides, vec4(open));
    // The mean direction of a quarter of the sphere is a vector of 1 / 3 and 2 / (3 pi).
    return vec4(visibility + below, 0.333 * outward, 0.212 - 0.5 * below);
}

// The mean open direction in eye coordinates, and the visible fraction of the sky.
vec4 nearOcclusion(Surface surface)
{
    if (brickNumber >= numNeighbors) return vec4(surface.normal, 1.0);
    uint part = detail & 3u;
    OccludedPoint point;
    point.open = detail >> 5 & 63u;
    point.axis = int(detail >> 2 & 3u);
    point.isUpper = (detail >> 4 & 1u) != 0u;
    point.cells = neighborsOf(brickNumber, point.open, 2 * point.axis + int(point.isUpper));
    point.axes = axesOf(point.axis, point.isUpper);
    point.place = part == FACE ? coordinate : 0.5 + STUD_RADIUS * (2.0 * coordinate - 1.0);
    bool isLevel = point.axis == upAxis;
    if (point.axes.x == upAxis)
    {
        point.axes = point.axes.yx;
        point.place = point.place.yx;
    }
    vec3 first = axisOf(point.axes.x);
    vec3 second = axisOf(point.axes.y);
    vec4 open;
    if (part == STUD_WALL)
        open = wallOcclusion(point, normalize(vec2(dot(eyeNormal, first), dot(eyeNormal, second))));
    else
    {
        open = sumQuadrants(point.cells, point.axis, point.isUpper, point.axes, point.place, vec4(1.0), isLevel);
        if (part == FACE && isLevel && point.isUpper)
        {
            vec4 hidden = hiddenByStuds(point);
            open -= open.x * hidden.wxyz;
        }
    }
    vec3 bent = open.y * first + open.z * second + (point.isUpper ? open.w : -open.w) * axisOf(point.axis);
    return vec4(normalize(bent + 1e-4 * surface.normal), max(open.x, 0.0));
}
