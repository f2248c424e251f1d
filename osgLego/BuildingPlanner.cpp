#include <osgLego/BuildingPlanner.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace osgLego
{

osg::ref_ptr<const BuildingPlan> planBuilding(const BrickModel& model, const PlanningOptions& options)
{
    constexpr std::size_t MOST_PARTS = 10;
    if (options.isCancelled && options.isCancelled()) return nullptr;
    const std::vector<Part>& parts = model.getParts();
    const auto up = static_cast<std::size_t>(model.getGrid().getUpIndex());
    std::vector<std::uint32_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t part, std::uint32_t other)
              { return std::pair(parts[part].cell[up], part) < std::pair(parts[other].cell[up], other); });
    std::vector<BuildingStep> steps;
    for (const std::uint32_t part : order)
    {
        const bool isNext = steps.empty() || steps.back().parts.size() == MOST_PARTS ||
                            parts[steps.back().parts.back()].cell[up] != parts[part].cell[up];
        if (isNext) steps.emplace_back();
        steps.back().parts.push_back(part);
    }
    return BuildingPlan::create(parts.size(), std::move(steps));
}

} // namespace osgLego
