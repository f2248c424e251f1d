#include <osgLego/BrickModel.h>

#include <algorithm>
#include <numeric>

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

osg::ref_ptr<const BrickModel> BrickModel::createOfParts(const BrickGrid& grid, std::vector<Part> parts,
                                                         const std::vector<Brick>& covered)
{
    const auto isBefore = [&grid](const Part& a, const Part& b)
    { return numberOf(grid, a.getCell()) < numberOf(grid, b.getCell()); };
    std::sort(parts.begin(), parts.end(), isBefore);
    std::vector<Brick> bricks;
    std::vector<std::uint32_t> partIndices;
    for (const Part& part : parts)
        for (int z = 0; z < part.size[2]; ++z)
            for (int y = 0; y < part.size[1]; ++y)
                for (int x = 0; x < part.size[0]; ++x)
                {
                    const auto at = [](std::uint16_t first, int step)
                    { return static_cast<std::uint16_t>(first + step); };
                    bricks.push_back({{at(part.cell[0], x), at(part.cell[1], y), at(part.cell[2], z)}, part.color});
                    partIndices.push_back(static_cast<std::uint32_t>(&part - parts.data()));
                }
    std::vector<std::size_t> order(bricks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b)
              { return numberOf(grid, bricks[a].getCell()) < numberOf(grid, bricks[b].getCell()); });

    osg::ref_ptr<BrickModel> model = new BrickModel;
    model->_grid = grid;
    model->_parts = std::move(parts);
    model->_bricks.reserve(order.size());
    model->_partIndices.reserve(order.size());
    for (const std::size_t index : order)
    {
        model->_bricks.push_back(bricks[index]);
        model->_partIndices.push_back(partIndices[index]);
    }
    model->findOpenSides();
    if (!covered.empty()) model->findAdded(covered);
    return model;
}

void BrickModel::findAdded(const std::vector<Brick>& covered)
{
    // Both are sorted, so the search only ever moves forward.
    auto other = covered.begin();
    for (const Brick& brick : _bricks)
    {
        const auto number = numberOf(_grid, brick.getCell());
        while (other != covered.end() && numberOf(_grid, other->getCell()) < number)
            ++other;
        _isAdded.push_back(other == covered.end() || other->cell != brick.cell);
    }
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

const Part* BrickModel::findPart(const glm::ivec3& cell) const
{
    const Brick* brick = _parts.empty() ? nullptr : find(cell);
    return brick ? &_parts[_partIndices[static_cast<std::size_t>(brick - _bricks.data())]] : nullptr;
}

} // namespace osgLego
