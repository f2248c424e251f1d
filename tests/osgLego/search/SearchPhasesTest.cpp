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
    const Phases sequence{{10, 1000}, {10, 500}, {10, 250}, {10, 125}};
    Phases twice = sequence;
    twice.push_back({5, 0});
    twice.insert(twice.end(), sequence.begin(), sequence.end());
    EXPECT_EQ(lowerPhases(85, 1000), twice);
    EXPECT_EQ(lowerPhases(12, 1000), (Phases{{3, 1000}, {3, 500}, {3, 250}, {3, 125}}));
    EXPECT_EQ(lowerPhases(4, 1000), (Phases{{1, 1000}, {1, 500}, {1, 250}, {1, 125}}));
}

TEST(SearchPhases, HaveAboutAsManyRoundsAsWanted)
{
    for (int numRounds = 4; numRounds < 300; ++numRounds)
    {
        EXPECT_EQ(countRounds(alternatePhases(numRounds, 1)), numRounds);
        const int lowered = countRounds(lowerPhases(numRounds, 1000));
        EXPECT_LE(lowered, numRounds);
        EXPECT_GT(lowered, numRounds - 45);
        EXPECT_GT(2 * lowered, numRounds);
    }
}

} // namespace osgLego
