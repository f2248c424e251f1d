#include "Figures.h"
#include "Footprint.h"

#include <algorithm>

#include <fmt/format.h>

namespace osgLego
{

Plot measureTimes(const MeshSource& source, const std::vector<unsigned int>& resolutions,
                  const std::vector<std::string>& contenders, const BenchRuns& runs, osg::GraphicsContext& context)
{
    Plot plot{"Time over the resolution: " + source.name,
              "cells along the longest side",
              "milliseconds from triangles to bricks",
              {}};
    const ContenderList entrants = createContenders(contenders);
    const osg::ref_ptr<osg::Node> node = readMesh(source);
    for (const unsigned int resolution : resolutions)
    {
        fmt::print(stderr, "measuring {} at {}\n", source.name, resolution);
        const MeshResult result =
            measureContenders(createBenchMesh(source, *node, resolution), entrants, runs, context, false);
        for (const ContenderResult& contender : result.contenders)
            if (contender.failure.empty())
                plot.getCurve(contender.contender).points.emplace_back(resolution, contender.time.median);
    }
    return plot;
}

Plot measureFootprints(const MeshSource& source, const std::vector<unsigned int>& resolutions,
                       const std::vector<std::string>& contenders)
{
    constexpr double LEAST = 0.1; // MiB; less is noise, and 0 has no place on a logarithmic axis
    Plot plot{"Memory over the resolution: " + source.name,
              "cells along the longest side",
              fmt::format("MiB by which the peak of resident memory grows ({}: or less)", LEAST),
              {}};
    for (const auto& contender : createContenders(contenders))
        for (const unsigned int resolution : resolutions)
        {
            fmt::print(stderr, "measuring the memory of {}, {} at {}\n", contender->getName(), source.name, resolution);
            const auto megabytes = measureFootprintApart(source, resolution, contender->getName());
            if (megabytes)
                plot.getCurve(contender->getName()).points.emplace_back(resolution, std::max(*megabytes, LEAST));
        }
    return plot;
}

} // namespace osgLego
