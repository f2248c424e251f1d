#pragma once

#include <osgLego/StabilityReport.h>
#include <osgLego/model/SupportColumns.h>
#include <osgLego/model/SupportedLayout.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace osgLego
{

/** Adds columns below a layout that falls, until it stands.
 *
 * First, each group of falling parts that touch each other gets a column. If the model still falls, columns are added
 * one by one, each at the place after which the fewest parts fall. Finally, superfluous columns are removed.
 *
 * The layout and the report must exist as long as this object. */
class ColumnSearch
{
public:
    /** @param report that of the layout; kept up to date. */
    ColumnSearch(SupportedLayout& layout, StabilityReport& report, const std::function<bool()>& isCancelled);

    /** Add columns; some may remain even if the model falls nevertheless.
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
