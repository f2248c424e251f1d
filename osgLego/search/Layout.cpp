#include <osgLego/search/Layout.h>

#include <osgLego/layout/GreedyLayout.h>
#include <osgLego/layout/KeptParts.h>
#include <osgLego/layout/PartColors.h>
#include <osgLego/layout/ReachingParts.h>
#include <osgLego/search/BestLayout.h>
#include <osgLego/search/BridgeJoiner.h>
#include <osgLego/search/ComponentJoiner.h>
#include <osgLego/search/LayoutCosts.h>
#include <osgLego/search/SearchPhases.h>
#include <osgLego/search/WindowSearch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

namespace
{

/** The amount of work for an effort: counts rather than a time limit, so that every machine finds the same layout. */
struct Work
{
    int numWindows = 0; //!< in all rounds, if that gives a number of rounds from `fewest` to `most`
    int fewest = 0;     //!< rounds
    int most = 0;       //!< rounds
    WindowSearch::Limits windows;
    ComponentJoiner::Limits joins;
};

constexpr std::array<Work, 3> WORK{
    {{4100, 0, 3, {3, 100}, {1, 40}}, {100000, 2, 40, {1, 300}, {4, 1000}}, {1500000, 12, 250, {1, 2000}, {8, 10000}}}};
constexpr ComponentJoiner::Limits JOINS_OF_DRAFT{1, 100};
constexpr int NEIGHBORHOOD = 8; // distance in cells from a change within which parts may change, too

/** Join components of a greedy layout, and do nothing else.
 * @return false if it was cancelled. */
bool joinOnly(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive)
{
    LayoutRandom random(options.seed);
    return ComponentJoiner(map, sizes).joinAll(JOINS_OF_DRAFT, isActive, random, options.isCancelled);
}

std::vector<SearchPhase> makePhases(const PartMap& map, const LayoutOptions& options)
{
    const LayoutProblem& problem = map.getLattice().getProblem();
    const Work& work = WORK[static_cast<std::size_t>(options.effort)];
    const int numRounds = std::clamp(work.numWindows / std::max(map.countParts(), 1), work.fewest, work.most);
    if (options.effort == Effort::BEST && problem.isSolid())
        return lowerPhases(numRounds, options.bond * LayoutCosts::HALF_SEAM);
    return alternatePhases(numRounds, options.bond * LayoutCosts::getHalfSeam(problem));
}

/** Improve a layout of all cells. The layouts at the end of phases that count seams are added to `best`, except the
 * last one, which the map has then.
 * @return false if it was cancelled. */
bool search(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive,
            BestLayout& best)
{
    LayoutRandom random(options.seed);
    ComponentJoiner joiner(map, sizes);
    const Work& work = WORK[static_cast<std::size_t>(options.effort)];
    const auto join = [&] { return joiner.joinAll(work.joins, isActive, random, options.isCancelled); };
    // Bridges need less time than as many attempts to join would.
    if (options.effort == Effort::INSTANT)
    {
        if (!BridgeJoiner(map, sizes).joinAll(isActive, random, options.isCancelled)) return false;
    }
    else if (!join())
        return false;
    WindowSearch windows(map, sizes, options, isActive);
    const std::vector<SearchPhase> phases = makePhases(map, options);
    int numRounds = 0;
    for (const SearchPhase& phase : phases)
        numRounds += phase.numRounds;
    int round = 0;
    for (const SearchPhase& phase : phases)
    {
        for (int i = 0; i < phase.numRounds; ++i)
        {
            if (!windows.runRound(phase.seamCost, work.windows)) return false;
            if (options.progress) options.progress(static_cast<double>(++round) / (numRounds + 1));
        }
        if (phase.seamCost > 0 && &phase != &phases.back()) best.add(map);
    }
    return join();
}

/** Improve a layout with an effort other than Effort::BEST.
 * @return false if it was cancelled. */
bool improve(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive)
{
    BestLayout best(sizes, options.bond * LayoutCosts::getHalfSeam(map.getLattice().getProblem()));
    if (!search(map, sizes, options, isActive, best)) return false;
    best.restore(map);
    return true;
}

/** How often the search begins again for a solid model of so many parts: one part is several percent of a small model,
 * and a search of it takes a fraction of a second. */
int countStarts(int numParts)
{
    constexpr int PARTS_OF_ALL_STARTS = 400;
    constexpr int MOST = 8;
    return std::clamp(PARTS_OF_ALL_STARTS / std::max(numParts, 1), 1, MOST);
}

/** Search with Effort::BEST for a solid model, several times if it is small. All layouts are added to `best`, except
 * the last one, which the map has then.
 * @return false if it was cancelled. */
bool searchSolid(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive,
                 BestLayout& best)
{
    const int numStarts = countStarts(map.countParts());
    for (int start = 0; start < numStarts; ++start)
    {
        LayoutOptions own = options;
        own.seed = options.seed + static_cast<std::uint32_t>(numStarts - 1 - start);
        if (options.progress) own.progress = [&](double done) { options.progress((start + done) / numStarts); };
        if (start + 1 == numStarts) return search(map, sizes, own, isActive, best);
        PartMap again(map);
        if (!search(again, sizes, own, isActive, best)) return false;
        best.add(again);
    }
    return true;
}

/** Improve a layout with Effort::BEST, or as normal effort does if that ends at a better one, which may happen.
 * @return false if it was cancelled. */
bool improveMost(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive)
{
    LayoutOptions normal = options;
    normal.effort = Effort::NORMAL;
    normal.progress = {};
    PartMap other(map);
    if (!improve(other, sizes, normal, isActive)) return false;
    const LayoutProblem& problem = map.getLattice().getProblem();
    const bool isSolid = problem.isSolid();
    BestLayout best(sizes, options.bond *
                               (isSolid ? LayoutCosts::HALF_SEAM_OF_BEST_SOLID : LayoutCosts::getHalfSeam(problem)));
    if (isSolid) best.limit(other);
    if (!(isSolid ? searchSolid : search)(map, sizes, options, isActive, best)) return false;
    best.add(other);
    best.restore(map);
    return true;
}

} // namespace

LaidParts layOut(const LayoutProblem& problem, const LayoutOptions& options, const LaidParts& previous)
{
    const auto isCancelled = [&] { return options.isCancelled && options.isCancelled(); };
    if (isCancelled()) return {};
    const CellLattice lattice(problem);
    const PartSizes sizes(problem);
    PartMap map(lattice);
    keepParts(map, sizes, previous);
    std::vector<bool> isActive;
    if (!previous.empty()) isActive = findChangedCells(map, NEIGHBORHOOD);
    if (options.effort == Effort::INSTANT && !options.isGreedy) layReachingParts(map, sizes);
    layGreedily(map, sizes);
    const auto improveLayout = options.isGreedy ? joinOnly : options.effort == Effort::BEST ? improveMost : improve;
    if (!improveLayout(map, sizes, options, isActive) || isCancelled()) return {};
    if (options.progress) options.progress(1.0);
    return collectParts(map, sizes);
}

} // namespace osgLego
