#include "Goals.h"

#include "Contenders.h"
#include "FrameResults.h"
#include "MemoryResults.h"
#include "VoxelizeResults.h"

#include <algorithm>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

/** Against how many times its own median one contender's is held. */
struct SpeedGoal
{
    const char* slow;
    const char* fast; // null: the exact method
    double bound;
    std::vector<unsigned int> resolutions; // empty: all
};

const ContenderResult* findExact(const MeshResult& mesh)
{
    const ContenderResult* node = mesh.find(EXACT_NODE);
    return node ? node : mesh.find(EXACT_PASSES);
}

std::string describe(const MeshResult& mesh)
{
    return fmt::format("{} at {}", mesh.mesh, mesh.resolution);
}

Goal makeGoal(const std::string& text, const std::string& where, double figure, double bound, bool isAtMost,
              const std::string& unit = {})
{
    return {text, where, figure, bound, isAtMost, isAtMost ? figure <= bound : figure >= bound, unit};
}

void checkSpeed(const MeshResult& mesh, const SpeedGoal& goal, std::vector<Goal>& goals)
{
    const auto& resolutions = goal.resolutions;
    if (!resolutions.empty() && std::find(resolutions.begin(), resolutions.end(), mesh.resolution) == resolutions.end())
        return;
    const ContenderResult* slow = mesh.find(goal.slow);
    const ContenderResult* fast = goal.fast ? mesh.find(goal.fast) : findExact(mesh);
    if (!slow || !fast) return;
    goals.push_back(makeGoal(fmt::format("{} / {}", slow->contender, fast->contender), describe(mesh),
                             slow->time.median / fast->time.median, goal.bound, false));
}

/** Peeling layers costs what the triangles cost, again and again: more is wanted where there are many. */
double findPassalisBound(const MeshResult& mesh)
{
    return mesh.mesh.starts_with("dragon") ? 5.0 : 1.5;
}

/** What leaks may be faster, as long as exactness costs no more than twice its time. */
void checkDominantAxis(const MeshResult& mesh, std::vector<Goal>& goals)
{
    const ContenderResult* exact = findExact(mesh);
    const ContenderResult* dominant = mesh.find(DOMINANT_AXIS);
    if (!exact || !dominant) return;
    Goal goal =
        makeGoal(fmt::format("{} / {}, {} tunnels", exact->contender, dominant->contender, exact->quality.numTunnels),
                 describe(mesh), exact->time.median / dominant->time.median, 2.0, true);
    goal.isReached = goal.isReached && exact->quality.numTunnels == 0;
    goals.push_back(goal);
}

void checkDoubling(const VoxelizeResults& results, const MeshResult& mesh, std::vector<Goal>& goals)
{
    constexpr unsigned int FROM = 64;
    constexpr unsigned int TO = 512;
    if (mesh.resolution < FROM || 2 * mesh.resolution > TO) return;
    const MeshResult* twice = results.find(mesh.mesh, 2 * mesh.resolution);
    const ContenderResult* before = findExact(mesh);
    const ContenderResult* after = twice ? findExact(*twice) : nullptr;
    if (!before || !after) return;
    goals.push_back(makeGoal(fmt::format("{}, twice the resolution", before->contender),
                             fmt::format("{}, {} to {}", mesh.mesh, mesh.resolution, twice->resolution),
                             after->time.median / before->time.median, 4.5, true));
}

/** Bricks drawn as they are now, over every face and stud drawn; the picture may not become another. */
Goal checkComparison(const FrameRow& row)
{
    const bool isSame = row.comparison.difference.isSame();
    Goal goal = makeGoal(
        fmt::format("reference / present, {}, from {}, {} picture", row.look, row.view, isSame ? "same" : "another"),
        fmt::format("{} at {}", row.mesh, row.resolution), row.comparison.getRatio(), 4.0, false);
    goal.isReached = goal.isReached && isSame;
    return goal;
}

