#include <osgLego/BrickModel.h>

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

std::size_t numberOf(const BrickGrid& grid, const glm::ivec3& cell)
{
    const glm::ivec3& size = grid.dimensions;
    return static_cast<std::size_t>(cell.x) +
           static_cast<std::size_t>(size.x) *
               (static_cast<std::size_t>(cell.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(cell.z));
}

} // namespace

osg::ref_ptr<const BrickModel> BrickModel::create(const BrickGrid& grid, std::vector<Brick> bricks)
{
    osg::ref_ptr<BrickModel> model = new BrickModel;
    model->_grid = grid;
    model->_bricks = std::move(bricks);
    const auto isBefore = [&grid](const Brick& a, const Brick& b)
    { return numberOf(grid, a.getCell()) < numberOf(grid, b.getCell()); };
    if (!std::is_sorted(model->_bricks.begin(), model->_bricks.end(), isBefore))
        std::sort(model->_bricks.begin(), model->_bricks.end(), isBefore);
    model->findOpenSides();
    return model;
}

osg::ref_ptr<const BrickModel> BrickModel::createComplete(const BrickGrid& grid, std::vector<Brick> bricks)
{
    osg::ref_ptr<BrickModel> model = new BrickModel;
    model->_grid = grid;
    model->_bricks = std::move(bricks);
    return model;
}

void BrickModel::findOpenSides()
{
    for (Brick& brick : _bricks)
        brick.openSides = SIDE_LEFT | SIDE_RIGHT | SIDE_FRONT | SIDE_BACK | SIDE_BOTTOM | SIDE_TOP;

    // The bricks are sorted, so the search for the upper neighbour of each only ever moves forward.
    for (int axis = 0; axis < 3; ++axis)
    {
        glm::ivec3 step(0);
        step[axis] = 1;
        auto neighbour = _bricks.begin();
        for (Brick& brick : _bricks)
        {
            const glm::ivec3 wanted = brick.getCell() + step;
            if (wanted[axis] >= _grid.dimensions[axis]) continue;
            const std::size_t number = numberOf(_grid, wanted);
            while (neighbour != _bricks.end() && numberOf(_grid, neighbour->getCell()) < number)
                ++neighbour;
            if (neighbour == _bricks.end()) break;
            if (numberOf(_grid, neighbour->getCell()) != number) continue;
            brick.openSides &= static_cast<std::uint8_t>(~(SIDE_RIGHT << (2 * axis)));
            neighbour->openSides &= static_cast<std::uint8_t>(~(SIDE_LEFT << (2 * axis)));
        }
    }
}

std::size_t BrickModel::getNumVisible() const
{
    return static_cast<std::size_t>(
        std::count_if(_bricks.begin(), _bricks.end(), [](const Brick& brick) { return brick.openSides != 0; }));
}

const Brick* BrickModel::find(const glm::ivec3& cell) const
{
    if (glm::any(glm::lessThan(cell, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(cell, _grid.dimensions)))
        return nullptr;
    const std::size_t number = numberOf(_grid, cell);
    const auto place =
        std::lower_bound(_bricks.begin(), _bricks.end(), number,
                         [this](const Brick& brick, std::size_t n) { return numberOf(_grid, brick.getCell()) < n; });
    return place != _bricks.end() && place->getCell() == cell ? &*place : nullptr;
}

} // namespace osgLego
