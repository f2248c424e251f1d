#include "../layout/LaidModel.h"

#include <osgLego/search/ComponentJoiner.h>
#include <osgLego/search/LayoutCosts.h>
#include <osgLego/search/LayoutWindow.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr LayoutColor ONLY_SINGLE_AND_DOUBLE{0b11, 0b11};

/** Two layers of four cells in a row, covered by parts of given lengths. */
class Row
{
public:
    explicit Row(const std::vector<std::vector<int>>& lengths) :
        problem(makeCells({4, 1, 2}, [](int, int, int) { return 0; }, {ONLY_SINGLE_AND_DOUBLE}))
    {
        CellLattice::Index cell = 0;
        for (const std::vector<int>& layer : lengths)
            for (const int length : layer)
            {
                map.lay(cell, {static_cast<std::uint8_t>(length), 1, 1});
                cell += length;
            }
    }

    int countComponents() const
    {
        LaidParts parts;
        for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
            if (map.isAnchor(cell))
                parts.push_back(
                    {problem.cells[static_cast<std::size_t>(cell)].place, {map.getShape(cell).width, 1, 1}, 0});
        return LaidModel(problem, parts).countComponents();
    }

    LayoutProblem problem;
    CellLattice lattice{problem};
    PartSizes sizes{problem};
    PartMap map{lattice};
    LayoutRegion region{0, 2, 0, 1, 0, 0, nullptr};
};

constexpr int MANY_NODES = 1000;

} // namespace

TEST(LayoutWindow, LaysNoFewerPartsThatSeparateOthers)
{
    // Two parts of two cells would suffice in the upper layer, but only the one in the middle connects those below.
    Row row({{2, 2}, {1, 2, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_FALSE(window.improve(4, 3, LayoutCosts::HALF_SEAM, row.region, MANY_NODES, random));
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(LayoutWindow, LaysFewerPartsThatSeparateNone)
{
    Row row({{1, 2, 1}, {1, 1, 1, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_TRUE(window.improve(4, 4, LayoutCosts::HALF_SEAM, row.region, MANY_NODES, random));
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(ComponentJoiner, JoinsComponentsAtTheCostOfAPart)
{
    Row row({{2, 2}, {2, 2}});
    ASSERT_EQ(row.countComponents(), 2);
    LayoutRandom random(1);
    EXPECT_TRUE(ComponentJoiner(row.map, row.sizes).joinAll({8, 100}, {}, random, {}));
    EXPECT_EQ(row.countComponents(), 1);
    EXPECT_EQ(row.map.countParts(), 5);
}

TEST(ComponentJoiner, LeavesInactiveCellsAndStopsIfItIsCancelled)
{
    Row row({{2, 2}, {2, 2}});
    LayoutRandom random(1);
    ComponentJoiner joiner(row.map, row.sizes);
    EXPECT_TRUE(joiner.joinAll({8, 100}, std::vector<bool>(8, false), random, {}));
    EXPECT_FALSE(joiner.joinAll({8, 100}, {}, random, [] { return true; }));
    EXPECT_EQ(row.countComponents(), 2);
}

} // namespace osgLego
