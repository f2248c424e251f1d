#pragma once

#include <osgLego/model/StagedColumns.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace osgLego
{

/** Adds columns so that a layout stands after the steps of a building plan after which parts fell.
 *
 * StagedColumns adds columns for each of these steps. If no column helps, the next step follows.
 *
 * Usage:
 *
 *     StepColumns columns(layout, ranks, isCancelled);
 *     columns.run({27, 96}, mostCells); // after the steps with which 27 and 96 parts are in place
 *     const SupportedLayout& changed = columns.getLayout();
 *
 * One thread, which uses all threads that oneTBB gives it. */
class StepColumns
{
public:
    /** @param ranks for each part of the layout, how many are placed before it: each number once.
     * @param isCancelled is kept as a reference; may be empty. */
    StepColumns(const SupportedLayout& layout, const std::vector<std::uint32_t>& ranks,
                const std::function<bool()>& isCancelled);

    /** Add columns, but for those with which there would be too many.
     * @param numsPlaced for each step, in their order, the number of parts in place after it.
     * @param mostCells of the layout with columns.
     * @return false if it was cancelled. */
    bool run(const std::vector<std::size_t>& numsPlaced, std::size_t mostCells);

    const SupportedLayout& getLayout() const { return _columns.getLayout(); }

private:
    StagedColumns _columns;
    std::vector<LaidPart> _order; //!< the parts of the layout in the order of placing
    const std::function<bool()>& _isCancelled;
};

} // namespace osgLego
