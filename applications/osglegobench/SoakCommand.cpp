#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "ResidentMemory.h"
#include "SoakRun.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <osg/Timer>

namespace osgLego
{

namespace
{

constexpr unsigned int CHANGES_PER_REST = 10;
constexpr double GROWTH_GOAL = 0.01; // of the memory at the end of the warm-up

struct SoakOptions : BenchOptions
{
    unsigned int seconds = 600;
    unsigned int warmUp = 120; // seconds
};

/** Run, and record the memory at each rest. */
JsonValue soak(const SoakOptions& options)
{
    const osg::Timer& timer = *osg::Timer::instance();
    const osg::Timer_t start = timer.tick();
    SoakRun run;
    JsonValue rows = JsonValue::createArray();
    unsigned int numChanges = 0;
    for (double now = 0.0; now < options.seconds || rows.getElements().size() < 2;)
    {
        for (unsigned int change = 0; change < CHANGES_PER_REST; ++change)
            run.change();
        numChanges += CHANGES_PER_REST;
        run.rest();
        now = timer.delta_s(start, timer.tick());
        const double resident = readResidentMemory();
        const double heap = readHeapMemory();
        fmt::print(stderr, "{:.0f} s, {} changes: {:.1f} MiB resident, {:.1f} MiB of heap\n", now, numChanges, resident,
                   heap);
        rows.append({{"seconds", now}, {"changes", numChanges}, {"resident", resident}, {"heap", heap}});
    }
    return rows;
}

/** The relative growth of memory from the end of the warm-up to the end. */
double findGrowth(const JsonValue& rows, const char* memory, double warmUp)
{
    const std::vector<JsonValue>& all = rows.getElements();
    const auto isWarm = [warmUp](const JsonValue& row) { return row["seconds"].toNumber() >= warmUp; };
    auto first = std::find_if(all.begin(), all.end(), isWarm);
    if (first == all.end()) first = all.begin();
    return all.back()[memory].toNumber() / (*first)[memory].toNumber() - 1.0;
}

void runSoak(const SoakOptions& options)
{
    JsonValue document = createDocument("soak");
    document["rows"] = soak(options);
    for (const char* memory : {"resident", "heap"})
    {
        const double growth = findGrowth(document["rows"], memory, options.warmUp);
        document["goals"].append({{"what", fmt::format("growth of {} memory", memory)},
                                  {"figure", growth},
                                  {"goal", GROWTH_GOAL},
                                  {"reached", growth <= GROWTH_GOAL}});
    }
    if (!options.jsonFile.empty()) return options.write(document);
    for (const JsonValue& goal : document["goals"].getElements())
        fmt::print("{}: {:.2f} %, goal {:.0f} %: {}\n", goal["what"].toText(), 100.0 * goal["figure"].toNumber(),
                   100.0 * GROWTH_GOAL, goal["reached"].toBoolean() ? "reached" : "MISSED");
}

} // namespace

void addSoakCommand(BenchCommandLine& commands)
{
    BenchCommand command =
        commands.add("soak", "The memory of nodes and viewers that change at random for a long time");
    const auto options = std::make_shared<SoakOptions>();
    command.addNumber("--seconds", options->seconds, "Duration (600)", 1u, 1000000u);
    command.addNumber("--warm-up", options->warmUp, "Seconds until memory is compared (120)", 0u, 1000000u);
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (the growth on standard output)",
                    "FILE");
    command.setRun([options] { runSoak(*options); });
}

} // namespace osgLego
