#include "../layout/LaidModel.h"

#include <Layouts.h>

#include <osgLego/PartType.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr int WIDTH = 4;
constexpr int DEPTH = 3;
constexpr int PART = 10000;
constexpr int SEAM = 2000;

/** A set of the joints of a layer, one bit each: those to the east of each cell, and then those to the north. */
using Joints = std::uint32_t;

/** Lists the joints of all covers of a layer, with the fewest parts for each. */
class LayerCovers
{
public:
    LayerCovers(const LayoutProblem& problem, int layer) : _colors(WIDTH * DEPTH, NO_CELL), _owners(WIDTH * DEPTH, -1)
    {
        for (const LayoutCell& cell : problem.cells)
            if (cell.place[2] == layer) _colors[cell.place[1] * std::size_t(WIDTH) + cell.place[0]] = cell.color;
        cover(0, 0);
    }

    std::map<Joints, int> fewestParts;

private:
    static constexpr int NO_CELL = -1;

    void cover(std::size_t first, int numParts)
    {
        while (first < _colors.size() && (_colors[first] == NO_CELL || _owners[first] >= 0))
            ++first;
        if (first == _colors.size())
        {
            const auto found = fewestParts.emplace(findJoints(), numParts).first;
            found->second = std::min(found->second, numParts);
            return;
        }
        for (const auto& [shorter, longer] : PART_SIZES)
        {
            lay(first, shorter, longer, numParts);
            if (shorter != longer) lay(first, longer, shorter, numParts);
        }
    }

    void lay(std::size_t first, int width, int depth, int numParts)
    {
        const int firstX = static_cast<int>(first) % WIDTH;
        const int firstY = static_cast<int>(first) / WIDTH;
        if (firstX + width > WIDTH || firstY + depth > DEPTH) return;
        const std::vector<int> before = _owners;
        bool fits = true;
        for (int y = firstY; y < firstY + depth; ++y)
            for (int x = firstX; x < firstX + width; ++x)
            {
                const auto cell = static_cast<std::size_t>(y * WIDTH + x);
                fits = fits && _colors[cell] == _colors[first] && _owners[cell] < 0;
                _owners[cell] = numParts;
            }
        if (fits) cover(first + 1, numParts + 1);
        _owners = before;
    }

    Joints findJoints() const
    {
        Joints joints = 0;
        for (int cell = 0; cell < WIDTH * DEPTH; ++cell)
        {
            if (cell % WIDTH + 1 < WIDTH && isJoint(cell, cell + 1)) joints |= Joints(1) << cell;
            if (cell / WIDTH + 1 < DEPTH && isJoint(cell, cell + WIDTH)) joints |= Joints(1) << (WIDTH * DEPTH + cell);
        }
        return joints;
    }

    bool isJoint(int cell, int other) const
    {
        const int owner = _owners[static_cast<std::size_t>(cell)];
        const int otherOwner = _owners[static_cast<std::size_t>(other)];
        return owner >= 0 && otherOwner >= 0 && owner != otherOwner;
    }

    std::vector<int> _colors;
    std::vector<int> _owners;
};

/** The least cost of parts and stacked seams of all layouts, layer by layer: the joints of a layer decide what the rest
 * above it costs. */
std::int64_t findLeastCost(const LayoutProblem& problem)
{
    std::map<Joints, std::int64_t> costs{{0, 0}};
    for (int layer = 0; layer < problem.size.z; ++layer)
    {
        std::map<Joints, std::int64_t> next;
        for (const auto& [joints, numParts] : LayerCovers(problem, layer).fewestParts)
        {
            std::int64_t least = std::numeric_limits<std::int64_t>::max();
            for (const auto& [below, cost] : costs)
                least = std::min(least, cost + SEAM * std::popcount(joints & below));
            next[joints] = least + PART * numParts;
        }
        costs.swap(next);
    }
    return std::min_element(costs.begin(), costs.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->second;
}

std::int64_t computeCost(const LayoutProblem& problem, const LaidParts& parts)
{
    const LaidModel model(problem, parts);
    EXPECT_EQ(model.findMistake(), "");
    return PART * static_cast<std::int64_t>(parts.size()) + SEAM * model.countStackedSeams();
}

} // namespace

TEST(LayoutOptimum, IsReachedByNearlyAllSmallModels)
{
    constexpr unsigned int NUM_MODELS = 36;
    std::int64_t excess = 0;
    for (unsigned int seed = 0; seed < NUM_MODELS; ++seed)
    {
        const LayoutProblem problem = createRandomProblem({WIDTH, DEPTH, 3}, "aaaaaaaaab", seed);
        LayoutOptions options;
        options.effort = Effort::BEST;
        options.seed = seed;
        const std::int64_t cost = computeCost(problem, layOut(problem, options));
        const std::int64_t least = findLeastCost(problem);
        EXPECT_GE(cost, least);
        excess += cost - least;
    }
    EXPECT_LE(excess, SEAM) << "more than one stacked seam too many in all models together";
}

} // namespace osgLego
