// Lines at the edges of parts and studs, and faded parts (#define LINES), as in building instructions. Lines have a constant
// width in pixels, and are left out where cells are hardly wider than lines.

#include "osgLego/BrickDimensions.h"
#include "osgLego/polygonization/FadedColor.h"

#if defined(SPLATS)
#define lineWidth sceneLines.x
#define oldLineWidth sceneLines.y
#define linePixelWidth sceneLines.zw
#else
uniform int upAxis;
uniform float lineWidth;
uniform float oldLineWidth;   // of faded parts
uniform vec2 linePixelWidth; // in cells, at the depth z in eye coordinates: |x + y * z|
#endif

const float FADED_ROUGHNESS = 0.8;
const float DARK = 0.19;               // the brightness below which a part gets light lines
const vec3 DARK_LINE = vec3(0.04);
const vec3 LIGHT_LINE = vec3(0.50);
const float OLD_LINE = 0.72;           // the brightness of a line on a faded part, relative to the part
// The widths of the smallest cells with lines at the edges of parts and at those of studs, in line widths.
const float LEAST_CELL = 3.0;
const float LEAST_STUDDED = 4.5;
const float HOLLOW = 0.72;             // the brightness between the walls below a part, relative to theirs
const float STUD_STEP = 6.283185307 / float(STUD_SIDES);

float cellPixels()
{
    return 1.0 / abs(linePixelWidth.x + linePixelWidth.y * eyePosition.z);
}

// The share of a pixel that a line covers which ends at a distance, both in pixels. `distance` is that from an edge.
float coverageAt(float distance, float width)
{
    return clamp(width + 0.5 - distance, 0.0, min(width + 0.5, 1.0));
}

// The width of the line on one side of an edge: half of the line or, at a silhouette, all of it.
float widthBeside(float width, vec3 otherNormal, vec3 toEye)
{
    return dot(otherNormal, toEye) > 0.0 ? 0.5 * width : width;
}

float lineOnFace(int axis, bool isUpper, float width, vec3 toEye)
{
    ivec2 axes = axesOf(axis, isUpper);
    uint open = sidesBeside(detail >> 5, axes);
    vec2 slope = vec2(length(coordinateSlopes.xy), length(coordinateSlopes.zw)) + 1e-6;
    vec4 distances = vec4(coordinate.x, 1.0 - coordinate.x, coordinate.y, 1.0 - coordinate.y) / slope.xxyy;
    vec2 lengths = vec2(color >> 24 & 15u, color >> 28);
    // Faces seen edge-on would consist of lines alone.
    vec2 share = clamp(lengths / slope / (2.0 * width) - 0.5, 0.0, 1.0);
    float line = 0.0;
    for (int side = 0; side < 4; ++side)
    {
        uint bit = 1u << side;
        if ((detail >> 12 & bit) != 0u) continue;
        vec3 normal = normalMatrix[axes[side / 2]] * (side % 2 == 0 ? -1.0 : 1.0);
        float beside = (open & bit) != 0u ? widthBeside(width, normal, toEye) : 0.5 * width;
        line = max(line, share[side / 2] * coverageAt(distances[side], beside));
    }
    return line;
}

// The distance from the walls, tubes and pins below a part, in pixels; negative on them. Real parts are hollow there, which
// tells how many studs wide they are. `joined` has bits for the sides that the part extends beyond, `slope` are the
// changes of the coordinate per pixel.
float distanceFromWalls(uint joined, vec2 slope)
{
    vec4 sides = vec4(coordinate.x, 1.0 - coordinate.x, coordinate.y, 1.0 - coordinate.y);
    bvec4 isJoined = notEqual(uvec4(joined) & uvec4(1u, 2u, 4u, 8u), uvec4(0u));
    vec4 distances = mix((sides - WALL_THICKNESS) / slope.xxyy, vec4(1e9), isJoined);
    float nearest = min(min(distances.x, distances.y), min(distances.z, distances.w));
    for (int corner = 0; corner < 4; ++corner)
    {
        ivec2 number = ivec2(corner & 1, corner >> 1);
        bvec2 isInside = bvec2(isJoined[number.x], isJoined[2 + number.y]);
        if (!all(isInside)) continue;
        vec2 place = coordinate - vec2(number);
        float radius = length(place);
        float pixel = length(place / max(radius, 1e-5) * slope);
        nearest = min(nearest, max(radius - TUBE_RADIUS, STUD_RADIUS - radius) / pixel);
    }
    for (int side = 0; side < 4; ++side)
    {
        int across = side < 2 ? 2 : 0;
        if (!isJoined[side] || isJoined[across] || isJoined[across + 1]) continue;
        vec2 place = vec2(sides[side], 0.5 - sides[across]);
        if (side >= 2) place = place.yx;
        float radius = length(place);
        nearest = min(nearest, (radius - PIN_RADIUS) / length(place / max(radius, 1e-5) * slope));
    }
    return nearest;
}

