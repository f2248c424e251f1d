#include <osgLego/palette/MixtureTable.h>

#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/EntryPlaces.h>
#include <osgLego/palette/MatchingLab.h>
#include <osgLego/palette/NearestTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace osgLego
{

namespace
{

constexpr int WHOLE = 256; // of which PaletteMixture::share is a part

// Fewer bricks of another colour look like faults.
constexpr int LEAST_SHARE = WHOLE / 32;

double chromaOf(const glm::dvec3& place)
{
    return std::hypot(place.y, place.z);
}

/** The largest chroma of colours that may be mixed to imitate a colour of some chroma. Bricks of clear hues in a nearly
 * neutral surface look like faults. */
double largestChroma(double chroma)
{
    // The middle of an entry differs by up to 3 from a colour in it; colours of a chroma of at most 5 count as neutral,
    // those of more than 10 as chromatic.
    constexpr double NEUTRAL = 8.0;
    constexpr double LARGEST = 10.0;
    constexpr double SLOPE = 6.0; // soon allows all colours
    return LARGEST + SLOPE * std::max(chroma - NEUTRAL, 0.0);
}

/** The pairs of a palette's colours, and how well they imitate colours. */
class MixtureSearch
{
public:
    explicit MixtureSearch(std::span<const PaletteColor> colors)
    {
        for (const PaletteColor& color : colors)
        {
            _places.push_back(toMatchingLab(color.color));
            _lightnesses.push_back(toCieLab(color.color).x);
            _lights.push_back(toLinear(color.color));
        }
        _differences.reserve(colors.size() * colors.size());
        for (const glm::dvec3& first : _places)
            for (const glm::dvec3& second : _places)
                _differences.push_back(ciede2000(first, second));
    }

    /** The colours that may be mixed for the entries of a block: the nearest, and the nearest of neutral colours. */
    std::vector<std::size_t> findCandidates(const glm::dvec3& middle) const
    {
        std::vector<std::pair<double, std::size_t>> nearest;
        for (std::size_t index = 0; index < _places.size(); ++index)
            nearest.emplace_back(ciede2000(middle, _places[index]), index);
        std::sort(nearest.begin(), nearest.end());
        std::vector<std::size_t> candidates;
        std::size_t numNeutral = 0;
        for (const auto& [difference, index] : nearest)
        {
            const bool isNear = candidates.size() - numNeutral < NUM_NEAREST;
            const bool isNeutral = numNeutral < NUM_NEUTRAL && chromaOf(_places[index]) <= largestChroma(0.0);
            if (!isNear && !isNeutral) continue;
            numNeutral += isNear ? 0 : 1;
            candidates.push_back(index);
        }
        return candidates;
    }

    /** @param nearest the index of the colour with which the surface stays plain if no pair is better. */
    PaletteMixture find(const std::array<std::uint8_t, 3>& color, const glm::dvec3& place, std::uint8_t nearest,
                        std::span<const std::size_t> candidates) const
    {
        const double plainCost = ciede2000(place, _places[nearest]);
        Pair best;
        int share = 0;
        double leastCost = plainCost;
        const auto compare = [&](const Pair& pair, int other)
        {
            if (other < LEAST_SHARE || other > WHOLE - LEAST_SHARE) return;
            const double cost = costOf(pair, other, place);
            if (cost >= leastCost) return;
            leastCost = cost;
            best = pair;
            share = other;
        };
        for (const Pair& pair : findPairs(color, place, candidates))
            compare(pair, static_cast<int>(std::lround(WHOLE * pair.share)));
        if (leastCost == plainCost) return {nearest, nearest, 0};
        // The share is exact for small differences only.
        for (int step = WHOLE / 8; step > 1; step /= 2)
            for (const int other : {share - step, share + step})
                compare(best, other);
        return toMixture(best, share);
    }

private:
    static constexpr std::size_t NUM_NEAREST = 12;
    static constexpr std::size_t NUM_NEUTRAL = 4;

    static constexpr std::size_t NUM_PAIRS = 8; // whose exact costs are compared

    struct Pair
    {
        double cost = std::numeric_limits<double>::max(); // exact for small differences only
        std::size_t first = 0;
        std::size_t second = 0;
        double share = 0.0; // of the second
    };

    PaletteMixture toMixture(const Pair& pair, int share) const
    {
        // Of neighbouring entries, which may mix other pairs, the same cells then have the lighter colours.
        const bool isLighter = _lightnesses[pair.first] > _lightnesses[pair.second];
        return {static_cast<std::uint8_t>(isLighter ? pair.second : pair.first),
                static_cast<std::uint8_t>(isLighter ? pair.first : pair.second),
                static_cast<std::uint8_t>(isLighter ? WHOLE - share : share)};
    }

    /** The difference of a mixture from a colour, and the cost of its spread. @param share of WHOLE. */
    double costOf(const Pair& pair, int share, const glm::dvec3& place) const
    {
        const double exactShare = static_cast<double>(share) / WHOLE;
        const glm::dvec3 mean = linearToMatchingLab(glm::mix(_lights[pair.first], _lights[pair.second], exactShare));
        return ciede2000(place, mean) + costOfSpread(pair.first, pair.second, exactShare);
    }

    /** The cost of bricks that differ, in differences of their mean. */
    double costOfSpread(std::size_t first, std::size_t second, double share) const
    {
        constexpr double SPREAD_COST = 0.1;
        // The standard deviation of the bricks' colours.
        return SPREAD_COST * std::sqrt(share * (1.0 - share)) * _differences[first * _places.size() + second];
    }

    /** The best pairs, the best first. */
    std::array<Pair, NUM_PAIRS> findPairs(const std::array<std::uint8_t, 3>& color, const glm::dvec3& place,
                                          std::span<const std::size_t> candidates) const
    {
        const glm::dvec3 light = toLinear(color);
        // Where places are moved, the derivatives of CIELAB are good enough to find pairs.
        const glm::dmat3 scale = ciede2000Scale(linearToCieLab(light)) * cieLabDerivatives(light);
        const double limit = largestChroma(chromaOf(place));
        std::array<std::size_t, NUM_NEAREST + NUM_NEUTRAL> indices;
        std::array<glm::dvec3, NUM_NEAREST + NUM_NEUTRAL> places; // relative to the colour
        std::size_t count = 0;
        for (const std::size_t index : candidates)
        {
            if (chromaOf(_places[index]) > limit) continue;
            indices[count] = index;
            places[count++] = scale * (_lights[index] - light);
        }
        std::array<Pair, NUM_PAIRS> best;
        for (std::size_t second = 1; second < count; ++second)
            for (std::size_t first = 0; first < second; ++first)
            {
                const glm::dvec3 way = places[second] - places[first];
                const double square = glm::dot(way, way);
                if (square == 0.0) continue;
                Pair pair{0.0, indices[first], indices[second],
                          std::clamp(-glm::dot(places[first], way) / square, 0.0, 1.0)};
                const double error = glm::length(places[first] + pair.share * way);
                if (error >= best.back().cost) continue;
                pair.cost = error + costOfSpread(pair.first, pair.second, pair.share);
                if (pair.cost >= best.back().cost) continue;
                const auto better = std::ranges::upper_bound(best, pair.cost, {}, &Pair::cost);
                std::move_backward(better, best.end() - 1, best.end());
                *better = pair;
            }
        return best;
    }

    std::vector<glm::dvec3> _places;  // at which colours are matched
    std::vector<double> _lightnesses; // in CIELAB
    std::vector<glm::dvec3> _lights;  // in linear light
    std::vector<double> _differences;
};

} // namespace

std::vector<PaletteMixture> makeMixtureTable(std::span<const PaletteColor> colors,
                                             std::span<const std::uint8_t> nearest)
{
    const EntryPlaces& entries = EntryPlaces::get();
    const MixtureSearch search(colors);
    std::vector<PaletteMixture> table(nearest.size());
    TableBlock::forEach(
        [&](const TableBlock& block)
        {
            const std::vector<std::size_t> candidates = search.findCandidates(entries[block.getMiddle()]);
            block.forEachEntry(
                [&](std::size_t entry)
                { table[entry] = search.find(middleOfEntry(entry), entries[entry], nearest[entry], candidates); });
        });
    for (const PaletteColor& color : colors)
    {
        const std::size_t entry = tableEntryOf(color.color);
        table[entry] = {nearest[entry], nearest[entry], 0};
    }
    return table;
}

} // namespace osgLego
