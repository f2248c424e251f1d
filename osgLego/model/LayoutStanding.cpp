#include <osgLego/model/LayoutStanding.h>

#include <osgLego/Stability.h>

#include <utility>

namespace osgLego
{

std::optional<StabilityReport> computeStanding(const LayoutProblem& problem, const LaidParts& parts,
                                               const std::function<bool()>& isCancelled)
{
    // In a grid with the axes of the layout, a model has its parts in the same order as the layout.
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, problem.isOfPlates ? 0.4 : 1.2};
    grid.dimensions = problem.size;
    std::vector<Part> real;
    real.reserve(parts.size());
    for (const LaidPart& part : parts)
        real.push_back({part.place, part.size});
    return computeStability(*BrickModel::createOfParts(grid, std::move(real)), {BuildingBase::TABLE, isCancelled});
}

bool standsBetter(const StabilityReport& report, const StabilityReport& other)
{
    if (report.falling.size() != other.falling.size()) return report.falling.size() < other.falling.size();
    return report.margin > other.margin;
}

} // namespace osgLego
