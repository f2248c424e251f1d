#include <osgLego/search/SearchPhases.h>

#include <algorithm>
#include <array>

namespace osgLego
{

std::vector<SearchPhase> alternatePhases(int numRounds, int seamCost)
{
    constexpr int LONGEST = 20;
    constexpr int FEWEST_ALTERNATING = 12; // rounds; fewer don't recover from rounds that ignore seams
    const int length = numRounds < FEWEST_ALTERNATING ? numRounds : std::min(numRounds / 2, LONGEST);
    std::vector<SearchPhase> phases;
    for (int left = numRounds; left > 0; left -= phases.back().numRounds)
    {
        const bool hasSeams = (left - 1) / length % 2 == 0;
        phases.push_back({(left - 1) % length + 1, hasSeams ? seamCost : 0});
    }
    return phases;
}

std::vector<SearchPhase> lowerPhases(int numRounds, int seamCost)
{
    constexpr std::array DIVISORS{1, 2, 4, 8};
    constexpr int NUM_PHASES = static_cast<int>(DIVISORS.size());
    constexpr int LENGTH = 10;                                 // rounds, if there are enough
    constexpr int SEQUENCE = NUM_PHASES * LENGTH + LENGTH / 2; // with half a phase that ignores seams
    const int numSequences = std::max((numRounds + LENGTH / 2) / SEQUENCE, 1);
    const int length = 2 * numRounds / ((2 * NUM_PHASES + 1) * numSequences - 1);
    std::vector<SearchPhase> phases;
    for (int sequence = 0; sequence < numSequences; ++sequence)
    {
        if (sequence > 0) phases.push_back({length / 2, 0});
        for (const int divisor : DIVISORS)
            phases.push_back({length, seamCost / divisor});
    }
    return phases;
}

} // namespace osgLego
