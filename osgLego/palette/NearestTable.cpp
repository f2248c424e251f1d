#include <osgLego/palette/NearestTable.h>

#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/EntryPlaces.h>
#include <osgLego/palette/MatchingLab.h>

#include <algorithm>
#include <limits>
#include <set>

#include <glm/vec3.hpp>

namespace osgLego
{

namespace
{

using Places = std::vector<glm::dvec3>; // at which colours are matched

/** A colour that may be nearest to an entry of a block, and its difference from the middle entry. */
struct Candidate
{
    double difference = 0.0;
    std::uint8_t index = 0;

    auto operator<=>(const Candidate&) const = default;
};

/** The candidates of a block, the nearest first.
 * @param indices of colours without duplicates, in ascending order. */
std::vector<Candidate> findCandidates(const glm::dvec3& middle, double radius, const Places& colors,
                                      const std::vector<std::uint8_t>& indices)
{
    // Twice the radius would be enough if the triangle inequality held.
    const double reach = 2.5 * radius;
    std::vector<Candidate> candidates;
    double nearest = std::numeric_limits<double>::max();
    for (const std::uint8_t index : indices)
    {
        if (lightnessDifference(middle, colors[index]) > nearest + reach) continue;
        const double difference = ciede2000(middle, colors[index]);
        nearest = std::min(nearest, difference);
        candidates.push_back({difference, index});
    }
    std::erase_if(candidates, [&](const Candidate& candidate) { return candidate.difference > nearest + reach; });
    std::sort(candidates.begin(), candidates.end());
    return candidates;
}

std::uint8_t findNearest(const glm::dvec3& place, const std::vector<Candidate>& candidates, const Places& colors)
{
    if (candidates.size() == 1) return candidates.front().index;
    Candidate nearest{std::numeric_limits<double>::max(), 0};
    for (const Candidate& candidate : candidates)
    {
        const glm::dvec3& color = colors[candidate.index];
        if (lightnessDifference(place, color) > nearest.difference) continue;
        nearest = std::min(nearest, {ciede2000(place, color), candidate.index});
    }
    return nearest.index;
}

/** The index of each different colour: the first of equal ones. */
std::vector<std::uint8_t> findDifferent(std::span<const PaletteColor> colors)
{
    std::set<std::array<std::uint8_t, 3>> found;
    std::vector<std::uint8_t> indices;
    for (std::size_t index = 0; index < colors.size(); ++index)
        if (found.insert(colors[index].color).second) indices.push_back(static_cast<std::uint8_t>(index));
    return indices;
}

} // namespace

std::vector<std::uint8_t> makeNearestTable(std::span<const PaletteColor> colors)
{
    const EntryPlaces& entries = EntryPlaces::get();
    Places places;
    for (const PaletteColor& color : colors)
        places.push_back(toMatchingLab(color.color));
    const std::vector<std::uint8_t> indices = findDifferent(colors);
    constexpr std::size_t SIDE = PaletteLimits::TABLE_SIDE;
    std::vector<std::uint8_t> table(SIDE * SIDE * SIDE);
    TableBlock::forEach(
        [&](const TableBlock& block)
        {
            const std::vector<Candidate> candidates =
                findCandidates(entries[block.getMiddle()], entries.getRadius(block), places, indices);
            block.forEachEntry([&](std::size_t entry)
                               { table[entry] = findNearest(entries[entry], candidates, places); });
        });
    for (std::size_t index = colors.size(); index-- > 0;)
        table[tableEntryOf(colors[index].color)] = static_cast<std::uint8_t>(index);
    return table;
}

} // namespace osgLego
