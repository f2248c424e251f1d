#pragma once

#include <osgLego/Stability.h>
#include <osgLego/model/SupportColumns.h>
#include <osgLego/model/SupportedLayout.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace osgLego
{

/** Adds columns below a layout that falls, until it stands.
 *
 * First, each group of parts that fall and touch each other gets a column. Where that does not help, columns are added
 * one by one, each at the place after which the fewest parts fall. At last, columns are removed without which the model
 * stands, too.
 *
 * The layout and the report must exist as long as this object. */
class ColumnSearch
{
public:
    /** @param report that of the layout; kept up to date. */
    ColumnSearch(SupportedLayout& layout, StabilityReport& report, const std::function<bool()>& isCancelled);

    /** Add columns; some may be left even if the model does not stand with them.
     * @return false if it was cancelled. */
    bool run();

private:
    bool addBelowGroups();
    bool addBest(const std::vector<std::uint32_t>& below);
    bool removeUnneeded();
    bool keepIfBetter(std::vector<SupportColumn> columns);

    SupportedLayout& _layout;
    StabilityReport& _report;
    const std::function<bool()>& _isCancelled;
    SupportedLayout _bare; // without columns
    std::vector<SupportColumn> _columns;
};

} // namespace osgLego