// The part of the line around the foot of a stud that is on the face below.
float lineAroundStud(float width)
{
    vec2 place = coordinate - 0.5;
    vec2 outward = normalize(place + 1e-5);
    float gradient = length(outward.x * coordinateSlopes.xy + outward.y * coordinateSlopes.zw) + 1e-6;
    return coverageAt(abs(length(place) - STUD_RADIUS) / gradient, 0.5 * width);
}

float lineOnDisk(float width, vec3 toEye)
{
    vec2 place = 2.0 * coordinate - 1.0;
    float angle = (floor(atan(place.y, place.x) / STUD_STEP) + 0.5) * STUD_STEP;
    vec2 outward = vec2(cos(angle), sin(angle));
    vec3 normal = outward.x * normalMatrix[(upAxis + 1) % 3] + outward.y * normalMatrix[(upAxis + 2) % 3];
    float gradient = 2.0 * length(outward.x * coordinateSlopes.xy + outward.y * coordinateSlopes.zw) + 1e-6;
    float distance = (cos(0.5 * STUD_STEP) - dot(place, outward)) / gradient;
    return coverageAt(distance, widthBeside(width, normal, toEye));
}

float lineOnWall(float width, vec3 toEye)
{
    float slope = length(coordinateSlopes.zw) + 1e-6;
    float rim = coverageAt((1.0 - coordinate.y) / slope, 0.5 * width);
    float foot = coverageAt(coordinate.y / slope, 0.5 * width);
    // The silhouette: its distance follows from the angle between the normal and the direction to the eye.
    vec3 up = normalize(normalMatrix[upAxis]);
    vec3 across = normalize(toEye - dot(toEye, up) * up + 1e-5);
    float cosine = clamp(dot(normalize(eyeNormal), across), 0.0, 1.0);
    float distance = STUD_RADIUS * cellPixels() * (1.0 - sqrt(1.0 - cosine * cosine));
    return max(max(rim, foot), coverageAt(distance, width));
}

// The drawing in a pixel.
struct Drawing
{
    float line;   // the share of the pixel that lines cover
    float hollow; // the share of the rest between the walls below a part
};

Drawing drawingHere(vec3 toEye)
{
    float width = isNew ? lineWidth : oldLineWidth;
    float cell = cellPixels() / width;
    float near = clamp(cell / LEAST_CELL - 1.0, 0.0, 1.0);
    float nearStud = clamp(cell / LEAST_STUDDED - 1.0, 0.0, 1.0);
    if (width == 0.0 || near == 0.0) return Drawing(0.0, 0.0);
    uint part = detail & 3u;
    if (part == STUD_DISK) return Drawing(nearStud * lineOnDisk(width, toEye), 0.0);
    if (part == STUD_WALL) return Drawing(nearStud * lineOnWall(width, toEye), 0.0);
    int axis = int(detail >> 2 & 3u);
    bool isUpper = (detail >> 4 & 1u) != 0u;
    float line = near * lineOnFace(axis, isUpper, width, toEye);
    if (axis != upAxis) return Drawing(line, 0.0);
    if (isUpper) return Drawing(max(line, nearStud * lineAroundStud(width)), 0.0);
    vec2 slope = vec2(length(coordinateSlopes.xy), length(coordinateSlopes.zw)) + 1e-6;
    float distance = distanceFromWalls(detail >> 12, slope);
    return Drawing(max(line, nearStud * coverageAt(abs(distance), 0.5 * width)),
                   nearStud * clamp(distance + 0.5, 0.0, 1.0));
}

// The colour of a part with its drawing. `own` may vary from part to part.
vec3 drawnColor(vec3 own, Drawing drawing)
{
    vec3 shown = isNew ? own : mix(own, vec3(FADED_RED, FADED_GREEN, FADED_BLUE), FADING);
    shown *= mix(1.0, HOLLOW, drawing.hollow);
    bool isDark = dot(unpackUnorm4x8(color).rgb, vec3(0.299, 0.587, 0.114)) < DARK;
    vec3 ink = !isNew ? OLD_LINE * shown : isDark ? LIGHT_LINE : DARK_LINE;
    return mix(shown, ink, drawing.line);
}
