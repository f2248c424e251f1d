#include <osgLego/model/LayoutStanding.h>

#include <osgLego/Stability.h>

#include <utility>

namespace osgLego
{

osg::ref_ptr<const BrickModel> createStandingModel(const LayoutProblem& problem, const LaidParts& parts)
{
    // In a grid with the axes of the layout, a model has its parts in the same order as the layout.
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, problem.isOfPlates ? 0.4 : 1.2};
    grid.dimensions = problem.size;
    std::vector<Part> real;
    real.reserve(parts.size());
    for (const LaidPart& part : parts)
        real.push_back({part.place, part.size});
    return BrickModel::createOfParts(grid, std::move(real));
}

std::optional<StabilityReport> computeStanding(const LayoutProblem& problem, const LaidParts& parts,
                                               const std::function<bool()>& isCancelled)
{
    return computeStability(*createStandingModel(problem, parts), {BuildingBase::TABLE, isCancelled});
}

bool standsBetter(const StabilityReport& report, const StabilityReport& other)
{
    // Parts that may fall count as if they did.
    const std::size_t count = report.falling.size() + report.unknown.size();
    const std::size_t otherCount = other.falling.size() + other.unknown.size();
    if (count != otherCount) return count < otherCount;
    return report.margin > other.margin;
}

} // namespace osgLego
