#include "CancellationTimes.h"

#include "Spread.h"

#include <osgLego/producer/CpuProducer.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace osgLego
{

namespace
{

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr double MOST_MILLISECONDS = 50.0;

osg::ref_ptr<LegoSource> createSource(const MeshSource& mesh, const std::string& text)
{
    LegoSettings settings;
    std::string error;
    osg::ref_ptr<LegoSource> source;
    if (LegoSettings::parse(text + (mesh.upAxis == UpAxis::Y ? ",up=y" : ",up=z"), settings, error))
        source = LegoSource::create(*SceneTriangles::create(*readMesh(mesh)), settings, error);
    if (!source) throw std::runtime_error(error);
    source->revision = 1;
    return source;
}

/** The milliseconds that the bricks take if they are cancelled after `delay`, and those from then on; 0 of the latter
 * if they are made before. */
std::pair<double, double> cancelAfter(const LegoSource& source, Milliseconds delay)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    const osg::ref_ptr<CpuProducer> producer = new CpuProducer(*store, {});
    const Clock::time_point start = Clock::now();
    std::future<void> making = std::async(std::launch::async,
                                          [&]
                                          {
                                              std::string ignored;
                                              producer->getBricks(source, ignored);
                                          });
    const bool isMade = making.wait_for(delay) == std::future_status::ready;
    const Clock::time_point cancelled = Clock::now();
    producer->cancel();
    making.wait();
    const Clock::time_point end = Clock::now();
    return {Milliseconds(end - start).count(), isMade ? 0.0 : Milliseconds(end - cancelled).count()};
}

} // namespace

JsonValue measureCancellation(const MeshSource& mesh, const std::string& settings, unsigned int numRuns,
                              double mostSeconds)
{
    const osg::ref_ptr<LegoSource> source = createSource(mesh, settings);
    const double total = cancelAfter(*source, Milliseconds(1000.0 * mostSeconds)).first;
    const double most = std::min(total, 1000.0 * mostSeconds);
    std::vector<double> latencies;
    for (unsigned int run = 0; run < numRuns; ++run)
        latencies.push_back(cancelAfter(*source, Milliseconds(most * (run + 0.5) / numRuns)).second);
    JsonValue row{{"mesh", mesh.name},
                  {"settings", settings},
                  {"seconds", most / 1000.0},
                  {"latency", createSpread(std::move(latencies))}};
    const double longest = row["latency"]["maximum"].toNumber();
    row["goals"].append({{"what", "longest"},
                         {"figure", longest},
                         {"goal", MOST_MILLISECONDS},
                         {"reached", longest <= MOST_MILLISECONDS}});
    return row;
}

} // namespace osgLego
