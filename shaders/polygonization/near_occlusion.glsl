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

uniform sampler2D studTable; // see createStudOcclusion

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

// Likewise for a stud that may be missing, with the fraction, and the vector along both axes and up; less where cells already hide
// the light from there.
vec4 hiddenByStudAt(vec2 toStud, bool isThere, vec4 visibility)
{
    if (!isThere) return vec4(0.0);
    float distance = max(length(toStud), STUD_RADIUS);
    vec3 hidden = hiddenByStud(distance);
    return dot(quadrantsTowards(toStud), visibility) * vec4(hidden.z, hidden.x * toStud / distance, hidden.y);
}

// The light that the studs around a point on top of a brick hide: its own, and those on the bricks beside it.
vec4 hiddenByStuds(OccludedPoint point, vec4 visibility)
{
    ivec2 sides = ivec2(greaterThan(point.place, vec2(0.5)));
    vec2 step = vec2(2 * sides - 1);
    vec2 toOwn = 0.5 - point.place;
    return hiddenByStudAt(toOwn, true, visibility) +
           hiddenByStudAt(toOwn + vec2(step.x, 0.0), hasStudBeside(point, point.axes.x, sides.x), visibility) +
           hiddenByStudAt(toOwn + vec2(0.0, step.y), hasStudBeside(point, point.axes.y, sides.y), visibility) +
           hiddenByStudAt(toOwn + step, hasStudAtCorner(point, sides), visibility);
}

// Light in a band of the table, at a column and a line from 0 to 1: its fraction, and the vector along the surface, up, and along
// the normal.
vec4 studEntry(float band, float column, float line)
{
    vec2 texel = vec2(0.5 + 31.0 * clamp(column, 0.0, 1.0), 8.0 * band + 0.5 + 7.0 * clamp(line, 0.0, 1.0));
    vec4 entry = textureLod(studTable, texel / vec2(32.0, 24.0), 0.0);
    return 0.5 * vec4(entry.xy, 2.0 * entry.z - 1.0, entry.w);
}

// The light that studs at the foot of a side hide from it: on the brick in front and below, and on those beside that one. The
// vector is along both axes and the normal.
vec4 hiddenByStudsAtFoot(OccludedPoint point, vec4 visibility)
{
    int upper = int(point.isUpper);
    vec4 sum = vec4(0.0);
    for (int side = -1; side <= 1; ++side)
    {
        ivec2 corner = ivec2((side + 1) >> 1, 0);
        bool isThere = side == 0 ? isBesideEdge(point, point.axis, upper, point.axes.y, 0)
                                 : isAtCorner(point, upper, corner) &&
                                       !isBesideEdge(point, point.axis, upper, point.axes.x, corner.x);
        if (!isThere) continue;
        float across = 0.5 + float(side) - point.place.x;
        vec4 hidden = studEntry(0.0, abs(across) / 1.5, point.place.y);
        sum += dot(quadrantsTowards(vec2(across, 1.0)), visibility) * vec4(hidden.x, sign(across) * hidden.y, hidden.zw);
    }
    return sum;
}

// The light that studs on the bricks around a stud hide from its wall: its fraction, and the vector along both axes and up.
vec4 hiddenFromWall(OccludedPoint point, vec2 outward, float height)
{
    vec2 across = vec2(-outward.y, outward.x);
    vec4 sum = vec4(0.0);
    for (int number = 0; number < 9; ++number)
    {
        ivec2 to = ivec2(number % 3, number / 3) - 1;
        vec2 direction = normalize(vec2(to) + vec2(1e-6));
        float cosine = dot(direction, outward);
        if (to == ivec2(0) || cosine < -0.2) continue;
        ivec2 sides = to + 1 >> 1;
        bool isThere = to.y == 0   ? hasStudBeside(point, point.axes.x, sides.x)
                       : to.x == 0 ? hasStudBeside(point, point.axes.y, sides.y)
                                   : hasStudAtCorner(point, sides);
        if (!isThere) continue;
        vec4 hidden = studEntry(to.x * to.y == 0 ? 1.0 : 2.0, acos(clamp(cosine, -1.0, 1.0)) / 3.14159265, height);
        sum += vec4(hidden.x, sign(dot(direction, across)) * hidden.y * across + hidden.w * outward, hidden.z);
    }
    return sum;
}

// The wall of a stud sees half of the sky, in the quadrants that it faces, and some of the light from below where the brick
// ends. `outward` is the horizontal normal; `height` that of the point on the wall, 0 to 1.
const float OPEN_BELOW = 0.6;                // of an infinitely high wall, if no brick is beside its own; fitted to rays
const float LEDGE = 0.5 - STUD_RADIUS; // from the wall to the end of the brick

vec4 wallOcclusion(OccludedPoint point, vec2 outward, float height)
{
    vec4 weights = 2.0 * quadrantsTowards(outward);
    Quadrants light =
        findQuadrants(point.cells, point.axis, point.isUpper, point.axes, 0.5 + STUD_RADIUS * outward, weights, true);
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
    return vec4(light.sum.x + below, bent, 0.106 * all - 0.5 * below) - hiddenFromWall(point, outward, height);
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
        open = wallOcclusion(point, normalize(vec2(dot(eyeNormal, first), dot(eyeNormal, second))), coordinate.y);
    else
    {
        Quadrants light = findQuadrants(point.cells, point.axis, point.isUpper, point.axes, point.place, vec4(1.0), isLevel);
        open = light.sum;
        if (part == FACE && isLevel && point.isUpper) open -= hiddenByStuds(point, light.visibility);
        if (!isLevel) open -= hiddenByStudsAtFoot(point, light.visibility).xyzw;
    }
    vec3 bent = open.y * first + open.z * second + (point.isUpper ? open.w : -open.w) * axisOf(point.axis);
    return vec4(normalize(bent + 1e-4 * surface.normal), max(open.x, 0.0));
}
