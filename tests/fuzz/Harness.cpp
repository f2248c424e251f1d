#include "Harness.h"

#include <algorithm>
#include <stdexcept>

#include <osg/Notify>
#include <osg/ref_ptr>

namespace osgLego::fuzz
{

namespace
{

/** Discards messages. They are written, in contrast to those below the level of notices, so that mistakes in them are
 * found. */
class DiscardedNotices : public osg::NotifyHandler
{
public:
    void notify(osg::NotifySeverity, const char*) override {}
};

[[maybe_unused]] const bool areNoticesDiscarded = []
{
    osg::setNotifyHandler(new DiscardedNotices);
    return true;
}();

std::size_t numberOf(const BrickGrid& grid, const Brick& brick)
{
    const auto width = static_cast<std::size_t>(grid.dimensions.x);
    const auto depth = static_cast<std::size_t>(grid.dimensions.y);
    return brick.cell[0] + width * (brick.cell[1] + depth * brick.cell[2]);
}

bool isInside(const BrickGrid& grid, const Brick& brick)
{
    const glm::ivec3 cell = brick.getCell();
    return cell.x < grid.dimensions.x && cell.y < grid.dimensions.y && cell.z < grid.dimensions.z;
}

} // namespace

void require(bool holds, const std::string& property)
{
    if (!holds) throw std::logic_error("expected that " + property);
}

std::string_view toText(const std::uint8_t* data, std::size_t size)
{
    return size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
}

void requirePossible(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    const std::vector<Brick>& bricks = model.getBricks();
    require(std::all_of(bricks.begin(), bricks.end(), [&](const Brick& brick) { return isInside(grid, brick); }),
            "every brick is in the grid");
    const auto isNotBefore = [&](const Brick& a, const Brick& b) { return numberOf(grid, a) >= numberOf(grid, b); };
    require(std::adjacent_find(bricks.begin(), bricks.end(), isNotBefore) == bricks.end(),
            "bricks are sorted and unique");
    if (model.getParts().empty()) return;
    std::size_t numCells = 0;
    for (const Part& part : model.getParts())
        numCells += std::size_t(part.size[0]) * part.size[1] * part.size[2];
    require(numCells == bricks.size(), "the parts have as many cells as there are bricks");
}

} // namespace osgLego::fuzz
