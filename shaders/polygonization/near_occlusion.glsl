// The near occlusion of the surface that a fragment shows: by the cells around its brick, and by studs on the same level.

#include "polygonization/grid_occlusion.glsl"

#if !defined(DISTANT_OCCLUSION)
const bool includesNear = false;
#endif

uniform sampler2D studTable; // see createStudOcclusion
#if defined(SPLATS)
#define cellPixelWidth sceneCellWidth
#else
uniform vec2 cellPixelWidth; // in cells, at the depth z in eye coordinates: |x + y * z|
#endif

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

// Light in a band of the table, at a column and a line from 0 to 1: its fraction, and the vector along the surface, up, and along
// the normal.
vec4 studEntry(float band, float column, float line)
{
    vec2 texel = vec2(0.5 + 31.0 * clamp(column, 0.0, 1.0), 8.0 * band + 0.5 + 7.0 * clamp(line, 0.0, 1.0));
    vec4 entry = textureLod(studTable, texel / 32.0, 0.0);
    return 0.5 * vec4(entry.xy, 2.0 * entry.z - 1.0, entry.w);
}

// A point on a face, or on a stud. The members are integers since drivers that translate GLSL to SPIR-V, such as Mesa's zink,
// make invalid types of booleans in structures.
struct Receiver
{
    int isWall;   // of a stud, with a horizontal normal; 1 or 0
    int isTop;    // of a brick
    int isSide;   // of a brick
    vec2 place;   // along the axes of the face, 0 to 1; for a side of a brick, the first axis is horizontal
    vec2 outward; // the normal of a wall
    float height; // on a wall, 0 to 1
};

// The studs that may hide light, as bits like those of the cells in front of a face: for the top of a brick, its own and three
// beside it; for the wall of a stud, five beside it; for a side, three at its foot. `beside` are the cells on the brick's level.
uint studsAround(Receiver to, uint cells, uint beside)
{
    if (to.isSide != 0) return cells & 7u & ~(cells >> 3);
    uint studs = beside & ~cells;
    ivec2 sides = ivec2(greaterThan(to.isWall != 0 ? to.outward : to.place - 0.5, vec2(0.0)));
    if (to.isWall != 0) return studs & ~(QUADRANT << (4 - sides.x - 3 * sides.y));
    return to.isTop != 0 ? studs & QUADRANT << (sides.x + 3 * sides.y) : 0u;
}

// The light that studs hide: its fraction, and the vector along both axes of a face and its normal; less where cells already hide
// the light from there. `visibility` is that of quadrants. One loop finds all studs, since software renderers run all branches for
// every pixel, but loops only as often as some pixel of a group needs.
vec4 hiddenByStuds(uint studs, Receiver to, vec4 visibility)
{
    vec2 across = vec2(-to.outward.y, to.outward.x);
    vec3 up = to.isSide != 0 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 normal = to.isSide != 0 ? vec3(0.0, 0.0, 1.0) : vec3(to.outward, 0.0);
    vec4 sum = vec4(0.0);
    for (uint left = studs; left != 0u; left &= left - 1u)
    {
        int number = findLSB(left);
        int line = number * 11 >> 5; // number / 3
        vec2 step = vec2(number - 3 * line - 1, line - 1);
        vec2 direction; // to the stud, along the axes
        vec3 place;     // in the table
        vec3 along;
        if (to.isSide != 0)
        {
            direction = vec2(0.5 - to.place.x + step.x, 1.0);
            place = vec3(0.0, abs(direction.x) / 1.5, to.place.y);
            along = vec3(sign(direction.x), 0.0, 0.0);
        }
        else
        {
            direction = to.isWall != 0 ? step : 0.5 - to.place + step;
            float distance = max(length(direction), STUD_RADIUS);
            place = to.isWall != 0
                        ? vec3((number & 1) == 0 ? 2.0 : 1.0, 0.5 - 0.5 * dot(direction, to.outward) / distance, to.height)
                        : vec3(3.0, sqrt((distance - STUD_RADIUS) / (1.5 - STUD_RADIUS)), 0.5);
            along = vec3(to.isWall != 0 ? sign(dot(direction, across)) * across : direction / distance, 0.0);
        }
        vec4 hidden = studEntry(place.x, place.y, place.z);
        float share = to.isWall != 0 ? 1.0 : dot(quadrantsTowards(direction), visibility);
        // Cells hide more of the light from near the horizon, where farther studs are.
        share *= mix(1.0, share, min(2.0 * place.y, 1.0));
        sum += share * vec4(hidden.x, hidden.y * along + hidden.z * up + hidden.w * normal);
    }
    return sum;
}

// The wall of a stud sees half of the sky, in the quadrants that it faces, and some of the light from below: that of a ledge, where
// cells beside its own are open, and, without distant occlusion, that along the tops of bricks from beyond the reach of occlusion.
const float LEDGE = 0.5 - STUD_RADIUS; // from the wall to the end of the brick
const float ALONG_TOPS = 0.15;         // of the light that an infinitely long ledge would let in; fitted to rays
// The share of a ledge that is by an open side, by an open corner, and by one next to an open side; fitted to rays.
const vec3 LEDGE_SHARES = vec3(0.41, 0.2, 0.35);

