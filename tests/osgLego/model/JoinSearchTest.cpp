#include "ConnectionModels.h"

#include <osgLego/model/JoinSearch.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** The cheapest join of the smallest piece of a layout in as few pieces as possible. */
std::optional<Join> findJoin(const ColoredCells& cells, const JoinSearch::Penalties& penalties = {})
{
    const LayoutPieces pieces(layOut(cells.problem, {}));
    EXPECT_EQ(pieces.getCount(), 2u);
    PieceMap map(cells.problem, pieces);
    const CellExposure exposure(cells.problem);
    JoinSearch search(map, exposure, cells.costs, penalties);
    return search.find(1);
}

TEST(JoinSearch, RecolorsAStrayCellThatDiffersLittle)
{
    const ColoredCells cells = drawColoredCells({{"aaaab", "aaaaa"}, {"aaa..", "aaa.."}});
    const LayoutPieces pieces({{{0, 0, 0}, {4, 2, 1}}, {{0, 0, 1}, {3, 2, 1}}, {{4, 0, 0}, {1, 1, 1}, 1}, {{4, 1, 0}}});
    PieceMap map(cells.problem, pieces);
    const CellExposure exposure(cells.problem);
    const JoinSearch::Penalties penalties;
    JoinSearch search(map, exposure, cells.costs, penalties);
    const std::optional<Join> join = search.find(1);
    ASSERT_TRUE(join);
    EXPECT_TRUE(join->added.empty());
    ASSERT_EQ(join->recolored.size(), 1u);
    EXPECT_EQ(join->recolored[0].cell, glm::ivec3(4, 0, 0));
    EXPECT_EQ(join->recolored[0].color, 0);
}

TEST(JoinSearch, FillsTheGapBetweenTwoTowersByOneCell)
{
    const ColoredCells cells = drawColoredCells({{"aa.a"}, {"aa.a"}, {"aa.a"}});
    const std::optional<Join> join = findJoin(cells);
    ASSERT_TRUE(join);
    EXPECT_TRUE(join->recolored.empty());
    ASSERT_EQ(join->added.size(), 1u);
    EXPECT_EQ(join->added[0].cell.x, 2);
    EXPECT_EQ(join->added[0].color, 0) << "one part must cover the gap and both sides";
}

TEST(JoinSearch, AddsHiddenCellsWhereNoPartMayCoverBothColors)
{
    // A closed box, half of it red and half white.
    const std::vector<std::string> wall(5, "aaaccc");
    const std::vector<std::string> ring{"aaaccc", "a....c", "a....c", "a....c", "aaaccc"};
    const ColoredCells cells = drawColoredCells({wall, ring, ring, wall});
    const std::optional<Join> join = findJoin(cells);
    ASSERT_TRUE(join);
    EXPECT_TRUE(join->recolored.empty()) << "white differs much from red";
    ASSERT_EQ(join->added.size(), 2u);
    for (const Join::Change& change : join->added)
        EXPECT_EQ(ring[static_cast<std::size_t>(change.cell.y)][static_cast<std::size_t>(change.cell.x)], '.');
}

TEST(JoinSearch, RecolorsAVisibleCellIfCellsWouldHaveToBeAddedInPlainView)
{
    const std::optional<Join> join = findJoin(drawColoredCells({{"aac"}, {"aac"}, {"..."}}));
    ASSERT_TRUE(join);
    EXPECT_TRUE(join->added.empty());
    EXPECT_EQ(join->recolored.size(), 1u);
}

TEST(JoinSearch, CostsMoreWhereAnEarlierJoinFailed)
{
    const ColoredCells cells = drawColoredCells({{"aa.a"}, {"aa.a"}, {"aa.a"}});
    const std::optional<Join> join = findJoin(cells);
    ASSERT_TRUE(join);
    const glm::ivec3 cell = join->added[0].cell;
    const std::optional<Join> other = findJoin(cells, {.changes = {{toCellKey(cell), 10.0}}, .directSteps = {}});
    ASSERT_TRUE(other);
    EXPECT_NE(other->added[0].cell, cell);
}

