#include <osgLego/search/BestLayout.h>

#include <osgLego/layout/PartColors.h>
#include <osgLego/search/LayoutCosts.h>

#include <cstddef>
#include <limits>
#include <tuple>

namespace osgLego
{

void BestLayout::limit(const PartMap& map)
{
    _limits = computeFigures(map);
}

void BestLayout::add(const PartMap& map)
{
    const std::int64_t cost = computeCost(map);
    if (_map && cost >= _cost) return;
    _map.emplace(map);
    _cost = cost;
}

void BestLayout::restore(PartMap& map)
{
    if (_map && _cost < computeCost(map)) map.swap(*_map);
}

LayoutFigures BestLayout::computeFigures(const PartMap& map) const
{
    return computeLayoutFigures(map.getLattice().getProblem(), collectParts(map, _sizes));
}

std::int64_t BestLayout::computeCost(const PartMap& map) const
{
    const LayoutFigures figures = computeFigures(map);
    const auto rank = [](const LayoutFigures& layout)
    { return std::tuple(layout.components, layout.unavailable, layout.parts); };
    if (_limits && rank(figures) > rank(*_limits)) return std::numeric_limits<std::int64_t>::max();
    const auto times = [](std::size_t count, std::int64_t cost) { return static_cast<std::int64_t>(count) * cost; };
    return times(figures.parts, LayoutCosts::PART) + times(figures.stackedLength, 2 * _seamCost) +
           times(figures.components, LayoutCosts::COMPONENT) + times(figures.unavailable, LayoutCosts::UNMADE);
}

} // namespace osgLego
