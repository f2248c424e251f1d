#pragma once

#include <osgLego/StabilityReport.h>
#include <osgLego/model/SupportedLayout.h>
#include <osgLego/search/LayoutOptions.h>

#include <functional>
#include <utility>

namespace osgLego
{

/** Changes a layout that falls, or has floating parts, so that it stands on a table.
 *
 * First, parts near those that fall, and near the weakest joint, are laid again with greater costs of stacked seams, so
 * that bricks cross the weak place. Then cells are added there that nobody sees. Only if the model still falls are
 * columns added below it (ColumnSearch). No change adds pieces. A layout that stands is left unchanged.
 *
 * Usage:
 *
 *     SupportedLayout layout{problem, layOut(problem, options)};
 *     if (!SupportBuilder(options).build(layout)) ... // cancelled
 *
 * The result is the same for any number of threads. */
class SupportBuilder
{
public:
    /** @param options whose `progress` is called with the fraction done of the support. */
    explicit SupportBuilder(const LayoutOptions& options) : _options(options)
    {
        std::swap(_progress, _options.progress);
    }

    /** @return false if it was cancelled. */
    bool build(SupportedLayout& layout);

private:
    bool layAgain(SupportedLayout& layout);
    bool thicken(SupportedLayout& layout);
    void reportProgress(double fraction) const;
    bool keepIfBetter(SupportedLayout& layout, SupportedLayout&& other);

    LayoutOptions _options;
    std::function<void(double)> _progress;
    StabilityReport _report; //!< of the present layout
};

} // namespace osgLego
