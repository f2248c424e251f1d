#pragma once

#include <osgLego/model/PartGroups.h>
#include <osgLego/model/SupportColumns.h>
#include <osgLego/model/SupportedLayout.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace osgLego
{

/** Adds columns so that a layout stands layer by layer, as it is built from bottom to top.
 *
 * Small groups of hanging parts are submodels, which are attached from above: they are left out. While any of
 * the other parts up to a layer fall, a column is added below the largest group of them, or below one of the next two:
 * where it is seen least or, if parts still fall then, at the place of several after which the fewest fall. If no
 * column helps, the next layer follows.
 *
 * Usage:
 *
 *     LayerColumns columns(layout, 60, 0.1, isCancelled);
 *     if (!columns.run()) ... // cancelled, or there would be too many columns
 *     const SupportedLayout& changed = columns.getLayout();
 *
 * One thread, which uses all threads that oneTBB gives it. */
class LayerColumns
{
public:
    /** @param mostHanging parts of a group that is left out.
     * @param mostAdded cells of columns, as a share of those of the layout.
     * @param isCancelled is kept as a reference; may be empty. */
    LayerColumns(const SupportedLayout& layout, std::size_t mostHanging, double mostAdded,
                 const std::function<bool()>& isCancelled);

    /** @return false if it was cancelled, or if there would be too many columns. */
    bool run();

    const SupportedLayout& getLayout() const { return _layout; }

private:
    using PartList = std::vector<std::uint32_t>;

    bool standUpTo(int layer);
    bool addBelow(const PartList& group, int layer, std::size_t numFalling, bool& isAdded);
    bool findFalling(const SupportedLayout& layout, int layer, PartList& falling) const;

    SupportedLayout _layout;
    std::size_t _mostHanging;
    const std::function<bool()>& _isCancelled;
    std::size_t _mostCells;
};

} // namespace osgLego
