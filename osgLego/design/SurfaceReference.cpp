// Boost.Geometry itself includes a deprecated header of Boost, which would print a note with every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS

#include <osgLego/design/SurfaceReference.h>

#include <osgLego/layout/CellFill.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

namespace
{

/** A side of a cell, as BrickSide, and the way from the middle of the cell to that of the side, in cells. */
struct Side
{
    BrickSide side;
    int axis;
    double offset;
};

constexpr std::array<Side, 6> SIDES{{{SIDE_LEFT, 0, -0.5},
                                     {SIDE_RIGHT, 0, 0.5},
                                     {SIDE_FRONT, 1, -0.5},
                                     {SIDE_BACK, 1, 0.5},
                                     {SIDE_BOTTOM, 2, -0.5},
                                     {SIDE_TOP, 2, 0.5}}};

glm::dvec3 findMiddle(const BrickGrid& grid, const Brick& brick)
{
    return grid.origin + (glm::dvec3(brick.getCell()) + 0.5) * grid.cellSize;
}

/** The cells of a model and those in its cavities, of which only outer sides are open. */
osg::ref_ptr<const BrickModel> fillCavities(const BrickModel& model)
{
    FilledCells cells;
    std::string tooMany;
    if (!fillCells(model, Fill::SOLID, 1, cells, tooMany)) return &model;
    return BrickModel::create(model.getGrid(), std::move(cells.bricks));
}

using Place = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Place>;
using Entry = std::pair<Place, std::size_t>; // and the index of its colour
using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>>;

Place toPlace(const glm::dvec3& place)
{
    return {place.x, place.y, place.z};
}

/** The side of a cell, as a flat box. @param middle of the side. @param axis of its normal. */
Box findBox(const BrickGrid& grid, const glm::dvec3& middle, int axis)
{
    glm::dvec3 half = 0.5 * grid.cellSize;
    half[axis] = 0.0;
    const glm::dvec3 lower = middle - half;
    const glm::dvec3 upper = middle + half;
    return {{lower.x, lower.y, lower.z}, {upper.x, upper.y, upper.z}};
}

/** The share of places that are farther from all sides than a distance; 0 without places. */
double findFarShare(const std::vector<Place>& places, const std::vector<Box>& sides, double distance)
{
    const boost::geometry::index::rtree<Box, boost::geometry::index::rstar<16>> tree(sides);
    const auto isFar = [&](const Place& place)
    {
        Box nearest;
        tree.query(boost::geometry::index::nearest(place, 1), &nearest);
        return boost::geometry::comparable_distance(place, nearest) > distance * distance;
    };
    const auto number = std::count_if(places.begin(), places.end(), isFar);
    return places.empty() ? 0.0 : static_cast<double>(number) / static_cast<double>(places.size());
}

/** Cells of the surface along each side of a block. */
constexpr int BLOCK = 4;

/** The blocks that have covered cells. */
osg::ref_ptr<const BrickModel> joinCells(const BrickModel& cells)
{
    BrickGrid grid = cells.getGrid();
    grid.dimensions = (grid.dimensions + BLOCK - 1) / BLOCK;
    grid.cellSize *= BLOCK;
    std::vector<Brick> blocks;
    blocks.reserve(cells.getBricks().size());
    for (Brick brick : cells.getBricks())
    {
        for (std::uint16_t& place : brick.cell)
            place = static_cast<std::uint16_t>(place / BLOCK);
        blocks.push_back(brick);
    }
    std::ranges::sort(blocks, {}, &Brick::cell);
    const auto isSame = [](const Brick& a, const Brick& b) { return a.cell == b.cell; };
    blocks.erase(std::unique(blocks.begin(), blocks.end(), isSame), blocks.end());
    return BrickModel::create(grid, std::move(blocks));
}

/** Some of the places that are seen from outside through gaps of about two blocks. */
std::vector<Place> chooseOuterPlaces(const BrickModel& cells)
{
    constexpr std::size_t MOST_PLACES = 8192;
    std::vector<Place> places;
    const osg::ref_ptr<const BrickModel> blocks = fillCavities(*joinCells(cells));
    for (const Brick& brick : cells.getBricks())
    {
        const Brick* const block = blocks->find(brick.getCell() / BLOCK);
        if (!block || block->openSides == 0) continue;
        places.push_back(toPlace(findMiddle(cells.getGrid(), brick)));
    }
    const std::size_t number = std::min(places.size(), MOST_PLACES);
    std::vector<Place> chosen;
    for (std::size_t index = 0; index < number; ++index)
        chosen.push_back(places[places.size() * index / number]);
    return chosen;
}

} // namespace

struct SurfaceReference::Places
{
    Tree all;
    std::vector<glm::dvec3> colors; // in CIELAB
    std::vector<Place> outer;
};

SurfaceReference::SurfaceReference(const BrickModel& cells)
{
    auto places = std::make_unique<Places>();
    std::vector<Entry> entries;
    entries.reserve(cells.getBricks().size());
    for (const Brick& brick : cells.getBricks())
    {
        entries.emplace_back(toPlace(findMiddle(cells.getGrid(), brick)), entries.size());
        places->colors.push_back(toCieLab(brick.color));
    }
    places->all = Tree(entries); // packed, which is faster than one by one
    places->outer = chooseOuterPlaces(cells);
    _places = std::move(places);
}

SurfaceReference::~SurfaceReference() = default;

SurfaceDifference SurfaceReference::compare(const BrickModel& model) const
{
    const osg::ref_ptr<const BrickModel> outside = fillCavities(model);
    const BrickGrid& grid = model.getGrid();
    const glm::dvec3 areas = grid.cellSize.x * grid.cellSize.y * grid.cellSize.z / grid.cellSize;
    double area = 0.0;
    double squares = 0.0;
    double colors = 0.0;
    std::vector<Box> sides;
    for (const Brick& brick : outside->getBricks())
    {
        if (brick.openSides == 0) continue;
        const glm::dvec3 color = toCieLab(brick.color);
        for (const Side& side : SIDES)
        {
            if (!(brick.openSides & side.side)) continue;
            glm::dvec3 middle = findMiddle(grid, brick);
            middle[side.axis] += side.offset * grid.cellSize[side.axis];
            sides.push_back(findBox(grid, middle, side.axis));
            Entry nearest;
            _places->all.query(boost::geometry::index::nearest(toPlace(middle), 1), &nearest);
            area += areas[side.axis];
            squares += areas[side.axis] * boost::geometry::comparable_distance(toPlace(middle), nearest.first);
            colors += areas[side.axis] * ciede2000(color, _places->colors[nearest.second]);
        }
    }
    constexpr double FAR = 1.25; // cells: the surface is at most one below a side, except in concave edges
    const double lost =
        findFarShare(_places->outer, sides, FAR * std::max({grid.cellSize.x, grid.cellSize.y, grid.cellSize.z}));
    return {std::sqrt(squares / area), colors / area, lost};
}

} // namespace osgLego
