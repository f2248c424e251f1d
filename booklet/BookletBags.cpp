#include "BookletBags.h"

#include <algorithm>
#include <limits>
#include <map>

namespace osgLego
{

namespace
{

std::vector<BookletItem> sumItems(std::span<const BookletBlock> blocks)
{
    std::map<std::size_t, std::size_t> quantities;
    for (const BookletBlock& block : blocks)
        for (const BookletItem& item : block.placed)
            quantities[item.kind] += item.quantity;
    std::vector<BookletItem> items;
    items.reserve(quantities.size());
    for (const auto& [kind, quantity] : quantities)
        items.push_back({kind, quantity});
    return items;
}

constexpr double COST_OF_DIVISION = 1e5; // of a submodel: more than that of any sizes within the limits
constexpr double TOLERANCE = 5.0;        // parts beyond the limits that are as bad as a division

/** The cost of a bag by its number of parts: outside of the limits, and unlike the usual one. */
double rateSize(std::size_t numParts)
{
    constexpr double COST_OF_LIMITS = COST_OF_DIVISION / (TOLERANCE * TOLERANCE);
    const auto number = static_cast<double>(numParts);
    const double outside = std::max({0.0, static_cast<double>(BookletBag::LEAST_PARTS) - number,
                                     number - static_cast<double>(BookletBag::MOST_PARTS)});
    const double excess = number - static_cast<double>(BookletBag::USUAL_PARTS);
    return COST_OF_LIMITS * outside * outside + excess * excess;
}

/** The cost of a bag that begins with a block. */
double rateBeginning(const BookletBlock& block)
{
    return COST_OF_DIVISION * static_cast<double>(block.numOpen);
}

/** Divide blocks so that bags cost least. All blocks are never one bag, unless none is divisible.
 * @return the ends of the bags. */
std::vector<std::size_t> divideBlocks(std::span<const BookletBlock> blocks)
{
    const std::size_t number = blocks.size();
    constexpr double IMPOSSIBLE = std::numeric_limits<double>::max();
    std::vector<std::size_t> numParts(number + 1, 0); // of the blocks before
    for (std::size_t block = 0; block < number; ++block)
        numParts[block + 1] = numParts[block] + sumQuantities(blocks[block].placed);
    std::vector<double> costs(number + 1, IMPOSSIBLE);
    std::vector<std::size_t> firsts(number + 1, 0);
    costs[0] = 0.0;
    for (std::size_t end = 1; end <= number; ++end)
    {
        if (end < number && !blocks[end].isDivisible) continue;
        for (std::size_t first = end == number ? 1 : 0; first < end; ++first)
        {
            if (costs[first] == IMPOSSIBLE) continue;
            const double cost = costs[first] + rateSize(numParts[end] - numParts[first]) + rateBeginning(blocks[first]);
            if (cost >= costs[end]) continue;
            costs[end] = cost;
            firsts[end] = first;
        }
    }
    std::vector<std::size_t> ends;
    for (std::size_t end = number; end > 0; end = firsts[end])
        ends.insert(ends.begin(), end);
    return ends;
}

} // namespace

std::vector<BookletBag> createBags(std::span<const BookletBlock> blocks)
{
    if (sumQuantities(sumItems(blocks)) < BookletBag::FEWEST_OF_MODEL) return {};
    std::vector<BookletBag> bags;
    BookletBag bag;
    for (const std::size_t end : divideBlocks(blocks))
    {
        bag.endBlock = end;
        bag.items = sumItems(blocks.subspan(bag.firstBlock, end - bag.firstBlock));
        bags.push_back(bag);
        bag.firstBlock = end;
    }
    return bags.size() > 1 ? bags : std::vector<BookletBag>();
}

} // namespace osgLego
