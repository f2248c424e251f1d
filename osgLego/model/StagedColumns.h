#pragma once

#include <osgLego/model/SupportColumns.h>
#include <osgLego/model/SupportedLayout.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace osgLego
{

/** Adds columns so that a layout stands at a stage of its building, when only some parts are in place.
 *
 * While any of these parts fall, a column is added below the largest group of those that fall, or below one of the next
 * two: where it is seen least or, if parts still fall then, at the place of several after which the fewest fall. If no
 * column helps, parts continue to fall at this stage, and at others at which the same parts fall.
 *
 * Usage:
 *
 *     StagedColumns columns(layout, isCancelled);
 *     for (int layer = 0; layer < numLayers; ++layer)
 *         if (!columns.standWith([=](const LaidParts& parts) { return selectUpTo(layer, parts); }, mostCells)) ...
 *     const SupportedLayout& changed = columns.getLayout();
 *
 * One thread, which uses all threads that oneTBB gives it. */
class StagedColumns
{
public:
    /** The parts in place, as indices in ascending order. Columns that were added are among `parts`. */
    using Select = std::function<std::vector<std::uint32_t>(const LaidParts& parts)>;

    /** @param isCancelled is kept as a reference; may be empty. */
    StagedColumns(const SupportedLayout& layout, const std::function<bool()>& isCancelled) :
        _layout(layout), _isCancelled(isCancelled)
    {
    }

    /** Add columns until none of the selected parts fall, or until no column helps.
     * @param mostCells of the layout with columns.
     * @return false if it was cancelled, or if a column would have too many cells, which is not added. */
    bool standWith(const Select& select, std::size_t mostCells);

    const SupportedLayout& getLayout() const { return _layout; }

private:
    using PartList = std::vector<std::uint32_t>;

    bool findBelow(const PartList& group, const Select& select, std::size_t numFalling,
                   std::optional<SupportColumn>& best) const;
    bool findFalling(const SupportedLayout& layout, const Select& select, PartList& falling) const;

    SupportedLayout _layout;
    std::set<PartList> _hopeless; //!< falling parts of the layout that no column of at most `_mostCells` helped
    std::size_t _mostCells = 0;
    const std::function<bool()>& _isCancelled;
};

} // namespace osgLego
