#include "LayoutRow.h"
#include "RandomLayout.h"

#include <osgLego/PartType.h>
#include <osgLego/search/PartCut.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A layer of cells of one colour, covered by one part. */
struct CoveredLayer : LaidMap
{
    CoveredLayer(const std::vector<std::string>& rows, const PartShape& shape, const LayoutColor& color = {}) :
        LaidMap(makeLayer(rows, color))
    {
        map.lay(0, shape);
    }

    static LayoutProblem makeLayer(const std::vector<std::string>& rows, const LayoutColor& color)
    {
        LayoutProblem problem = drawProblem({rows});
        problem.colors.assign(1, color);
        return problem;
    }

    /** The parts after another one is laid; empty if that can't be. */
    LaidParts cut(const PartCut::Piece& piece)
    {
        PartCut partCut(map, sizes);
        if (!partCut.cover(piece, region) || !partCut.divide()) return {};
        for (const PartCut::Piece& laid : partCut.getPieces())
            map.lay(laid.anchor, laid.shape);
        return getParts();
    }

    LayoutRegion region{0, 1, 0, 8, 0, 0, nullptr};
};

TEST(PartCut, DividesTheRestOfAPartIntoTheFewestStrips)
{
    // Across the whole part, or between two such strips, whichever are fewer.
    CoveredLayer middle({"aaaaaaaa", "aaaaaaaa"}, {8, 2, 1});
    EXPECT_EQ(middle.cut({2, {2, 1, 1}}), (LaidParts{{{0, 0, 0}, {2, 2, 1}, 0},
                                                     {{2, 0, 0}, {2, 1, 1}, 0},
                                                     {{4, 0, 0}, {4, 2, 1}, 0},
                                                     {{2, 1, 0}, {2, 1, 1}, 0}}));
    CoveredLayer corner({"aaaaaa", "aaaaaa"}, {6, 2, 1});
    EXPECT_EQ(corner.cut({0, {1, 2, 1}}),
              (LaidParts{{{0, 0, 0}, {1, 2, 1}, 0}, {{1, 0, 0}, {3, 2, 1}, 0}, {{4, 0, 0}, {2, 2, 1}, 0}}));
}

TEST(PartCut, LaysNoPartThatWasNeverMadeOrThatLeavesSuchAPart)
{
    const LayoutColor oneTwoAndFour{0b1011, 0b1011};
    EXPECT_TRUE(CoveredLayer({"aaaa"}, {4, 1, 1}, oneTwoAndFour).cut({0, {3, 1, 1}}).empty());
    EXPECT_TRUE(CoveredLayer({"aaaa"}, {4, 1, 1}, oneTwoAndFour).cut({0, {1, 1, 1}}).empty());
    EXPECT_EQ(CoveredLayer({"aaaa"}, {4, 1, 1}, oneTwoAndFour).cut({0, {2, 1, 1}}).size(), 2u);
    EXPECT_TRUE(CoveredLayer({"aaaa"}, {4, 1, 1}).cut({2, {3, 1, 1}}).empty()) << "a cell is missing";
}

TEST(PartCut, CutsBricksHorizontallyIntoPlates)
{
    LayoutProblem problem = drawProblem({{"aa"}, {"aa"}, {"aa"}});
    problem.isOfPlates = true;
    LaidMap laid(problem);
    laid.map.lay(0, {2, 1, 3});
    PartCut cut(laid.map, laid.sizes);
    const LayoutRegion region{0, 3, 0, 1, 0, 0, nullptr};
    ASSERT_TRUE(cut.cover({2, {1, 1, 1}}, region));
    ASSERT_TRUE(cut.divide());
    EXPECT_EQ(cut.countAdded(), 3);
    EXPECT_TRUE(cut.keepsConnections());
}

TEST(PartCut, LeavesInactiveParts)
{
    LayoutRow row({{2, 2}, {2, 2}});
    const std::vector<bool> isActive{true, true, false, false, true, true, true, true};
    row.region.activeCells = &isActive;
    PartCut cut(row.map, row.sizes);
    EXPECT_FALSE(cut.cover({1, {2, 1, 1}}, row.region));
    EXPECT_TRUE(cut.cover({5, {2, 1, 1}}, row.region));
}

TEST(PartCut, SeesStripsThatTouchNothing)
{
    LaidMap laid(drawProblem({{"aaaa"}, {"aa.."}}));
    laid.map.lay(0, {4, 1, 1});
    laid.map.lay(4, {2, 1, 1});
    const LayoutRegion region{0, 2, 0, 1, 0, 0, nullptr};
    PartCut cut(laid.map, laid.sizes);
    ASSERT_TRUE(cut.cover({0, {2, 1, 1}}, region) && cut.divide());
    EXPECT_FALSE(cut.touchesAll());
    EXPECT_FALSE(cut.keepsConnections());
    ASSERT_TRUE(cut.cover({1, {3, 1, 1}}, region) && cut.divide());
    EXPECT_TRUE(cut.touchesAll());
    EXPECT_TRUE(cut.keepsConnections());
}

/** Calls a function with each part in each place of a layout. */
template <typename Visit>
void forEachPart(const RandomLayout& laid, Visit visit)
{
    for (CellLattice::Index anchor = 0; anchor < laid.lattice.getNumCells(); ++anchor)
        for (const auto& [shorter, longer] : PART_SIZES)
            for (const int height : laid.sizes.getHeights())
                for (const auto& [width, depth] : {std::pair(shorter, longer), std::pair(longer, shorter)})
                    visit(PartCut::Piece{anchor,
                                         {static_cast<std::uint8_t>(width), static_cast<std::uint8_t>(depth),
                                          static_cast<std::uint8_t>(height)}});
}

TEST(PartCut, NeverSeparatesPartsIfItKeepsConnections)
{
    int numLaid = 0;
    int numJoined = 0;
    int numRefused = 0;
    for (unsigned int seed = 0; seed < 24; ++seed)
    {
        RandomLayout laid(seed % 3 == 0 ? "aaaaaa*." : "aaab..", seed % 2 == 0, seed);
        PartCut cut(laid.map, laid.sizes);
        int numComponents = laid.countComponents();
        int numParts = laid.map.countParts();
        forEachPart(laid,
                    [&](const PartCut::Piece& piece)
                    {
                        if (!cut.cover(piece, laid.region)) return;
                        UnionFind components;
                        laid.map.findComponents(components);
                        const bool touchesSeveral = cut.touchesSeveral(components);
                        if (!cut.divide() || !cut.touchesAll()) return;
                        if (!cut.keepsConnections())
                        {
                            ++numRefused;
                            return;
                        }
                        for (const PartCut::Piece& laidPiece : cut.getPieces())
                            laid.map.lay(laidPiece.anchor, laidPiece.shape);
                        const int numLeft = laid.countComponents();
                        ASSERT_LE(numLeft, touchesSeveral ? numComponents - 1 : numComponents) << "model " << seed;
                        ASSERT_EQ(laid.map.countParts(), numParts + cut.countAdded()) << "model " << seed;
                        ++numLaid;
                        numJoined += touchesSeveral ? 1 : 0;
                        numComponents = numLeft;
                        numParts = laid.map.countParts();
                    });
    }
    EXPECT_GT(numLaid, 1000);
    EXPECT_GT(numJoined, 40);
    EXPECT_GT(numRefused, 100);
}

} // namespace

} // namespace osgLego
