#include <osgLego/design/ResolutionSearch.h>

#include <osgLego/LegoSettings.h>

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

struct Outcome
{
    unsigned int best = 0;
    int numTries = 0;
};

Outcome search(std::size_t mostParts, unsigned int first, const std::function<std::size_t(unsigned int)>& count)
{
    ResolutionSearch search(mostParts, first);
    Outcome outcome;
    while (const std::optional<unsigned int> resolution = search.getNext())
    {
        EXPECT_GE(*resolution, 1u);
        EXPECT_LE(*resolution, LegoSettings::MAXIMUM_RESOLUTION);
        search.add(*resolution, count(*resolution));
        if (++outcome.numTries > 1024) break;
    }
    outcome.best = search.getBest();
    return outcome;
}

TEST(ResolutionSearch, FindsTheHighestResolutionWithFewEnoughParts)
{
    for (const double power : {1.0, 1.7, 2.0, 2.4, 3.0})
        for (const std::size_t mostParts : {1u, 10u, 500u, 10000u})
            for (const unsigned int first : {1u, 24u, 1024u})
            {
                const auto count = [power](unsigned int resolution)
                { return static_cast<std::size_t>(std::ceil(0.7 * std::pow(resolution, power))); };
                const Outcome outcome = search(mostParts, first, count);
                EXPECT_LE(count(outcome.best), mostParts);
                EXPECT_TRUE(outcome.best == LegoSettings::MAXIMUM_RESOLUTION || count(outcome.best + 1) > mostParts);
                EXPECT_LE(outcome.numTries, 20) << power << " " << mostParts << " " << first;
            }
}

TEST(ResolutionSearch, TakesFewTriesWhereThePartsGrowAsASurface)
{
    const auto count = [](unsigned int resolution) { return std::size_t(resolution) * resolution; };
    EXPECT_LE(search(500, 24, count).numTries, 3);
    EXPECT_LE(search(5000, 24, count).numTries, 3);
}

TEST(ResolutionSearch, EndsWhereTheNumberOfPartsDoesNotGrowSteadily)
{
    const auto count = [](unsigned int resolution) { return resolution * resolution + (resolution % 3) * 60; };
    const Outcome outcome = search(500, 24, count);
    EXPECT_LE(count(outcome.best), 500u);
    EXPECT_GT(count(outcome.best + 1), 500u);
}

TEST(ResolutionSearch, HasTheLowestResolutionIfNoneHasFewEnoughParts)
{
    EXPECT_EQ(search(5, 24, [](unsigned int) { return std::size_t(6); }).best, 1u);
}

} // namespace

} // namespace osgLego
