#include <osgLego/design/SurfaceReference.h>

#include <osgLego/layout/CellFill.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>

#include <array>
#include <cmath>
#include <iterator>
#include <string>

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

} // namespace

SurfaceReference::SurfaceReference(const BrickModel& cells)
{
    std::vector<Entry> entries;
    entries.reserve(cells.getBricks().size());
    for (const Brick& brick : cells.getBricks())
    {
        const glm::dvec3 middle = findMiddle(cells.getGrid(), brick);
        entries.emplace_back(Place(middle.x, middle.y, middle.z), _colors.size());
        _colors.push_back(toCieLab(brick.color));
    }
    _places = Tree(entries); // packed, which is faster than one by one
}

SurfaceDifference SurfaceReference::compare(const BrickModel& model) const
{
    const osg::ref_ptr<const BrickModel> outside = fillCavities(model);
    const BrickGrid& grid = model.getGrid();
    const glm::dvec3 areas = grid.cellSize.x * grid.cellSize.y * grid.cellSize.z / grid.cellSize;
    double area = 0.0;
    double squares = 0.0;
    double colors = 0.0;
    for (const Brick& brick : outside->getBricks())
    {
        if (brick.openSides == 0) continue;
        const glm::dvec3 color = toCieLab(brick.color);
        for (const Side& side : SIDES)
        {
            if (!(brick.openSides & side.side)) continue;
            glm::dvec3 middle = findMiddle(grid, brick);
            middle[side.axis] += side.offset * grid.cellSize[side.axis];
            const Place place(middle.x, middle.y, middle.z);
            Entry nearest;
            _places.query(boost::geometry::index::nearest(place, 1), &nearest);
            area += areas[side.axis];
            squares += areas[side.axis] * boost::geometry::comparable_distance(place, nearest.first);
            colors += areas[side.axis] * ciede2000(color, _colors[nearest.second]);
        }
    }
    return {std::sqrt(squares / area), colors / area};
}

} // namespace osgLego
