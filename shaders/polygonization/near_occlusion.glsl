// The near occlusion of the surface that a fragment shows: by the cells around its brick, and by studs on the same level.

#include "polygonization/grid_occlusion.glsl"

#if !defined(DISTANT_OCCLUSION)
const bool includesNear = false;
#endif

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

uniform sampler2D studTable; // see createStudOcclusion
uniform vec2 cellPixelWidth; // in cells, at the depth z in eye coordinates: |x + y * z|

// The mean visibility of bricks, from views of two models. Bricks as small as pixels show it: each pixel shows a part of another
// brick, and would flicker when the camera moves.
const float MEAN_VISIBILITY = 0.8;
const vec2 SMALL_CELLS = vec2(0.4, 1.0); // pixel widths in cells, from which on the mean is shown in part, and alone

// The weights of quadrants for what is in a direction along a face.
vec4 quadrantsTowards(vec2 direction)
{
    vec4 weights = max(vec4(-direction.x - direction.y, direction.x - direction.y, direction.y - direction.x,
                            direction.x + direction.y), 0.0);
    return weights / dot(weights, vec4(1.0));
}

bool isOpen(OccludedPoint point, int axis, int upper)
{
    return (point.open >> (2 * axis + upper) & 1u) != 0u;
}

bool isBesideEdge(OccludedPoint point, int axis, int upper, int other, int otherUpper)
{
    return (point.cells.near >> edgeBit(axis, upper, other, otherUpper) & 1u) != 0u;
}

bool isAtCorner(OccludedPoint point, int upper, ivec2 sides)
{
    return (point.cells.near >> (12 + (upper << point.axis) + (sides.x << point.axes.x) + (sides.y << point.axes.y)) & 1u) != 0u;
}

// Whether a stud is beside that of a brick, in front of one of its sides. `point` is on top of the brick.
bool hasStudBeside(OccludedPoint point, int axis, int upper)
{
    return !isOpen(point, axis, upper) && !isBesideEdge(point, point.axis, 1, axis, upper);
}

bool hasStudAtCorner(OccludedPoint point, ivec2 sides)
{
    return isBesideEdge(point, point.axes.x, sides.x, point.axes.y, sides.y) && !isAtCorner(point, 1, sides);
}

// Light in a band of the table, at a column and a line from 0 to 1: its fraction, and the vector along the surface, up, and along
// the normal.
vec4 studEntry(float band, float column, float line)
{
    vec2 texel = vec2(0.5 + 31.0 * clamp(column, 0.0, 1.0), 8.0 * band + 0.5 + 7.0 * clamp(line, 0.0, 1.0));
    vec4 entry = textureLod(studTable, texel / 32.0, 0.0);
    return 0.5 * vec4(entry.xy, 2.0 * entry.z - 1.0, entry.w);
}

// A surface from which studs hide light.
struct Receiver
{
    bool isWall;  // of a stud, with a horizontal normal
    bool isTop;   // of a brick
    bool isSide;  // of a brick
    vec2 outward; // the normal of a wall
    float height; // on a wall, 0 to 1
};

// The studs that may hide light, as bits. For the top of a brick: its own, and three beside it, in the direction of `sides`; for the
// wall of a stud, five beside it; for a side, three at its foot.
uint studsAround(OccludedPoint point, Receiver to, ivec2 sides)
{
    int upper = int(point.isUpper);
    if (to.isSide)
        return uint(isAtCorner(point, upper, ivec2(0)) && !isBesideEdge(point, point.axis, upper, point.axes.x, 0)) << 1 |
               uint(isBesideEdge(point, point.axis, upper, point.axes.y, 0)) << 2 |
               uint(isAtCorner(point, upper, ivec2(1, 0)) && !isBesideEdge(point, point.axis, upper, point.axes.x, 1)) << 3;
    if (!to.isWall && !to.isTop) return 0u;
    uint studs = uint(to.isTop) | uint(hasStudBeside(point, point.axes.x, sides.x)) << 1 |
                 uint(hasStudBeside(point, point.axes.y, sides.y)) << 2 | uint(hasStudAtCorner(point, sides)) << 3;
    if (to.isWall)
        studs |= uint(hasStudAtCorner(point, ivec2(sides.x, 1 - sides.y))) << 4 |
                 uint(hasStudAtCorner(point, ivec2(1 - sides.x, sides.y))) << 5;
    return studs;
}

