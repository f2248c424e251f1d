#include "Goals.h"

#include "Contenders.h"

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

Goal makeGoal(const std::string& text, const std::string& where, double ratio, double bound, bool isAtMost)
{
    return {text, where, ratio, bound, isAtMost, isAtMost ? ratio <= bound : ratio >= bound};
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

} // namespace

std::string Goal::getBoundText() const
{
    return fmt::format("{} {}", isAtMost ? "<=" : ">=", bound);
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

} // namespace osgLego
