#include <osgLego/palette/NearestTable.h>

#include <osgLego/palette/Oklab.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

constexpr std::size_t SIDE = Palette::TABLE_SIDE;
constexpr std::size_t NUM_ENTRIES = SIDE * SIDE * SIDE;
constexpr std::size_t BLOCK_SIDE = 4;
constexpr std::size_t BLOCKS = SIDE / BLOCK_SIDE; // along each channel

/** A cube of entries: few colours of a palette are nearest to any of them. */
struct Block
{
    std::size_t firstEntry = 0;
    // A sphere around the entries in Oklab.
    glm::vec3 center{0.0f};
    float radius = 0.0f;

    /** The first entry of a row of BLOCK_SIDE entries. @param row 0 to BLOCK_SIDE^2 - 1. */
    std::size_t getRow(std::size_t row) const
    {
        return firstEntry + SIDE * (row % BLOCK_SIDE + SIDE * (row / BLOCK_SIDE));
    }
};

/** The places of all entries in Oklab, which are the same for every palette. */
class EntryPlaces
{
public:
    EntryPlaces() : _lightness(NUM_ENTRIES), _a(NUM_ENTRIES), _b(NUM_ENTRIES)
    {
        std::array<double, SIDE> linear{};
        for (std::size_t step = 0; step < SIDE; ++step)
            linear[step] = toLinear(static_cast<std::uint8_t>((2 * step + 1) * 256 / SIDE / 2));
        for (std::size_t entry = 0; entry < NUM_ENTRIES; ++entry)
        {
            const glm::vec3 place =
                linearToOklab({linear[entry % SIDE], linear[entry / SIDE % SIDE], linear[entry / SIDE / SIDE]});
            _lightness[entry] = place.x;
            _a[entry] = place.y;
            _b[entry] = place.z;
        }
        for (std::size_t block = 0; block < _blocks.size(); ++block)
            _blocks[block] = makeBlock(block);
    }

    const std::array<Block, BLOCKS * BLOCKS * BLOCKS>& getBlocks() const { return _blocks; }

    /** The squares of the distances of a row of entries to a place. */
    std::array<float, BLOCK_SIDE> distancesTo(const glm::vec3& place, std::size_t firstEntry) const
    {
        std::array<float, BLOCK_SIDE> result;
        for (std::size_t step = 0; step < BLOCK_SIDE; ++step)
        {
            const float lightness = _lightness[firstEntry + step] - place.x;
            const float a = _a[firstEntry + step] - place.y;
            const float b = _b[firstEntry + step] - place.z;
            result[step] = lightness * lightness + a * a + b * b;
        }
        return result;
    }

private:
    Block makeBlock(std::size_t index) const
    {
        Block block;
        block.firstEntry =
            BLOCK_SIDE * (index % BLOCKS + SIDE * (index / BLOCKS % BLOCKS + SIDE * (index / BLOCKS / BLOCKS)));
        const std::size_t middle = block.firstEntry + BLOCK_SIDE / 2 * (1 + SIDE + SIDE * SIDE);
        block.center = {_lightness[middle], _a[middle], _b[middle]};
        for (std::size_t row = 0; row < BLOCK_SIDE * BLOCK_SIDE; ++row)
            for (const float distance : distancesTo(block.center, block.getRow(row)))
                block.radius = std::max(block.radius, distance);
        block.radius = std::sqrt(block.radius);
        return block;
    }

    std::vector<float> _lightness;
    std::vector<float> _a;
    std::vector<float> _b;
    std::array<Block, BLOCKS * BLOCKS * BLOCKS> _blocks;
};

float squaredDistance(const glm::vec3& place, const glm::vec3& other)
{
    const glm::vec3 difference = place - other;
    return glm::dot(difference, difference);
}

/** The indices of the colours that can be nearest to an entry of a block, in ascending order. */
void findCandidates(const Block& block, const std::vector<glm::vec3>& places, std::vector<std::uint8_t>& candidates)
{
    constexpr float ROUNDING = 1e-4f;
    float nearest = std::numeric_limits<float>::max();
    for (const glm::vec3& place : places)
        nearest = std::min(nearest, squaredDistance(place, block.center));
    const float limit = std::sqrt(nearest) + 2.0f * block.radius + ROUNDING;
    candidates.clear();
    for (std::size_t index = 0; index < places.size(); ++index)
        if (squaredDistance(places[index], block.center) <= limit * limit)
            candidates.push_back(static_cast<std::uint8_t>(index));
}

void fillRow(const EntryPlaces& entries, const std::vector<glm::vec3>& places, std::span<const std::uint8_t> candidates,
             std::size_t firstEntry, std::vector<std::uint8_t>& table)
{
    std::array<float, BLOCK_SIDE> nearest;
    nearest.fill(std::numeric_limits<float>::max());
    std::array<std::int32_t, BLOCK_SIDE> indices{};
    for (const std::uint8_t candidate : candidates)
    {
        const std::array<float, BLOCK_SIDE> distances = entries.distancesTo(places[candidate], firstEntry);
        for (std::size_t step = 0; step < BLOCK_SIDE; ++step)
        {
            indices[step] = distances[step] < nearest[step] ? candidate : indices[step];
            nearest[step] = std::min(nearest[step], distances[step]);
        }
    }
    for (std::size_t step = 0; step < BLOCK_SIDE; ++step)
        table[firstEntry + step] = static_cast<std::uint8_t>(indices[step]);
}

} // namespace

std::vector<std::uint8_t> makeNearestTable(std::span<const PaletteColor> colors)
{
    static const EntryPlaces entries;
    std::vector<glm::vec3> places;
    for (const PaletteColor& color : colors)
        places.emplace_back(toOklab(color.color));
    std::vector<std::uint8_t> table(NUM_ENTRIES);
    std::vector<std::uint8_t> candidates;
    for (const Block& block : entries.getBlocks())
    {
        findCandidates(block, places, candidates);
        for (std::size_t row = 0; row < BLOCK_SIDE * BLOCK_SIDE; ++row)
            fillRow(entries, places, candidates, block.getRow(row), table);
    }
    for (std::size_t index = colors.size(); index-- > 0;)
        table[tableEntryOf(colors[index].color)] = static_cast<std::uint8_t>(index);
    return table;
}

} // namespace osgLego
