#include "../layout/LaidModel.h"

#include <osgLego/layout/PartColors.h>
#include <osgLego/search/BestLayout.h>
#include <osgLego/search/LayoutCosts.h>

#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Layers of cells in a row, covered by parts of given lengths. */
class Rows
{
public:
    explicit Rows(int length, int numLayers, const LayoutColor& color = {}) :
        problem(makeCells({length, 1, numLayers}, [](int, int, int) { return 0; }, {color}))
    {
    }

    PartMap lay(const std::vector<int>& lengths) const
    {
        PartMap map(lattice);
        CellLattice::Index cell = 0;
        for (const int length : lengths)
        {
            map.lay(cell, {static_cast<std::uint8_t>(length), 1, 1});
            cell += length;
        }
        return map;
    }

    /** The parts of the layout that is kept of two. */
    LaidParts findBetter(const std::vector<int>& first, const std::vector<int>& second) const
    {
        BestLayout best(sizes, LayoutCosts::HALF_SEAM);
        best.add(lay(first));
        PartMap map = lay(second);
        best.restore(map);
        return getParts(map);
    }

    /** Expect that a layout is better than another, whichever comes first. */
    void expectBetter(const std::vector<int>& better, const std::vector<int>& worse) const
    {
        const LaidParts expected = getParts(lay(better));
        EXPECT_EQ(findBetter(better, worse), expected);
        EXPECT_EQ(findBetter(worse, better), expected);
    }

    LaidParts getParts(const PartMap& map) const { return collectParts(map, sizes); }

    LayoutProblem problem;
    CellLattice lattice{problem};
    PartSizes sizes{problem};
};

} // namespace

TEST(BestLayout, HasFewerParts)
{
    Rows(4, 1).expectBetter({4}, {2, 2});
}

TEST(BestLayout, HasFewerStackedSeams)
{
    // The long part below connects all.
    Rows(6, 3).expectBetter({6, 2, 4, 4, 2}, {6, 2, 4, 2, 4});
}

TEST(BestLayout, HasAPartMoreToAvoidSixStackedSeamsButNotFour)
{
    // The lowest layer connects the next one, on which the highest one has its joints or none of them.
    Rows(14, 3).expectBetter({1, 8, 4, 1, 2, 2, 2, 2, 2, 2, 2, 1, 2, 2, 2, 2, 2, 2, 1},
                             {1, 8, 4, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2});
    Rows(10, 3).expectBetter({1, 8, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2}, {1, 8, 1, 2, 2, 2, 2, 2, 1, 2, 2, 2, 2, 1});
}

TEST(BestLayout, HasFewerComponents)
{
    Rows(8, 2).expectBetter({4, 4, 2, 4, 2}, {4, 4, 4, 4});
}

TEST(BestLayout, HasFewerPartsThatWereNeverMade)
{
    const LayoutColor noSingle{0b1110, 0b1110};
    Rows(5, 1, noSingle).expectBetter({2, 3}, {4, 1});
}

TEST(BestLayout, IsTheBestOfAll)
{
    const Rows rows(6, 1);
    BestLayout best(rows.sizes, LayoutCosts::HALF_SEAM);
    best.add(rows.lay({3, 2, 1}));
    best.add(rows.lay({4, 2}));
    best.add(rows.lay({1, 2, 1, 2}));
    PartMap map = rows.lay({2, 2, 2});
    best.restore(map);
    EXPECT_EQ(rows.getParts(map), rows.getParts(rows.lay({4, 2})));
}

TEST(BestLayout, WithMorePartsThanTheLimitIsWorseThanAnyOther)
{
    // Six stacked seams cost more than a part.
    const Rows rows(14, 3);
    const std::vector<int> manyParts{1, 8, 4, 1, 2, 2, 2, 2, 2, 2, 2, 1, 2, 2, 2, 2, 2, 2, 1};
    const std::vector<int> manySeams{1, 8, 4, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2};
    BestLayout best(rows.sizes, LayoutCosts::HALF_SEAM);
    best.limit(rows.lay(manySeams));
    best.add(rows.lay(manyParts));
    best.add(rows.lay(manySeams));
    PartMap map = rows.lay(manyParts);
    best.restore(map);
    EXPECT_EQ(rows.getParts(map), rows.getParts(rows.lay(manySeams)));
}

TEST(BestLayout, WithMoreComponentsThanTheLimitIsWorseThanOneWithMoreParts)
{
    // Thirteen parts cost more than a component.
    const Rows rows(16, 2);
    const std::vector<int> joined{1, 1, 1, 2, 1, 1, 1, 1, 1, 1, 2, 1, 1, 1, 4, 8, 4};
    const std::vector<int> apart{8, 8, 8, 8};
    for (const auto& [limit, expected] : {std::pair(joined, joined), std::pair(apart, apart)})
    {
        BestLayout best(rows.sizes, LayoutCosts::HALF_SEAM);
        best.limit(rows.lay(limit));
        best.add(rows.lay(joined));
        PartMap map = rows.lay(apart);
        best.restore(map);
        EXPECT_EQ(rows.getParts(map), rows.getParts(rows.lay(expected)));
    }
}

TEST(BestLayout, WithoutAnyLeavesTheLayout)
{
    const Rows rows(6, 1);
    PartMap map = rows.lay({2, 2, 2});
    BestLayout(rows.sizes, LayoutCosts::HALF_SEAM).restore(map);
    EXPECT_EQ(rows.getParts(map), rows.getParts(rows.lay({2, 2, 2})));
}

} // namespace osgLego
