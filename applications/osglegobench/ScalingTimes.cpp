#include "ScalingTimes.h"

#include "Spread.h"

#include <osgLego/CpuLegolizer.h>

#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include <oneapi/tbb/global_control.h>

namespace osgLego
{

namespace
{

constexpr double LEAST_RATIO = 1.7;

double measureSeconds(const osg::Node& node, const LegoSettings& settings, std::size_t numThreads)
{
    using Clock = std::chrono::steady_clock;
    const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, numThreads);
    const Clock::time_point start = Clock::now();
    if (!legolizeOnCpu(node, settings)) throw std::runtime_error("there are no bricks");
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

JsonValue measureScaling(const MeshSource& mesh, const std::string& text, unsigned int numRuns)
{
    const osg::ref_ptr<osg::Node> node = readMesh(mesh);
    LegoSettings settings;
    std::string error;
    if (!LegoSettings::parse(text + (mesh.upAxis == UpAxis::Y ? ",up=y" : ",up=z"), settings, error))
        throw std::runtime_error(error);
    std::vector<double> one;
    std::vector<double> two;
    std::vector<double> ratios;
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        one.push_back(measureSeconds(*node, settings, 1));
        two.push_back(measureSeconds(*node, settings, 2));
        ratios.push_back(one.back() / two.back());
    }
    JsonValue row{{"mesh", mesh.name},
                  {"settings", text},
                  {"one", createSpread(std::move(one))},
                  {"two", createSpread(std::move(two))},
                  {"ratio", createSpread(std::move(ratios))}};
    const double ratio = row["ratio"]["median"].toNumber();
    row["goals"].append(
        {{"what", "two threads"}, {"figure", ratio}, {"goal", LEAST_RATIO}, {"reached", ratio >= LEAST_RATIO}});
    return row;
}

} // namespace osgLego
