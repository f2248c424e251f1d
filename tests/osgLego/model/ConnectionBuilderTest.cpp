#include "ConnectionModels.h"

#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/ConnectionBuilder.h>
#include <osgLego/search/Layout.h>

#include "../layout/LaidModel.h"

#include <random>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Lay the cells, join the pieces, and check all that holds for every model. */
JoinedLayout connect(const ColoredCells& cells, ConnectionStatistics& statistics, Effort effort = Effort::NORMAL)
{
    LayoutOptions options;
    options.effort = effort;
    JoinedLayout layout{cells.problem, layOut(cells.problem, options), {}};
    ConnectionBuilder builder(options, cells.costs);
    EXPECT_TRUE(builder.build(layout));
    statistics = builder.getStatistics();
    EXPECT_EQ(findLayoutError(layout.problem, layout.parts), "");
    EXPECT_EQ(static_cast<std::size_t>(LaidModel(layout.problem, layout.parts).countComponents()),
              statistics.numPieces);
    EXPECT_EQ(layout.problem.cells.size(), cells.problem.cells.size() + statistics.numAddedCells);
    EXPECT_EQ(layout.added.size(), statistics.numAddedCells);
    return layout;
}

TEST(ConnectionBuilder, LeavesOnePieceUnchanged)
{
    const ColoredCells cells = drawColoredCells({{"aaaa", "aaaa"}, {"cccc", "cccc"}});
    ConnectionStatistics statistics;
    const JoinedLayout layout = connect(cells, statistics);
    EXPECT_EQ(layout.problem.cells, cells.problem.cells);
    EXPECT_EQ(layout.parts, layOut(cells.problem, {}));
    EXPECT_EQ(statistics.numPiecesBefore, 1u);
    EXPECT_EQ(statistics.numPieces, 1u);
}

TEST(ConnectionBuilder, JoinsAChessboardOfTowers)
{
    const ColoredCells cells =
        drawColoredCells({{"acac", "caca", "acac"}, {"acac", "caca", "acac"}, {"....", "....", "...."}});
    ConnectionStatistics statistics;
    connect(cells, statistics);
    EXPECT_EQ(statistics.numPiecesBefore, 12u);
    EXPECT_EQ(statistics.numPieces, 1u);
    EXPECT_LE(statistics.numAddedCells + statistics.numRecolored, 12u) << "a roof would suffice";
}

TEST(ConnectionBuilder, JoinsFlatPartsByCellsAboveThem)
{
    const ColoredCells cells = drawColoredCells({std::vector<std::string>(6, "aaaaaaaa"), {"........"}});
    for (const Effort effort : {Effort::NORMAL, Effort::BEST})
    {
        ConnectionStatistics statistics;
        connect(cells, statistics, effort);
        EXPECT_GT(statistics.numPiecesBefore, 1u);
        EXPECT_EQ(statistics.numPieces, 1u);
        EXPECT_LE(statistics.numAddedCells, 4u);
    }
}

TEST(ConnectionBuilder, UsesFewerPartsWithAllEffort)
{
    const ColoredCells cells =
        drawColoredCells({std::vector<std::string>(5, std::string(9, 'a')), {std::string(9, '.')}});
    ConnectionStatistics statistics;
    const std::size_t numParts = connect(cells, statistics, Effort::NORMAL).parts.size();
    EXPECT_LT(connect(cells, statistics, Effort::BEST).parts.size(), numParts);
    EXPECT_EQ(statistics.numPieces, 1u);
}

TEST(ConnectionBuilder, CountsCellsInAnotherColor)
{
    const ColoredCells cells = drawColoredCells({{"aaaab", "aaaaa"}, {"aaaa.", "aaaa."}});
    ConnectionStatistics statistics;
    const JoinedLayout layout = connect(cells, statistics);
    EXPECT_EQ(statistics.numPiecesBefore, 2u);
    EXPECT_EQ(statistics.numPieces, 1u);
    EXPECT_EQ(statistics.numAddedCells, 0u);
    EXPECT_EQ(statistics.numRecolored, 1u);
}

TEST(ConnectionBuilder, LeavesTheColorsOfASingleLayerWhichNoStudJoins)
{
    const ColoredCells cells = drawColoredCells({{"aacca", "ccaac", "acaca"}});
    ConnectionStatistics statistics;
    const JoinedLayout layout = connect(cells, statistics);
    EXPECT_EQ(layout.problem.cells, cells.problem.cells);
    EXPECT_GT(statistics.numPiecesBefore, 5u);
    EXPECT_EQ(statistics.numPieces, statistics.numPiecesBefore);
}

TEST(ConnectionBuilder, LeavesPiecesThatAreFarAway)
{
    const std::string far = "aa" + std::string(60, '.') + "c";
    ConnectionStatistics statistics;
    const ColoredCells cells = drawColoredCells({{far}, {far}, {far}});
    const JoinedLayout layout = connect(cells, statistics);
    EXPECT_EQ(statistics.numPieces, 2u);
    EXPECT_EQ(statistics.numAddedCells, 0u);
    EXPECT_EQ(layout.problem.cells, cells.problem.cells);
}

TEST(ConnectionBuilder, KeepsNoPartWithoutWhichTheModelIsOnePiece)
{
    // Two halves of a closed box.
    const std::vector<std::string> wall(6, "aaaaccc");
    const std::vector<std::string> ring{"aaaaccc", "a.....c", "a.....c", "a.....c", "a.....c", "aaaaccc"};
    const ColoredCells cells = drawColoredCells({wall, ring, ring, ring, wall});
    ConnectionStatistics statistics;
    const JoinedLayout layout = connect(cells, statistics);
    EXPECT_EQ(statistics.numPieces, 1u);
    EXPECT_GT(statistics.numAddedCells, 0u);
    for (std::size_t part = 0; part < layout.parts.size(); ++part)
    {
        const LaidPart& laid = layout.parts[part];
        if (laid.place[0] == 0 || laid.place[1] == 0 || laid.place[2] == 0 || laid.place[0] + laid.size[0] == 7 ||
            laid.place[1] + laid.size[1] == 6 || laid.place[2] == 4)
            continue;
        LaidParts rest = layout.parts;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(part));
        EXPECT_GT(LayoutPieces(rest).getCount(), 1u);
    }
}

TEST(ConnectionBuilder, JoinsPartsThatComeLooseWhenOthersAreJoined)
{
    // Of 400 random models, those in which a last piece is joined only by parts that others need.
    for (const unsigned seed : {44u, 253u, 270u, 316u})
    {
        std::mt19937 random(seed);
        const unsigned side = 5 + seed % 4;
        std::vector<std::vector<std::string>> layers(3 + seed % 2,
                                                     std::vector<std::string>(side, std::string(side, 'a')));
        for (std::vector<std::string>& layer : layers)
            for (std::string& row : layer)
                for (char& cell : row)
                    cell = "aacb."[random() % 5];
        ConnectionStatistics statistics;
        connect(drawColoredCells(layers), statistics);
        EXPECT_GT(statistics.numPiecesBefore, 5u);
        EXPECT_EQ(statistics.numPieces, 1u) << seed;
    }
}

TEST(ConnectionBuilder, CanBeCancelled)
{
    const ColoredCells cells = drawColoredCells({{"acac", "caca"}, {"acac", "caca"}, {"....", "...."}});
    JoinedLayout layout{cells.problem, layOut(cells.problem, {}), {}};
    LayoutOptions options;
    options.isCancelled = [] { return true; };
    EXPECT_FALSE(ConnectionBuilder(options, cells.costs).build(layout));
}

} // namespace

} // namespace osgLego
