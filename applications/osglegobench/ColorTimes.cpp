#include "ColorTimes.h"

#include "Spread.h"

#include <osgLego/flattening/SourceColors.h>
#include <osgLego/palette/ColorChoice.h>
#include <osgLego/palette/MixtureTable.h>
#include <osgLego/palette/NearestTable.h>

#include <random>
#include <utility>
#include <vector>

#include <osg/Timer>
#include <tbb/task_arena.h>

namespace osgLego
{

namespace
{

/** The spread of the milliseconds that a function takes. The first run, which may fill caches, is not counted. */
template <typename Function>
JsonValue timeOf(unsigned int numRuns, const Function& function)
{
    function();
    std::vector<double> times;
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        const osg::Timer_t start = osg::Timer::instance()->tick();
        function();
        times.push_back(osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick()));
    }
    return createSpread(std::move(times));
}

} // namespace

JsonValue measureTables(const Palette& palette, unsigned int numRuns, const std::string& name)
{
    const auto makeNearest = [&] { makeNearestTable(palette.getColors()); };
    const auto makeMixtures = [&] { makeMixtureTable(palette.getColors(), palette.getTable()); };
    tbb::task_arena oneThread(1);
    return {{"name", name},
            {"palette", palette.getColors().size()},
            {"nearest", timeOf(numRuns, makeNearest)},
            {"nearestOneThread", timeOf(numRuns, [&] { oneThread.execute(makeNearest); })},
            {"mixtures", timeOf(numRuns, makeMixtures)},
            {"mixturesOneThread", timeOf(numRuns, [&] { oneThread.execute(makeMixtures); })}};
}

JsonValue measureLargestTables(unsigned int numRuns)
{
    std::mt19937 engine(1);
    std::vector<PaletteColor> colors(Palette::MAXIMUM_COLORS);
    for (PaletteColor& color : colors)
        for (std::uint8_t& channel : color.color)
            channel = static_cast<std::uint8_t>(engine());
    std::string ignored; // the number is allowed
    return measureTables(*Palette::create(std::move(colors), ignored), numRuns, "random");
}

JsonValue measureChoice(const Palette& palette, const GridTriangles& triangles, unsigned int numRuns,
                        const std::string& name)
{
    constexpr std::size_t NUM_COLORS = 8;
    const ColorHistogram histogram = histogramOf(triangles);
    return {{"mesh", name},
            {"colors", histogram.getShares().size()},
            {"histogram", timeOf(numRuns, [&] { histogramOf(triangles); })},
            {"choice", timeOf(numRuns, [&] { chooseColors(palette, histogram, NUM_COLORS); })}};
}

} // namespace osgLego
