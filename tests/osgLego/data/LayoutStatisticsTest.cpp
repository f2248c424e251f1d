#include <osgLego/LayoutStatistics.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(LayoutStatistics, TheReportNamesEveryFigure)
{
    LayoutStatistics layout;
    layout.numCells = 2955;
    layout.numInterior = 12;
    layout.numParts = 997;
    layout.numColors = 24;
    layout.numComponents = 3;
    layout.numComponentsPossible = 2;
    layout.numFloating = 5;
    layout.numArticulationParts = 1;
    layout.stackedSeams = 0.0625;
    layout.stackedLength = 72;
    layout.meanColorError = 0.0619;
    layout.maximumColorError = 0.12066;
    EXPECT_EQ(layout.toString(),
              "997 parts in 24 colours for 2955 cells, 12 of them inside\n"
              "3 pieces, where the cells allow 2; 5 parts float, and 1 part holds a piece together alone\n"
              "stacked seams: 6.2 %, a length of 72; colour error: 0.062 on average, at most 0.121 in Oklab");
    layout.lowerBound = 990;
    layout.numUnavailable = 2;
    EXPECT_NE(layout.toString().find("inside; the fewest possible, layer by layer: 990\n"), std::string::npos);
    EXPECT_NE(layout.toString().find("\n2 parts have sizes that were never made in their colour"), std::string::npos);
}

} // namespace

} // namespace osgLego