// The light that studs hide: its fraction, and the vector along both axes of a face and its normal; less where cells already hide
// the light from there. `visibility` is that of quadrants. One loop finds all studs, since software renderers run all branches for
// every pixel, but loops only as often as some pixel of a group needs.
vec4 hiddenByStuds(OccludedPoint point, Receiver to, vec4 visibility)
{
    vec2 side = to.isWall ? to.outward : point.place - 0.5;
    ivec2 sides = ivec2(greaterThan(side, vec2(0.0)));
    vec2 across = vec2(-to.outward.y, to.outward.x);
    vec3 up = to.isSide ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 normal = to.isSide ? vec3(0.0, 0.0, 1.0) : vec3(to.outward, 0.0);
    vec4 sum = vec4(0.0);
    for (uint left = studsAround(point, to, sides); left != 0u; left &= left - 1u)
    {
        int number = findLSB(left);
        vec2 direction; // to the stud, along the axes
        vec3 place;     // in the table
        vec3 along;
        if (to.isSide)
        {
            direction = vec2(float(number) - 1.5 - point.place.x, 1.0);
            place = vec3(0.0, abs(direction.x) / 1.5, point.place.y);
            along = vec3(sign(direction.x), 0.0, 0.0);
        }
        else
        {
            bvec2 beside = bvec2((number & 1) != 0 || number == 4, number >= 2);
            ivec2 other = ivec2(number == 5 ? 1 - sides.x : sides.x, number == 4 ? 1 - sides.y : sides.y);
            vec2 step = vec2(2 * other - 1) * vec2(beside);
            direction = to.isWall ? step : 0.5 - point.place + step;
            float distance = max(length(direction), STUD_RADIUS);
            place = to.isWall ? vec3(beside == bvec2(true) ? 2.0 : 1.0, 0.5 - 0.5 * dot(direction, to.outward) / distance, to.height)
                              : vec3(3.0, (distance - STUD_RADIUS) / (1.5 - STUD_RADIUS), 0.5);
            along = vec3(to.isWall ? sign(dot(direction, across)) * across : direction / distance, 0.0);
        }
        vec4 hidden = studEntry(place.x, place.y, place.z);
        float share = to.isWall ? 1.0 : dot(quadrantsTowards(direction), visibility);
        sum += share * vec4(hidden.x, hidden.y * along + hidden.z * up + hidden.w * normal);
    }
    return sum;
}

// The wall of a stud sees half of the sky, in the quadrants that it faces, and some of the light from below where the brick
// ends. `outward` is the horizontal normal; `height` that of the point on the wall, 0 to 1.
const float OPEN_BELOW = 0.6;                // of an infinitely high wall, if no brick is beside its own; fitted to rays
const float LEDGE = 0.5 - STUD_RADIUS; // from the wall to the end of the brick

vec4 wallOcclusion(OccludedPoint point, Quadrants light, vec4 weights, vec2 outward, float height)
{
    vec4 sides = vec4(max(-outward, 0.0), max(outward, 0.0));
    uvec4 open = uvec4(point.open) >> uvec4(2 * point.axes, 2 * point.axes + 1) & 1u;
    float above = height * STUD_HEIGHT;
    float below = OPEN_BELOW * above * inversesqrt(above * above + LEDGE * LEDGE) * dot(sides * sides, vec4(open));
    // An open quadrant has a sum of directions of 1 / 6 outward, and 1 / (3 pi) up and to the side.
    vec4 seen = weights * light.visibility;
    vec2 towards = vec2(seen.y + seen.w - seen.x - seen.z, seen.z + seen.w - seen.x - seen.y);
    vec2 across = towards - dot(towards, outward) * outward;
    float all = dot(seen, vec4(1.0));
    vec2 bent = (all / 6.0 + 0.8 * below) * outward + 0.106 * across;
    return vec4(light.sum.x + below, bent, 0.106 * all - 0.5 * below);
}

// The mean open direction in eye coordinates, and the visible fraction of the sky; or, if distant occlusion includes near one, what is
// to be added to it, plus 1. `shift` is the step from the surface to the place of this distant occlusion, in cells along the model's
// axes.
vec4 nearOcclusion(Surface surface, out vec3 shift)
{
    shift = vec3(0.0);
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
    Receiver to;
    to.isWall = part == STUD_WALL;
    to.isTop = part == FACE && isLevel && point.isUpper;
    to.isSide = !isLevel;
    to.outward = to.isWall ? normalize(vec2(dot(eyeNormal, first), dot(eyeNormal, second))) : vec2(0.0);
    to.height = coordinate.y;
    if (to.isWall) point.place = 0.5 + STUD_RADIUS * to.outward;
    vec4 weights = to.isWall ? 2.0 * quadrantsTowards(to.outward) : vec4(1.0);
    Quadrants light = findQuadrants(point.cells, point.axis, point.isUpper, point.axes, point.place, weights, isLevel);
    vec4 open = to.isWall ? wallOcclusion(point, light, weights, to.outward, to.height) : light.sum;
    if (includesNear && !to.isWall)
    {
        open.x = 1.0 + light.difference;
        shift[point.axes.x] = light.shift.x;
        shift[point.axes.y] = light.shift.y;
    }
    open -= hiddenByStuds(point, to, light.visibility);
    vec3 bent = open.y * first + open.z * second + (point.isUpper ? open.w : -open.w) * axisOf(point.axis);
    float small = smoothstep(SMALL_CELLS.x, SMALL_CELLS.y, abs(cellPixelWidth.x + cellPixelWidth.y * eyePosition.z));
    return vec4(normalize(mix(bent, surface.normal, small) + 1e-4 * surface.normal),
                mix(max(open.x, 0.0), includesNear ? 1.0 : MEAN_VISIBILITY, small));
}
