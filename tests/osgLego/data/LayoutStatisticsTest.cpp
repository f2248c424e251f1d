#include <osgLego/LayoutStatistics.h>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

std::string getLastLine(const LayoutStatistics& layout)
{
    const std::string text = layout.toString();
    return text.substr(text.rfind('\n') + 1);
}

TEST(LayoutStatistics, TheReportNamesEveryFigure)
{
    LayoutStatistics layout;
    layout.numCells = 2955;
    layout.numInterior = 12;
    layout.numParts = 997;
    layout.numColors = 24;
    layout.size = glm::dvec3(208.0, 160.0, 192.04);
    layout.numComponents = 3;
    layout.numComponentsPossible = 2;
    layout.numFloating = 5;
    layout.numArticulationParts = 1;
    layout.stackedSeams = 0.0625;
    layout.stackedLength = 72;
    layout.meanColorError = 3.46;
    layout.maximumColorError = 12.06;
    EXPECT_EQ(layout.toString(),
              "997 parts in 24 colours for 2955 cells, 12 of them inside\n"
              "size: 20.8 cm wide, 16.0 cm deep and 19.2 cm high\n"
              "3 pieces (these cells need at least 2); 5 parts float; parts without which a piece would fall apart: 1\n"
              "seams above seams: 6.2 %, 72 studs long; colour error: 3.5 on average, at most 12.1 in CIEDE2000");
    layout.lowerBound = 990;
    layout.numUnavailable = 2;
    layout.numComponents = layout.numComponentsPossible = 1;
    EXPECT_NE(layout.toString().find(" high\n1 piece; 5 parts float; "), std::string::npos) << layout.toString();
    EXPECT_NE(layout.toString().find("inside; the fewest possible, layer by layer: 990\n"), std::string::npos);
    EXPECT_NE(layout.toString().find("\n2 parts have sizes that were never made in their colour"), std::string::npos);
}

TEST(LayoutStatistics, TheReportSaysHowTheModelWasMadeToStand)
{
    const auto describe = [](const SupportStatistics& support)
    {
        LayoutStatistics layout;
        layout.support = support;
        return getLastLine(layout);
    };
    EXPECT_EQ(describe({true, false, 0, 0, 0, 0}), "support: the model stands without it");
    EXPECT_EQ(describe({true, true, 0, 0, 0, 0}), "support: parts were laid again; the model stands");
    EXPECT_EQ(describe({true, false, 0, 1, 4, 0}), "support: 1 column of 4 parts was added; the model stands");
    EXPECT_EQ(describe({false, true, 0, 2, 1, 0}),
              "support: parts were laid again, and 2 columns of 1 part were added; the model still falls");
    EXPECT_EQ(describe({false, false, 0, 0, 0, 0}), "support: nothing was found that helps; the model still falls");
    EXPECT_EQ(describe({true, true, 12, 1, 3, 0}),
              "support: parts were laid again, 12 hidden cells were added, and 1 column of 3 parts was added; "
              "the model stands");
    EXPECT_EQ(describe({false, false, 0, 2, 8, 2}),
              "support: 2 columns of 8 parts were added; 2 loose pieces stand on columns of their own");
}

