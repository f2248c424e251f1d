#include <osgLego/Stability.h>

#include <osgLego/stability/StabilityAnalysis.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include <osg/Timer>

namespace osgLego
{

std::optional<StabilityReport> computeStability(const BrickModel& model, const StabilityOptions& options)
{
    const osg::Timer_t start = osg::Timer::instance()->tick();
    StabilityAnalysis analysis(model, options.base, options.weights);
    analysis.setCancellation(options.isCancelled);
    std::vector<std::uint32_t> parts(model.getParts().size());
    std::iota(parts.begin(), parts.end(), 0u);
    std::optional<StabilityReport> report = analysis.solve(parts);
    if (report && options.findsTilt && !analysis.addTilt(parts, *report)) return std::nullopt;
    if (report) report->milliseconds = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    return report;
}

} // namespace osgLego
