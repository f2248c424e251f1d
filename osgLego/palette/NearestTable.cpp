#include <osgLego/palette/NearestTable.h>

#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>

#include <algorithm>
#include <limits>

#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace osgLego
{

namespace
{

constexpr std::size_t SIDE = PaletteLimits::TABLE_SIDE;
constexpr std::size_t NUM_ENTRIES = SIDE * SIDE * SIDE;
constexpr std::size_t BLOCK_SIDE = 4;
constexpr std::size_t BLOCKS = SIDE / BLOCK_SIDE; // along each channel
constexpr std::size_t NUM_BLOCKS = BLOCKS * BLOCKS * BLOCKS;

using Places = std::vector<glm::dvec3>; // of colours in CIELAB

/** Call function(index) for each index below a number, on several threads. Static variables wait for tables, so the
 * caller must not take up other tasks, which could need the same variables. */
template <typename Function>
void forEach(std::size_t count, const Function& function)
{
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t(0), count, function); });
}

/** A cube of entries: few colours of a palette are nearest to any of them. */
class Block
{
public:
    explicit Block(std::size_t index) :
        _first(BLOCK_SIDE * (index % BLOCKS + SIDE * (index / BLOCKS % BLOCKS + SIDE * (index / BLOCKS / BLOCKS))))
    {
    }

    /** @param red 0 to BLOCK_SIDE - 1, as the other two. */
    std::size_t getEntry(std::size_t red, std::size_t green, std::size_t blue) const
    {
        return _first + red + SIDE * (green + SIDE * blue);
    }

    std::size_t getMiddle() const { return getEntry(BLOCK_SIDE / 2, BLOCK_SIDE / 2, BLOCK_SIDE / 2); }

    template <typename Visit>
    void forEachEntry(const Visit& visit) const
    {
        for (std::size_t blue = 0; blue < BLOCK_SIDE; ++blue)
            for (std::size_t green = 0; green < BLOCK_SIDE; ++green)
                for (std::size_t red = 0; red < BLOCK_SIDE; ++red)
                    visit(getEntry(red, green, blue));
    }

private:
    std::size_t _first;
};

/** The places of the middles of all entries, which are the same for every palette. */
class EntryPlaces
{
public:
    EntryPlaces() : _places(NUM_ENTRIES), _radii(NUM_BLOCKS)
    {
        constexpr std::size_t WIDTH = 256 / SIDE;
        const auto middleOf = [](std::size_t step) { return static_cast<std::uint8_t>(WIDTH * step + WIDTH / 2); };
        forEach(NUM_ENTRIES,
                [&](std::size_t entry) {
                    _places[entry] = toCieLab(
                        {middleOf(entry % SIDE), middleOf(entry / SIDE % SIDE), middleOf(entry / SIDE / SIDE)});
                });
        forEach(NUM_BLOCKS, [&](std::size_t block) { _radii[block] = findRadius(Block(block)); });
    }

    const glm::dvec3& operator[](std::size_t entry) const { return _places[entry]; }

    /** The difference between the middle entry of a block and the one that is farthest from it. */
    double getRadius(std::size_t block) const { return _radii[block]; }

private:
    double findRadius(const Block& block) const
    {
        double radius = 0.0;
        for (const std::size_t blue : {std::size_t(0), BLOCK_SIDE - 1})
            for (const std::size_t green : {std::size_t(0), BLOCK_SIDE - 1})
                for (const std::size_t red : {std::size_t(0), BLOCK_SIDE - 1})
                    radius = std::max(radius,
                                      ciede2000(_places[block.getMiddle()], _places[block.getEntry(red, green, blue)]));
        return radius;
    }

    Places _places;
    std::vector<double> _radii;
};

/** A colour that may be nearest to an entry of a block, and its difference from the middle entry. */
struct Candidate
{
    double difference = 0.0;
    std::uint8_t index = 0;

    auto operator<=>(const Candidate&) const = default;
};

/** The candidates of a block, the nearest first. */
std::vector<Candidate> findCandidates(const glm::dvec3& middle, double radius, const Places& colors)
{
    // Twice the radius would be enough if the triangle inequality held.
    const double reach = 2.5 * radius;
    std::vector<Candidate> candidates;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t index = 0; index < colors.size(); ++index)
    {
        if (lightnessDifference(middle, colors[index]) > nearest + reach) continue;
        const double difference = ciede2000(middle, colors[index]);
        nearest = std::min(nearest, difference);
        candidates.push_back({difference, static_cast<std::uint8_t>(index)});
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

} // namespace

std::vector<std::uint8_t> makeNearestTable(std::span<const PaletteColor> colors)
{
    static const EntryPlaces entries;
    Places places;
    for (const PaletteColor& color : colors)
        places.push_back(toCieLab(color.color));
    std::vector<std::uint8_t> table(NUM_ENTRIES);
    forEach(NUM_BLOCKS,
            [&](std::size_t index)
            {
                const Block block(index);
                const std::vector<Candidate> candidates =
                    findCandidates(entries[block.getMiddle()], entries.getRadius(index), places);
                block.forEachEntry([&](std::size_t entry)
                                   { table[entry] = findNearest(entries[entry], candidates, places); });
            });
    for (std::size_t index = colors.size(); index-- > 0;)
        table[tableEntryOf(colors[index].color)] = static_cast<std::uint8_t>(index);
    return table;
}

} // namespace osgLego
