#pragma once

#include <osgLego/Stability.h>
#include <osgLego/layout/Layout.h>
#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace osgLego
{

/** A layout, and the means by which it was made to stand. */
struct SupportedLayout
{
    LayoutProblem problem; //!< with the cells of columns
    LaidParts parts;
    bool stands = true;
    bool isLaidAgain = false;       //!< whether parts differ from those of the first layout
    std::size_t numColumns = 0;     //!< columns added below the model
    std::size_t numColumnParts = 0; //!< their parts
};

/** Makes a layout stand on a table that would fall, or parts of which float.
 *
 * First, parts near those that fall, and near the weakest joint, are laid again with greater costs of stacked seams, so
 * that bricks cross the weak place. Only if the model still falls are columns added below it, one after another, each
 * where it helps most. A layout that stands is left unchanged.
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
    explicit SupportBuilder(const LayoutOptions& options) : _options(options) {}

    /** @return false if it was cancelled. */
    bool build(SupportedLayout& layout);

private:
    bool layAgain(SupportedLayout& layout);
    bool addColumns(SupportedLayout& layout);
    bool addBestColumn(SupportedLayout& layout, const std::vector<std::uint32_t>& below);
    std::optional<StabilityReport> compute(const LayoutProblem& problem, const LaidParts& parts) const;

    LayoutOptions _options;
    StabilityReport _report; //!< of the present layout
};

} // namespace osgLego
