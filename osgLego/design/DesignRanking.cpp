#include <osgLego/design/DesignRanking.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

namespace osgLego
{

namespace
{

/** The settings that are not left at their defaults. */
std::size_t countSettings(const DesignCandidate& candidate)
{
    const std::string text = candidate.settings.toString();
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
}

/** Sort models by their errors, one of bricks and one of plates in turn. */
void sortInTurns(std::vector<const DesignCandidate*>& candidates)
{
    std::sort(candidates.begin(), candidates.end(),
              [](const DesignCandidate* a, const DesignCandidate* b) { return a->getError() < b->getError(); });
    std::map<Proportions, int> counts;
    std::map<const DesignCandidate*, int> turns;
    for (const DesignCandidate* candidate : candidates)
        turns[candidate] = counts[candidate->settings.grid.proportions]++;
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](const DesignCandidate* a, const DesignCandidate* b) { return turns[a] < turns[b]; });
}

} // namespace

int DesignRanking::rankStability(const StabilityReport& stability)
{
    if (!stability.stands) return stability.falls() ? 3 : 2;
    return stability.safe ? 0 : 1;
}

bool DesignRanking::isBetter(const DesignCandidate& a, const DesignCandidate& b) const
{
    const auto rank = [this](const DesignCandidate& candidate)
    {
        constexpr double VISIBLE = 0.01;
        return std::tuple(!candidate.isWhole(), rankStability(candidate.stability), !hasFewEnoughParts(candidate),
                          candidate.numPieces, candidate.exceedsLimits(), std::lround(candidate.getError() / VISIBLE),
                          candidate.layout.numParts, countSettings(candidate));
    };
    return rank(a) < rank(b);
}

std::vector<LegoSettings> DesignRanking::listHard(const std::vector<DesignCandidate>& candidates)
{
    std::vector<const DesignCandidate*> hard;
    for (const DesignCandidate& candidate : candidates)
        if (!candidate.settings.parts.support && candidate.isWhole() &&
            candidate.layout.numParts <= DesignCandidate::MOST_PLANNED_PARTS &&
            (candidate.plan ? candidate.exceedsLimits() : !candidate.stability.stands))
            hard.push_back(&candidate);
    sortInTurns(hard);
    std::vector<LegoSettings> settings;
    settings.reserve(hard.size());
    for (const DesignCandidate* candidate : hard)
        settings.push_back(candidate->settings);
    return settings;
}

std::vector<const DesignCandidate*> DesignRanking::listFallingBetter(const std::vector<DesignCandidate>& candidates)
{
    constexpr double CLEARLY = 0.95;
    const DesignCandidate& best = candidates.front();
    std::vector<const DesignCandidate*> falling;
    for (const DesignCandidate& candidate : candidates)
        if (!candidate.stability.stands && !candidate.settings.parts.support &&
            (!standsSafely(best) || candidate.getError() < CLEARLY * best.getError()))
            falling.push_back(&candidate);
    sortInTurns(falling);
    return falling;
}

} // namespace osgLego