void checkUnchanged(const FrameResults& results, const UnchangedFrames& frames, std::vector<Goal>& goals)
{
    const std::string drawn = fmt::format("{}, {}, nothing changing: ", frames.name, frames.look);
    const auto add = [&](const std::string& what, std::size_t figure, std::size_t bound)
    {
        goals.push_back(makeGoal(drawn + what, results.unchangedMesh, static_cast<double>(figure),
                                 static_cast<double>(bound), true, "times"));
    };
    add("legolizations", frames.numPasses, 0);
    add("waits for the renderer", frames.numWaits, 0);
    // What any node of OSG's costs in a frame is not the bricks'.
    add("allocations, a box of OSG's as the goal", frames.numAllocations, results.unchanged.front().numAllocations);
}

/** What grows with the volume grows by eight where the resolution doubles, what grows with the surface by four. */
void checkGrowth(const MemoryResults& results, const MemoryRow& half, const MemoryRow& whole, std::vector<Goal>& goals)
{
    constexpr double BOUND = 4.5;
    if (half.device != whole.device || 2 * half.resolution != whole.resolution || !half.footprint || !whole.footprint)
        return;
    const auto add = [&](const char* what, double before, double after)
    {
        goals.push_back(makeGoal(fmt::format("{}, twice the resolution, device={}", what, whole.device),
                                 fmt::format("{}, {} to {}", results.mesh, half.resolution, whole.resolution),
                                 after / before, BOUND, true));
    };
    add("largest buffer or picture of GL", half.footprint->largestGl, whole.footprint->largestGl);
    add("largest block of main memory", half.footprint->largestBlock, whole.footprint->largestBlock);
}

} // namespace

std::string Goal::getFigureText() const
{
    if (unit.empty()) return fmt::format("{:.2f}", figure);
    return fmt::format("{:.0f} {}", figure, unit);
}

std::string Goal::getBoundText() const
{
    return fmt::format("{} {}{}{}", isAtMost ? "<=" : ">=", bound, unit.empty() ? "" : " ", unit);
}

std::vector<Goal> checkGoals(const VoxelizeResults& results)
{
    std::vector<Goal> goals;
    for (const MeshResult& mesh : results.meshes)
    {
        checkSpeed(mesh, {POINTS_PROJECTED, nullptr, 3.0, {}}, goals);
        checkSpeed(mesh, {PASSALIS, nullptr, findPassalisBound(mesh), {64, 128}}, goals);
        checkDominantAxis(mesh, goals);
        checkSpeed(mesh, {PLAIN_LOOP, EXACT_CPU, 2.0, {128, 256}}, goals);
        checkSpeed(mesh, {OPENVDB, nullptr, 20.0, {}}, goals);
        checkSpeed(mesh, {OPENVDB_NARROW, nullptr, 20.0, {}}, goals);
        checkDoubling(results, mesh, goals);
    }
    return goals;
}

std::vector<Goal> checkGoals(const FrameResults& results)
{
    std::vector<Goal> goals;
    for (const FrameRow& row : results.rows)
        goals.push_back(checkComparison(row));
    for (const UnchangedFrames& frames : results.unchanged)
        if (frames.hasGoal) checkUnchanged(results, frames, goals);
    return goals;
}

std::vector<Goal> checkGoals(const MemoryResults& results)
{
    constexpr double BOUND = 2048.0;
    std::vector<Goal> goals;
    for (const MemoryRow& row : results.rows)
        if (row.footprint)
            goals.push_back(makeGoal(fmt::format("memory of both sides, device={}", row.device),
                                     fmt::format("{} at {}", results.mesh, row.resolution), row.footprint->getSum(),
                                     BOUND, true, "MiB"));
    for (const MemoryRow& row : results.rows)
        for (const MemoryRow& larger : results.rows)
            checkGrowth(results, row, larger, goals);
    return goals;
}

} // namespace osgLego
