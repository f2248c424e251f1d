#include "PartModels.h"

#include "Settings.h"

#include <osgLego/PartType.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Places random parts, one by one, in cells that are not taken. */
class RandomParts
{
public:
    RandomParts(const BrickGrid& grid, const PartFilling& filling) :
        _grid(grid), _filling(filling), _engine(filling.seed)
    {
    }

    std::vector<Part> fill()
    {
        for (int z = 0; z < _grid.dimensions.z; ++z)
            for (int y = 0; y < _grid.dimensions.y; ++y)
                for (int x = 0; x < _grid.dimensions.x; ++x)
                    if (isFree({x, y, z})) place({x, y, z});
        return _parts;
    }

private:
    bool isFree(const glm::ivec3& cell) const
    {
        for (int axis = 0; axis < 3; ++axis)
            if (cell[axis] >= _grid.dimensions[axis]) return false;
        return _filling.isCovered(cell) && !_taken.contains({cell.x, cell.y, cell.z});
    }

    template <typename Visit>
    static void forEachCell(const glm::ivec3& corner, const glm::ivec3& size, const Visit& visit)
    {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    visit(corner + glm::ivec3(x, y, z));
    }

    bool fits(const glm::ivec3& corner, const glm::ivec3& size) const
    {
        bool result = true;
        forEachCell(corner, size, [&](const glm::ivec3& cell) { result = result && isFree(cell); });
        return result;
    }

    glm::ivec3 chooseSize()
    {
        const auto [width, length] = PART_SIZES[_engine() % PART_SIZES.size()];
        const bool isTurned = _engine() % 2 == 1;
        const int up = _grid.getUpIndex();
        glm::ivec3 size(1);
        size.x = isTurned ? width : length;
        size[3 - up] = isTurned ? length : width;
        size[up] = _filling.heights[_engine() % _filling.heights.size()];
        return size;
    }

    void place(const glm::ivec3& corner)
    {
        glm::ivec3 size(1);
        for (int attempt = 0; attempt < 8; ++attempt)
        {
            const glm::ivec3 chosen = chooseSize();
            if (!fits(corner, chosen)) continue;
            size = chosen;
            break;
        }
        forEachCell(corner, size, [&](const glm::ivec3& cell) { _taken.emplace(cell.x, cell.y, cell.z); });
        Part part;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            part.cell[axis] = static_cast<std::uint16_t>(corner[static_cast<int>(axis)]);
            part.size[axis] = static_cast<std::uint8_t>(size[static_cast<int>(axis)]);
        }
        const std::size_t color = _engine() % _filling.colors.size();
        part.color = _filling.colors[color];
        part.colorCode = static_cast<std::int32_t>(color);
        _parts.push_back(part);
    }

    const BrickGrid& _grid;
    const PartFilling& _filling;
    std::mt19937 _engine;
    std::set<std::tuple<int, int, int>> _taken;
    std::vector<Part> _parts;
};

} // namespace

BrickGrid createPartGrid(const glm::ivec3& dimensions, double height, UpAxis up)
{
    BrickGrid grid;
    grid.dimensions = dimensions;
    grid.cellSize = glm::dvec3(1.0);
    grid.cellSize[up == UpAxis::Y ? 1 : 2] = height;
    grid.upAxis = up;
    return grid;
}

osg::ref_ptr<const BrickModel> createParts(const BrickGrid& grid, const PartFilling& filling)
{
    return BrickModel::createOfParts(grid, RandomParts(grid, filling).fill());
}

osg::ref_ptr<const BrickModel> createCells(const BrickModel& parts)
{
    return BrickModel::create(parts.getGrid(), parts.getBricks());
}

osg::ref_ptr<LegoNode> createStoredNode(const BrickModel& model, const std::string& settings)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
    lego->setStoredBricks(&model);
    return lego;
}

} // namespace osgLego::test
