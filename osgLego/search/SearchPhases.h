#pragma once

#include <vector>

namespace osgLego
{

/** Rounds of WindowSearch with the same costs. */
struct SearchPhase
{
    int numRounds = 0;
    int seamCost = 0; //!< of half a unit of stacked seams; 0: the phase only leads the search away from where it was

    bool operator==(const SearchPhase&) const = default;
};

/** Phases that ignore seams and phases that count them, in turn, so that the search escapes layouts that no single
 * window can improve. The last one counts them.
 *
 * @param numRounds in all phases; not negative.
 * @param seamCost of half a unit of stacked seams; positive. */
std::vector<SearchPhase> alternatePhases(int numRounds, int seamCost);

/** Phases for layouts with few parts: while the cost of seams falls, the search gives up seams that cost the most parts
 * to avoid. Layouts that begin with a low cost have as few parts, but more stacked seams. This is repeated after a
 * phase that ignores seams.
 *
 * @param numRounds in all phases, approximately; at least 4.
 * @param seamCost at first; it falls to an eighth. */
std::vector<SearchPhase> lowerPhases(int numRounds, int seamCost);

} // namespace osgLego
