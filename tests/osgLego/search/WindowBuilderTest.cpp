#include "../layout/LaidMap.h"

#include <Layouts.h>

#include <osgLego/PartType.h>
#include <osgLego/search/WindowBuilder.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;

constexpr int SEAM_COST = 1000;
/** Two joints at most beside each of 3 * 20 cells at the sides of the largest brick. */
constexpr int LARGEST_CHANCES = 60 * 7;

/** A part that may be laid: its first cell and its shape. */
using Candidate = std::tuple<Index, int, int, int>;

/** The range of a cost, apart from the random costs of joints. */
struct Costs
{
    int least = 0;
    int greatest = 0;
};

/** Lists the parts that may be laid in a window, and their costs, by looking at every cell of every box. */
class PlainWindow
{
public:
    PlainWindow(const LaidMap& laid, const std::vector<Index>& anchors, int leafCost) : _laid(laid), _leafCost(leafCost)
    {
        for (Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
            if (std::find(anchors.begin(), anchors.end(), laid.map.getAnchor(cell)) != anchors.end())
                _cells.insert(cell);
    }

    /** @param hasLayers whether the window has several layers. Then, the joints of the greatest cost are those above
     * cells of which at least one is outside of the window, since no part covers both. */
    std::map<Candidate, Costs> listCosts(bool hasLayers) const
    {
        std::map<Candidate, Costs> costs;
        for (const Index first : _cells)
            for (const int height : _laid.sizes.getHeights())
                for (const auto& [shorter, longer] : PART_SIZES)
                    for (const auto& [width, depth] : {std::pair(shorter, longer), std::pair(longer, shorter)})
                        if (const std::set<Index> cells = findCells(first, width, depth, height); !cells.empty())
                            addCost({first, width, depth, height}, cells, hasLayers, costs);
        return costs;
    }

    const std::set<Index>& getCells() const { return _cells; }

private:
    /** The cells of a box; none unless all are in the window. */
    std::set<Index> findCells(Index first, int width, int depth, int height) const
    {
        const CellLattice& lattice = _laid.lattice;
        std::set<Index> cells;
        for (const Index cell : _cells)
        {
            const int x = lattice.getX(cell) - lattice.getX(first);
            const int y = lattice.getY(cell) - lattice.getY(first);
            const int z = lattice.getZ(cell) - lattice.getZ(first);
            if (std::min({x, y, z}) >= 0 && x < width && y < depth && z < height) cells.insert(cell);
        }
        return static_cast<int>(cells.size()) == width * depth * height ? cells : std::set<Index>();
    }

    void addCost(const Candidate& candidate, const std::set<Index>& cells, bool hasLayers,
                 std::map<Candidate, Costs>& costs) const
    {
        std::set<std::uint16_t> colors;
        for (const Index cell : cells)
            if (_laid.lattice.getColor(cell) != LayoutCell::ANY_COLOR) colors.insert(_laid.lattice.getColor(cell));
        if (colors.size() > 1) return;
        const auto [first, width, depth, height] = candidate;
        const bool isMade = isMadeInAnyOf(colors, width, depth, height);
        if (!isMade && cells.size() > 1) return;
        const int cost = 10000 + (isMade ? 0 : 30000) + costOfContacts(cells, height);
        costs[candidate] = {cost + countSeams(cells, false) * SEAM_COST,
                            cost + countSeams(cells, hasLayers) * SEAM_COST};
    }

    /** Whether a part was made in a colour; in any if the set is empty. */
    bool isMadeInAnyOf(const std::set<std::uint16_t>& colors, int width, int depth, int height) const
    {
        const PartType* const type = findPartType(PartFamily::BRICK, width, depth);
        for (std::uint16_t color = 0; color < _laid.problem.colors.size(); ++color)
        {
            if (!colors.empty() && !colors.contains(color)) continue;
            const LayoutColor& sizes = _laid.problem.colors[color];
            const bool isPlate = _laid.problem.isOfPlates && height == 1;
            if (((isPlate ? sizes.plates : sizes.bricks) >> type->getSizeIndex() & 1) != 0) return true;
        }
        return false;
    }

    /** The joints above and below those at the sides of a part, as far as these are within the window. */
    int countSeams(const std::set<Index>& cells, bool hasLayers) const
    {
        int count = 0;
        for (const Index cell : cells)
            for (const auto side : CellLattice::LEVEL_SIDES)
            {
                const Index beside = _laid.lattice.getNeighbor(cell, side);
                if (!_cells.contains(beside) || cells.contains(beside)) continue;
                for (const auto vertical : {CellLattice::ABOVE, CellLattice::BELOW})
                {
                    const Index near = _laid.lattice.getNeighbor(cell, vertical);
                    const Index far = _laid.lattice.getNeighbor(beside, vertical);
                    if (near < 0 || far < 0 || _laid.map.getAnchor(near) == _laid.map.getAnchor(far)) continue;
                    const int numInside = (_cells.contains(near) ? 1 : 0) + (_cells.contains(far) ? 1 : 0);
                    count += numInside == 0 || (numInside == 1 && hasLayers) ? 1 : 0;
                }
            }
        return count;
    }

    /** A part on its own is a component; a part may hang on a single other one. */
    int costOfContacts(const std::set<Index>& cells, int height) const
    {
        std::set<Index> outside;
        bool hasContactInside = false;
        for (const Index cell : cells)
            for (const auto vertical : {CellLattice::ABOVE, CellLattice::BELOW})
            {
                const Index other = _laid.lattice.getNeighbor(cell, vertical);
                if (other < 0 || cells.contains(other)) continue;
                if (_cells.contains(other))
                    hasContactInside = true;
                else
                    outside.insert(_laid.map.getAnchor(other));
            }
        if (hasContactInside) return 0;
        if (outside.empty()) return height == 1 ? 100000 : 0;
        return outside.size() == 1 ? _leafCost : 0;
    }

    const LaidMap& _laid;
    int _leafCost;
    std::set<Index> _cells;
};

/** Random parts of one layer, or of any. */
std::vector<Index> chooseParts(const LaidMap& laid, int layer, std::mt19937& random)
{
    std::vector<Index> anchors;
    for (Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
        if (laid.map.isAnchor(cell) && random() % 4 != 0 && (layer < 0 || laid.lattice.getZ(cell) == layer))
            anchors.push_back(cell);
    std::shuffle(anchors.begin(), anchors.end(), random);
    return anchors;
}

/** Build a window of parts; those that don't fit any more are removed from the list. */
void build(WindowBuilder& window, std::vector<Index>& anchors)
{
    window.clear();
    std::erase_if(anchors, [&window](Index anchor) { return !window.addPart(anchor); });
    LayoutRandom chances(3);
    window.build(chances, SEAM_COST);
}

std::map<Candidate, int> listCosts(const WindowBuilder& window)
{
    std::map<Candidate, int> costs;
    const WindowParts& parts = window.getParts();
    for (int cell = 0; cell < parts.getNumCells(); ++cell)
        for (int i = parts.starts[static_cast<std::size_t>(cell)]; i < parts.starts[static_cast<std::size_t>(cell) + 1];
             ++i)
        {
            const WindowPart& part = parts.parts[static_cast<std::size_t>(i)];
            EXPECT_EQ(window.getFirstCell(i), cell);
            const Index first = window.getCells()[static_cast<std::size_t>(cell)];
            const Candidate candidate{first, part.shape.width, part.shape.depth, part.shape.height};
            EXPECT_TRUE(costs.emplace(candidate, part.cost).second) << "a part is listed twice";
        }
    return costs;
}

/** Expect the parts and costs that looking at every box finds, apart from the random costs of joints. */
void expectCosts(const WindowBuilder& window, const std::map<Candidate, Costs>& expected)
{
    const std::map<Candidate, int> costs = listCosts(window);
    ASSERT_EQ(costs.size(), expected.size());
    for (const auto& [candidate, cost] : costs)
    {
        const auto found = expected.find(candidate);
        ASSERT_NE(found, expected.end());
        EXPECT_GE(cost, found->second.least);
        EXPECT_LE(cost, found->second.greatest + LARGEST_CHANCES);
    }
}

/** The cost of the parts that are laid in the window. */
int addCosts(const LaidMap& laid, const std::vector<Index>& anchors, const std::map<Candidate, int>& costs)
{
    int sum = 0;
    for (const Index anchor : anchors)
    {
        const PartShape& shape = laid.map.getShape(anchor);
        sum += costs.at({anchor, shape.width, shape.depth, shape.height});
    }
    return sum;
}

/** Random cells in three colours: one lacks single bricks, one has few sizes. */
LayoutProblem makeProblem(const std::string& characters, bool isOfPlates, unsigned int seed)
{
    LayoutProblem problem = createRandomProblem({7, 6, 4}, characters, seed);
    problem.colors = {LayoutColor{0x7fe, 0x7ff}, LayoutColor{0x2b, 0x16}, LayoutColor{}};
    problem.isOfPlates = isOfPlates;
    problem.isHollow = true;
    return problem;
}

} // namespace

TEST(WindowBuilder, ListsThePartsOfALayerAtTheCostOfTheirSeamsAndContacts)
{
    std::mt19937 random(1);
    for (unsigned int seed = 0; seed < 60; ++seed)
    {
        // Of all cells, none, a third and nearly all may have any colour: 2000 for a leaf, and 9000 in a thin shell.
        const char* const characters = seed % 3 == 0 ? "aaaaab." : seed % 3 == 1 ? "aaac**." : "*****c.";
        LaidMap laid(makeProblem(characters, seed % 2 == 0, seed));
        laid.layRandomly(random);
        WindowBuilder window(laid.map, laid.sizes);
        for (int layer = 0; layer < 4; ++layer)
        {
            std::vector<Index> anchors = chooseParts(laid, layer, random);
            // Bricks reach into other layers, whose joints beside the window are unknown to a test of one layer.
            std::erase_if(anchors, [&](Index anchor) { return laid.map.getShape(anchor).height > 1; });
            build(window, anchors);
            const PlainWindow plain(laid, anchors, seed % 3 == 1 ? 9000 : 2000);
            EXPECT_TRUE(std::equal(window.getCells().begin(), window.getCells().end(), plain.getCells().begin(),
                                   plain.getCells().end()));
            expectCosts(window, plain.listCosts(false));
            EXPECT_EQ(window.getCost(), addCosts(laid, anchors, listCosts(window)));
        }
    }
}

TEST(WindowBuilder, ListsThePartsOfSeveralLayers)
{
    std::mt19937 random(2);
    for (unsigned int seed = 0; seed < 40; ++seed)
    {
        LaidMap laid(makeProblem(seed % 4 < 2 ? "aaaaab." : "aaac**.", seed % 2 == 0, seed));
        laid.layRandomly(random);
        WindowBuilder window(laid.map, laid.sizes);
        std::vector<Index> anchors = chooseParts(laid, -1, random);
        build(window, anchors);
        expectCosts(window, PlainWindow(laid, anchors, seed % 4 < 2 ? 2000 : 9000).listCosts(true));
    }
}

TEST(WindowBuilder, KeepsOnlyPartsThatContainBothOfTwoCellsOrNeither)
{
    std::mt19937 random(3);
    for (unsigned int seed = 0; seed < 20; ++seed)
    {
        LaidMap laid(makeProblem("aaac**.", false, seed));
        laid.layRandomly(random);
        WindowBuilder window(laid.map, laid.sizes);
        std::vector<Index> anchors = chooseParts(laid, 1, random);
        build(window, anchors);
        const Index cell = window.getCells()[random() % window.getCells().size()];
        const Index other = window.getCells()[random() % window.getCells().size()];
        std::map<Candidate, int> expected;
        for (const auto& [candidate, cost] : listCosts(window))
        {
            const auto [first, width, depth, height] = candidate;
            std::set<Index> cells;
            laid.map.visitCells(
                first,
                {static_cast<std::uint8_t>(width), static_cast<std::uint8_t>(depth), static_cast<std::uint8_t>(height)},
                [&cells](Index covered) { cells.insert(covered); });
            if (cells.contains(cell) == cells.contains(other)) expected.emplace(candidate, cost);
        }
        window.keepTogether(cell, other);
        EXPECT_EQ(listCosts(window), expected);
    }
}

} // namespace osgLego
