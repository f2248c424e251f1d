#include <osgLego/search/SearchPhases.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Phases = std::vector<SearchPhase>;

int countRounds(const Phases& phases)
{
    int numRounds = 0;
    for (const SearchPhase& phase : phases)
        numRounds += phase.numRounds;
    return numRounds;
}

} // namespace

TEST(SearchPhases, AlternateAndEndWithSeams)
{
    EXPECT_EQ(alternatePhases(250, 7), (Phases{{10, 7},
                                               {20, 0},
                                               {20, 7},
                                               {20, 0},
                                               {20, 7},
                                               {20, 0},
                                               {20, 7},
                                               {20, 0},
                                               {20, 7},
                                               {20, 0},
                                               {20, 7},
                                               {20, 0},
                                               {20, 7}}));
    EXPECT_EQ(alternatePhases(40, 7), (Phases{{20, 0}, {20, 7}}));
    EXPECT_EQ(alternatePhases(12, 7), (Phases{{6, 0}, {6, 7}}));
    EXPECT_EQ(alternatePhases(13, 7), (Phases{{1, 7}, {6, 0}, {6, 7}}));
}

TEST(SearchPhases, OfFewRoundsAllCountSeams)
{
    EXPECT_EQ(alternatePhases(11, 7), (Phases{{11, 7}}));
    EXPECT_EQ(alternatePhases(1, 7), (Phases{{1, 7}}));
    EXPECT_TRUE(alternatePhases(0, 7).empty());
}

TEST(SearchPhases, LowerTheCostOfSeamsAndBeginAgain)
{
    EXPECT_EQ(lowerPhases(70, 1000),
              (Phases{{10, 1000}, {10, 500}, {10, 250}, {5, 0}, {10, 1000}, {10, 500}, {10, 250}}));
    EXPECT_EQ(lowerPhases(12, 1000), (Phases{{4, 1000}, {4, 500}, {4, 250}}));
    EXPECT_EQ(lowerPhases(3, 1000), (Phases{{1, 1000}, {1, 500}, {1, 250}}));
}

TEST(SearchPhases, HaveAboutAsManyRoundsAsWanted)
{
    for (int numRounds = 3; numRounds < 300; ++numRounds)
    {
        EXPECT_EQ(countRounds(alternatePhases(numRounds, 1)), numRounds);
        const int lowered = countRounds(lowerPhases(numRounds, 1000));
        EXPECT_LE(lowered, numRounds);
        EXPECT_GT(lowered, numRounds - 35);
        EXPECT_GT(2 * lowered, numRounds);
    }
}

} // namespace osgLego