TEST(JoinSearch, PrefersOtherChangesWhereADirectStepFailed)
{
    const std::vector<std::string> wall(2, "aaaa");
    const ColoredCells cells = drawColoredCells({wall, wall, {"....", "...."}});
    const LayoutPieces pieces(
        {{{0, 0, 0}, {2, 2, 1}}, {{2, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {2, 2, 1}}, {{2, 0, 1}, {2, 2, 1}}});
    const auto find = [&](const JoinSearch::Penalties& penalties)
    {
        PieceMap map(cells.problem, pieces);
        const CellExposure exposure(cells.problem);
        return JoinSearch(map, exposure, cells.costs, penalties).find(1);
    };
    const std::optional<Join> direct = find({});
    ASSERT_TRUE(direct);
    EXPECT_TRUE(direct->added.empty());
    JoinSearch::Penalties penalties;
    for (const int x : {1, 2})
        for (const int y : {0, 1})
            for (const int z : {0, 1})
                penalties.directSteps[toCellKey({x, y, z})] = 10.0;
    const std::optional<Join> other = find(penalties);
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->added.empty());
}

TEST(JoinSearch, AddsCellsAboveFlatPartsThatNoPartBesideThemJoins)
{
    const ColoredCells cells = drawColoredCells({std::vector<std::string>(4, "aaaaaaaa"), {"........"}});
    const std::optional<Join> join = findJoin(cells);
    ASSERT_TRUE(join);
    EXPECT_EQ(join->added.size(), 2u) << "one part across both";
}

TEST(JoinSearch, ExtendsARowOnlyAsFarAsPartsReach)
{
    const std::optional<Join> join = findJoin(drawColoredCells({{"bbba"}, {"...a"}, {"...a"}}));
    ASSERT_TRUE(join);
    EXPECT_TRUE(join->added.empty());
    EXPECT_EQ(join->recolored.size(), 1u);
    const std::optional<Join> longer = findJoin(drawColoredCells({{"bbbbbbbba"}, {"........a"}, {"........a"}}));
    ASSERT_TRUE(longer);
    EXPECT_FALSE(longer->added.empty()) << "no part is nine long";
}

TEST(JoinSearch, KnowsWhichPiecesNoLayoutConnects)
{
    // The colour has no part of 1x2, so that columns are joined by added cells only.
    ColoredCells cells = drawColoredCells({{"aa"}, {"aa"}, {".."}});
    cells.problem.colors[0].bricks = 1;
    cells.problem.colors[0].plates = 1;
    const LayoutPieces pieces(
        {{{0, 0, 0}, {1, 1, 1}}, {{0, 0, 1}, {1, 1, 1}}, {{1, 0, 0}, {1, 1, 1}}, {{1, 0, 1}, {1, 1, 1}}});
    PieceMap map(cells.problem, pieces);
    const CellExposure exposure(cells.problem);
    const JoinSearch::Penalties penalties;
    const std::optional<Join> join = JoinSearch(map, exposure, cells.costs, penalties).find(1);
    ASSERT_TRUE(join);
    EXPECT_EQ(join->added.size(), 2u);
}

TEST(JoinSearch, FindsNothingFarAway)
{
    const std::string far = "aa" + std::string(60, '.') + "a";
    EXPECT_FALSE(findJoin(drawColoredCells({{far}, {far}, {far}})));
}

TEST(JoinSearch, DoesNotTurnWithinALayer)
{
    // Towers that are diagonal neighbours: a cell beside both is in one part with one of them only.
    const ColoredCells cells = drawColoredCells({{"aa.", "aa.", "..a"}, {"aa.", "aa.", "..a"}});
    const std::optional<Join> join = findJoin(cells);
    ASSERT_TRUE(join);
    EXPECT_EQ(join->added.size(), 2u);
}

} // namespace

} // namespace osgLego