// `beside` are the cells on the brick's level.
vec4 wallOcclusion(Receiver to, uint beside, Quadrants light, vec4 weights)
{
    vec4 sides = vec4(max(-to.outward, 0.0), max(to.outward, 0.0));
    vec4 open = 1.0 - vec4(uvec4(beside) >> uvec4(3u, 1u, 5u, 7u) & 1u);
    vec4 openSides = sides * sides * open;
    // Corners between two covered cells are not known (see BrickNeighbors).
    vec4 openCorners = 0.5 * weights * max(open.xzxz, open.yyww) * (1.0 - vec4(uvec4(beside) >> uvec4(0u, 2u, 6u, 8u) & 1u));
    float share = LEDGE_SHARES.x * dot(openSides, vec4(1.0)) +
                  dot(openCorners, LEDGE_SHARES.y + LEDGE_SHARES.z * (openSides.xzxz + openSides.yyww));
    float above = to.height * STUD_HEIGHT;
    float slope = above * inversesqrt(above * above + LEDGE * LEDGE);
    float below = 0.5 * slope * (includesNear ? share : mix(ALONG_TOPS, 1.0, share));
    // An open quadrant has a sum of directions of 1 / 6 outward, and 1 / (3 pi) up and to the side; a ledge, 2 / (3 pi) down.
    vec4 seen = weights * light.visibility;
    vec2 towards = vec2(seen.y + seen.w - seen.x - seen.z, seen.z + seen.w - seen.x - seen.y);
    vec2 across = towards - dot(towards, to.outward) * to.outward;
    float all = dot(seen, vec4(1.0));
    vec2 bent = (all / 6.0 + 0.8 * below) * to.outward + 0.106 * across;
    return vec4(light.sum.x + below, bent, 0.106 * all - 0.212 * slope * slope * share);
}

// The mean open direction in eye coordinates, and the visible fraction of the sky; or, if distant occlusion includes near one, what
// is to be added to it, plus 1. `shift` is the step from the surface to the place of this distant occlusion, in cells, in eye
// coordinates.
vec4 nearOcclusion(Surface surface, out vec3 shift)
{
    shift = vec3(0.0);
    float small = smoothstep(SMALL_CELLS.x, SMALL_CELLS.y, abs(cellPixelWidth.x + cellPixelWidth.y * eyePosition.z));
    bool isKnown = brickNumber < numNeighbors && small < 1.0;
    uint part = detail & 3u;
    uint open = detail >> 5 & 63u;
    int axis = int(detail >> 2 & 3u);
    int upper = int(detail >> 4 & 1u);
    bool isLevel = axis == upAxis;
    int word = isKnown ? 3 * brickNumber : 0;
    uvec3 words = uvec3(texelFetch(neighbors, word).x, texelFetch(neighbors, word + 1).x, texelFetch(neighbors, word + 2).x);
    uint cells = isKnown ? cellsInFront(words, open, axis, upper) : 0u;
    // The first of both axes that follow that of the face is the up axis.
    bool isExchanged = axesOf(axis, true).x == upAxis;
    if (isExchanged) cells = exchangeAxes(cells);
    // The axes and coordinates along lower faces are in the opposite order.
    bool isInOrder = (upper != 0) != isExchanged;
    vec3 first = isInOrder ? surface.u : surface.v;
    vec3 second = isInOrder ? surface.v : surface.u;
    Receiver to;
    to.isWall = int(part == STUD_WALL);
    to.isTop = int(part == FACE && isLevel && upper != 0);
    to.isSide = int(!isLevel);
    to.outward = to.isWall != 0 ? normalize(vec2(dot(eyeNormal, first), dot(eyeNormal, second))) : vec2(0.0);
    to.height = coordinate.y;
    vec2 place = isInOrder ? coordinate : coordinate.yx;
    to.place = part == FACE ? place : 0.5 + STUD_RADIUS * (to.isWall != 0 ? to.outward : 2.0 * place - 1.0);
    vec4 weights = to.isWall != 0 ? 2.0 * quadrantsTowards(to.outward) : vec4(1.0);
    Quadrants light = findQuadrants(cells, to.place, weights, isLevel);
    uint beside = cellsBeside(words.x, open, axis);
    vec4 sky = to.isWall != 0 ? wallOcclusion(to, beside, light, weights) : light.sum;
    if (includesNear && to.isWall == 0)
    {
        sky.x = 1.0 + light.difference;
        shift = light.shift.x * first + light.shift.y * second;
    }
    sky -= hiddenByStuds(isKnown ? studsAround(to, cells, beside) : 0u, to, light.visibility);
    vec3 bent = sky.y * first + sky.z * second + sky.w * surface.outward;
    if (brickNumber >= numNeighbors) return vec4(surface.normal, 1.0);
    return vec4(normalize(mix(bent, surface.normal, small) + 1e-4 * surface.normal),
                mix(max(sky.x, 0.0), includesNear ? 1.0 : MEAN_VISIBILITY, small));
}
