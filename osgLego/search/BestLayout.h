#pragma once

#include <osgLego/layout/LayoutFigures.h>
#include <osgLego/layout/PartMap.h>
#include <osgLego/layout/PartSizes.h>

#include <cstdint>
#include <optional>

namespace osgLego
{

/** The best of several layouts of the same cells: the one with the least cost of parts, stacked seams, components, and
 * parts that were never made in their colour (LayoutCosts). */
class BestLayout
{
public:
    /** @param seamCost the cost of half a unit of stacked seams. */
    BestLayout(const PartSizes& sizes, int seamCost) : _sizes(sizes), _seamCost(seamCost) {}

    /** From now on, layouts with more components than this one are worse than any other; of those with as many, those
     * with more parts that were never made; of these, those with more parts. */
    void limit(const PartMap& map);
    /** Keep a copy of a layout if it is the best so far. */
    void add(const PartMap& map);
    /** Exchange a layout for the best one, if that is better. */
    void restore(PartMap& map);

private:
    LayoutFigures computeFigures(const PartMap& map) const;
    std::int64_t computeCost(const PartMap& map) const;

    const PartSizes& _sizes;
    int _seamCost;
    std::optional<LayoutFigures> _limits;
    std::optional<PartMap> _map;
    std::int64_t _cost = 0;
};

} // namespace osgLego