TEST(LayoutStatistics, TheReportTellsOfColumnsForSubmodelsAndOfSubmodelsBeyondTheLimits)
{
    LayoutStatistics layout;
    layout.support = {
        .numColumns = 3, .numColumnParts = 9, .numBuildingColumns = 2, .largestSubmodel = 150, .deepestSubmodel = 3};
    const auto describe = [&] { return layout.toString().substr(layout.toString().find("support")); };
    EXPECT_EQ(describe(), "support: 3 columns of 9 parts were added, 2 of them for an easier building plan; "
                          "the model stands");
    layout.support = {.largestSubmodel = 151, .deepestSubmodel = 1};
    EXPECT_EQ(describe(), "support: the model stands without it\n"
                          "building: its largest submodel has 151 parts, where 150 are easy: "
                          "no columns were found that help");
    layout.support = {
        .numColumns = 1, .numColumnParts = 2, .numBuildingColumns = 1, .largestSubmodel = 8, .deepestSubmodel = 4};
    EXPECT_NE(describe().find("building: its submodels are nested in 4 levels, where 3 are easy: "), std::string::npos);
    EXPECT_NE(describe().find("no more columns were found"), std::string::npos);
    layout.support = {.numFallingSteps = 5};
    EXPECT_EQ(describe(), "support: the model stands without it");
    layout.support = {.numFallingSteps = 6};
    EXPECT_NE(describe().find("building: something has to be held after 6 steps, where 5 are easy: "),
              std::string::npos);
    layout.support = {.largestSubmodel = 200, .deepestSubmodel = 1, .numFallingSteps = 6};
    EXPECT_NE(describe().find("200 parts, where 150 are easy; something has to be held after 6 steps"),
              std::string::npos);
}

TEST(LayoutStatistics, TheReportSaysWhichPiecesAreNotJoined)
{
    LayoutStatistics layout;
    const auto describe = [&] { return layout.toString().substr(layout.toString().find("connections")); };
    layout.connection = ConnectionStatistics{};
    EXPECT_EQ(describe(), "connections: the model is one piece without changes");
    layout.connection = ConnectionStatistics{20, 1, 35, 12, {}, 0.0};
    EXPECT_EQ(describe(), "connections: 20 pieces became one by 35 added cells and 12 cells in another colour");
    layout.connection = ConnectionStatistics{3, 2, 1, 1, {{4, {1, 2, 3}, {5, 6, 7}}}, 0.0};
    EXPECT_EQ(describe(), "connections: 3 pieces became 2 by 1 added cell and 1 cell in another colour\n"
                          "  not joined: 4 parts in the cells (1, 2, 3) to (5, 6, 7)");
    layout.connection = ConnectionStatistics{3, 3, 0, 0, {}, 0.0};
    EXPECT_EQ(describe(), "connections: 3 pieces remain");
}

TEST(LayoutStatistics, TheReportSaysThatSupportJoinedPieces)
{
    const auto describe = [](const ConnectionStatistics& connection)
    {
        LayoutStatistics layout;
        layout.connection = connection;
        return getLastLine(layout);
    };
    ConnectionStatistics connection;
    connection.numPiecesBefore = 4;
    connection.numPieces = 4;
    EXPECT_EQ(describe(connection), "connections: 4 pieces remain");
    connection.isSupported = true;
    connection.numPieces = 1;
    EXPECT_EQ(describe(connection), "connections: 4 pieces became one by support");
    connection.numAddedCells = 3;
    connection.numPieces = 2;
    EXPECT_EQ(describe(connection),
              "connections: 4 pieces became 2 by 3 added cells and 0 cells in another colour, and by support");
}

TEST(LayoutStatistics, TheReportListsTheFirstOfManyPiecesThatAreNotJoined)
{
    LayoutStatistics layout;
    const auto countLines = [&](std::size_t numLoose)
    {
        layout.connection = ConnectionStatistics{
            numLoose + 1, numLoose + 1, 0, 0, std::vector<LoosePiece>(numLoose, {1, {1, 2, 3}, {1, 2, 3}}), 0.0};
        const std::string text = layout.toString();
        return std::count(text.begin(), text.end(), '\n');
    };
    const auto none = countLines(0);
    EXPECT_EQ(countLines(6), none + 6);
    EXPECT_EQ(countLines(7), none + 6);
    EXPECT_EQ(countLines(100), none + 6);
    EXPECT_NE(layout.toString().find("(1, 2, 3)\n  not joined: 95 more pieces"), std::string::npos)
        << layout.toString();
}

TEST(LayoutStatistics, TheReportLeavesOutWhatThereIsNoneOf)
{
    EXPECT_EQ(LayoutStatistics().toString().find("float"), std::string::npos);
}

} // namespace

} // namespace osgLego
