#pragma once

#include <osgLego/model/StagedColumns.h>

namespace osgLego
{

/** Adds columns so that a layout stands layer by layer, as it is built from bottom to top.
 *
 * Small groups of hanging parts are submodels, which are attached from above: they are left out. StagedColumns adds
 * columns for each layer. If no column helps, the next layer follows.
 *
 * Usage:
 *
 *     LayerColumns columns(layout, 60, isCancelled);
 *     if (!columns.run(mostCells)) ... // cancelled, or there would be too many columns
 *     const SupportedLayout& changed = columns.getLayout();
 *
 * One thread, which uses all threads that oneTBB gives it. */
class LayerColumns
{
public:
    /** @param mostHanging parts of a group that is left out.
     * @param isCancelled is kept as a reference; may be empty. */
    LayerColumns(const SupportedLayout& layout, std::size_t mostHanging, const std::function<bool()>& isCancelled) :
        _columns(layout, isCancelled), _mostHanging(mostHanging)
    {
    }

    /** Add columns. If there would be too many, those that were added remain, and another call with more cells adds to
     * them.
     * @param mostCells of the layout with columns.
     * @return false if it was cancelled, or if there would be too many columns. */
    bool run(std::size_t mostCells);

    const SupportedLayout& getLayout() const { return _columns.getLayout(); }

private:
    StagedColumns _columns;
    std::size_t _mostHanging;
};

} // namespace osgLego
