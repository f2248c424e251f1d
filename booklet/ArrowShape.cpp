#include "ArrowShape.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

// Of a bold letter, in sizes of its font: the widest one of Arial has 0.95, and other fonts may be in use.
constexpr double LETTER_WIDTH = 1.0;
constexpr double LETTER_HEIGHT = 0.75;
constexpr double LETTER_DESCENT = 0.1; // of a Q or J below the base line
constexpr double LETTER_GAP = 0.5;     // above a tail, in widths of shafts: for the line around both

} // namespace

glm::dvec2 ArrowShape::findLetter(const BookletArrow& arrow)
{
    // A slanted shaft ends higher at one of its corners.
    const auto corners = arrow.getCorners();
    const double top = std::max(corners.front().y, corners.back().y);
    const double descent = LETTER_DESCENT * BookletArrow::LETTER_SIZE;
    return {arrow.tail.x, top + (LETTER_GAP + descent) * arrow.width};
}

ArrowShape::ArrowShape(const BookletArrow& arrow, std::size_t numCharacters)
{
    const double halo = BookletArrow::HALO * arrow.width;
    const auto corners = arrow.getCorners();
    const glm::dvec2 along = arrow.getDirection();
    const glm::dvec2 across(-along.y, along.x);
    const glm::dvec2 before = (along - across) * halo;
    const glm::dvec2 behind = (along + across) * halo;
    _pieces[0] = {corners[0] - before, corners[1] + behind, corners[5] + before, corners[6] - behind};

    // A triangle that is larger about the middle of the circle in it has its sides at an equal distance.
    const double area = 0.5 * BookletArrow::HEAD_WIDTH * BookletArrow::HEAD_LENGTH;
    const double side = glm::length(glm::dvec2(0.5 * BookletArrow::HEAD_WIDTH, BookletArrow::HEAD_LENGTH));
    const double radius = area / (0.5 * BookletArrow::HEAD_WIDTH + side);
    const glm::dvec2 middle = arrow.getNeck() + along * (radius * arrow.width);
    const auto enlarge = [&](const glm::dvec2& corner)
    { return middle + (corner - middle) * (1.0 + BookletArrow::HALO / radius); };
    _pieces[1] = {enlarge(corners[2]), enlarge(corners[3]), enlarge(corners[4]), enlarge(corners[4])};

    if (numCharacters > 0)
    {
        const double size = BookletArrow::LETTER_SIZE * arrow.width;
        const double half = 0.5 * LETTER_WIDTH * size * static_cast<double>(numCharacters);
        const BookletFrame letter{arrow.letter - glm::dvec2(half, LETTER_DESCENT * size),
                                  arrow.letter + glm::dvec2(half, LETTER_HEIGHT * size)};
        _letter = letter.addMargin(halo);
        const auto& [low, high] = *_letter;
        _pieces[2] = {low, {high.x, low.y}, high, {low.x, high.y}};
        _numPieces = 3;
    }
    _frame = {_pieces[0][0], _pieces[0][0]};
    for (std::size_t piece = 0; piece < _numPieces; ++piece)
        for (const glm::dvec2& corner : _pieces[piece])
            _frame = _frame.unite({corner, corner});
}

bool ArrowShape::touches(const ArrowShape& other) const
{
    if (areApart(_frame, other._frame)) return false;
    for (std::size_t own = 0; own < _numPieces; ++own)
        for (std::size_t piece = 0; piece < other._numPieces; ++piece)
            if (!areApart(_pieces[own], other._pieces[piece]) && !areApart(other._pieces[piece], _pieces[own]))
                return true;
    return false;
}

/** Whether a side of the first one separates both. */
bool ArrowShape::areApart(const Quadrangle& own, const Quadrangle& other)
{
    const auto measure = [](const Quadrangle& corners, const glm::dvec2& normal)
    {
        std::array<double, 4> places{};
        std::transform(corners.begin(), corners.end(), places.begin(),
                       [&normal](const glm::dvec2& corner) { return glm::dot(corner, normal); });
        const auto [low, high] = std::minmax_element(places.begin(), places.end());
        return glm::dvec2(*low, *high);
    };
    for (std::size_t corner = 0; corner < own.size(); ++corner)
    {
        const glm::dvec2 side = own[(corner + 1) % own.size()] - own[corner];
        const glm::dvec2 normal(-side.y, side.x);
        const glm::dvec2 mine = measure(own, normal);
        const glm::dvec2 others = measure(other, normal);
        if (mine.y < others.x || others.y < mine.x) return true;
    }
    return false;
}

bool ArrowShape::areApart(const BookletFrame& own, const BookletFrame& other)
{
    return own.highest.x < other.lowest.x || other.highest.x < own.lowest.x || own.highest.y < other.lowest.y ||
           other.highest.y < own.lowest.y;
}

} // namespace osgLego
