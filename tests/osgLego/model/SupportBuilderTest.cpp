#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/SupportBuilder.h>

#include <Layouts.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A layout of parts of one colour, each of which is one cell high, and the problem of their cells. */
SupportedLayout createLayout(LaidParts parts, const glm::ivec3& size)
{
    const auto isLower = [](const auto& a, const auto& b)
    { return std::tie(a.place[2], a.place[1], a.place[0]) < std::tie(b.place[2], b.place[1], b.place[0]); };
    LayoutProblem problem;
    problem.size = size;
    problem.colors.emplace_back();
    for (const LaidPart& part : parts)
        for (int y = 0; y < part.size[1]; ++y)
            for (int x = 0; x < part.size[0]; ++x)
                problem.cells.push_back({{static_cast<std::uint16_t>(part.place[0] + x),
                                          static_cast<std::uint16_t>(part.place[1] + y), part.place[2]},
                                         part.color});
    std::sort(problem.cells.begin(), problem.cells.end(), isLower);
    std::sort(parts.begin(), parts.end(), isLower);
    return {std::move(problem), std::move(parts)};
}

SupportedLayout support(const LayoutProblem& problem, const LaidParts& parts)
{
    SupportedLayout layout{problem, parts};
    EXPECT_TRUE(SupportBuilder({}).build(layout));
    EXPECT_EQ(findLayoutError(layout.problem, layout.parts), "");
    return layout;
}

bool stands(const SupportedLayout& layout)
{
    return computeStanding(layout.problem, layout.parts, {})->stands;
}

TEST(SupportBuilder, LeavesAModelThatStandsUnchanged)
{
    const LayoutProblem problem = drawProblem({{"aa", "aa"}, {"aa", "aa"}});
    const LaidParts parts{{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {2, 2, 1}}};
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_EQ(layout.parts, parts);
    EXPECT_EQ(layout.problem.cells, problem.cells);
}

TEST(SupportBuilder, LaysBricksAcrossTheWeakPlaceBeforeItAddsColumns)
{
    // A bridge on two posts, whose joints lie above each other beside a post.
    const LayoutProblem problem = drawProblem(
        {{"aa....aa", "aa....aa"}, {"aa....aa", "aa....aa"}, {"aaaaaaaa", "aaaaaaaa"}, {"aaaaaaaa", "aaaaaaaa"}});
    LaidParts parts;
    for (std::uint16_t z = 0; z < 2; ++z)
        for (const std::uint16_t x : {std::uint16_t(0), std::uint16_t(6)})
            parts.push_back({{x, 0, z}, {2, 2, 1}});
    for (std::uint16_t z = 2; z < 4; ++z)
    {
        parts.push_back({{0, 0, z}, {2, 2, 1}});
        parts.push_back({{2, 0, z}, {4, 2, 1}});
        parts.push_back({{6, 0, z}, {2, 2, 1}});
    }
    ASSERT_FALSE(stands({problem, parts}));
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(stands(layout));
    EXPECT_TRUE(layout.isLaidAgain);
    EXPECT_EQ(layout.columns.size(), 0u);
    EXPECT_EQ(layout.problem.cells, problem.cells);
}

TEST(SupportBuilder, PutsColumnsUnderAModelThatTipsOver)
{
    const LayoutProblem problem = drawProblem({{"a......."}, {"a......."}, {"aaaaaaaa"}});
    const LaidParts parts{{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}, {8, 1, 1}}};
    ASSERT_FALSE(stands({problem, parts}));
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(stands(layout));
    EXPECT_EQ(layout.columns.size(), 1u);
    EXPECT_EQ(layout.numColumnParts, 2u);
    EXPECT_EQ(layout.parts.size(), parts.size() + 2);
    EXPECT_FALSE(layout.isLaidAgain) << "no other layout is better";
}

TEST(SupportBuilder, DoesNotLetALoosePieceOnAColumnOfItsOwnCountAsStanding)
{
    const LayoutProblem problem = drawProblem(
        {{"aa......", "aa......"}, {"aa......", "aa......"}, {"aa....aa", "aa....aa"}, {"aa....aa", "aa....aa"}});
    LaidParts parts;
    for (std::uint16_t z = 0; z < 4; ++z)
    {
        parts.push_back({{0, 0, z}, {2, 2, 1}});
        if (z >= 2) parts.push_back({{6, 0, z}, {2, 2, 1}});
    }
    const SupportedLayout layout = support(problem, parts);
    EXPECT_FALSE(layout.stands);
    EXPECT_TRUE(stands(layout)) << "nothing falls";
    EXPECT_EQ(layout.numPropped, 1u);
    EXPECT_EQ(layout.columns.size(), 1u);
    EXPECT_EQ(layout.numColumnParts, 2u);
}

TEST(SupportBuilder, CanBeCancelled)
{
    const LayoutProblem problem = drawProblem({{"a......."}, {"aaaaaaaa"}});
    SupportedLayout layout{problem, {{{0, 0, 0}}, {{0, 0, 1}, {8, 1, 1}}}};
    LayoutOptions options;
    options.isCancelled = [] { return true; };
    EXPECT_FALSE(SupportBuilder(options).build(layout));
}

TEST(SupportBuilder, LaysAgainOnlyPartsNearTheWeakPlace)
{
    // A bridge like that above, on posts of 40 layers. Pillars like its posts stand far away along x and along y. Posts
    // and pillars consist of two columns, which a new layout would join.
    constexpr std::uint16_t HEIGHT = 40;
    constexpr std::uint16_t FAR = 60;
    LaidParts parts;
    for (std::uint16_t z = 0; z < HEIGHT; ++z)
        for (const glm::ivec2& place : {glm::ivec2(0, 0), glm::ivec2(6, 0), glm::ivec2(FAR, 0), glm::ivec2(0, FAR)})
            for (const int side : {0, 1})
                parts.push_back(
                    {{static_cast<std::uint16_t>(place.x + side), static_cast<std::uint16_t>(place.y), z}, {1, 2, 1}});
    for (std::uint16_t z = HEIGHT; z < HEIGHT + 2; ++z)
    {
        parts.push_back({{0, 0, z}, {2, 2, 1}});
        parts.push_back({{2, 0, z}, {4, 2, 1}});
        parts.push_back({{6, 0, z}, {2, 2, 1}});
    }
    const SupportedLayout bare = createLayout(parts, {FAR + 2, FAR + 2, HEIGHT + 2});
    ASSERT_FALSE(stands(bare));
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(layout.isLaidAgain);
    EXPECT_EQ(layout.columns.size(), 0u);
    for (const LaidPart& part : bare.parts)
    {
        const bool isFar = part.place[0] >= FAR || part.place[1] == FAR || part.place[2] < HEIGHT / 2;
        EXPECT_TRUE(!isFar || std::count(layout.parts.begin(), layout.parts.end(), part) == 1)
            << part.place[0] << ", " << part.place[1] << ", " << part.place[2];
    }
}

TEST(SupportBuilder, LaysPartsNearTheWeakestJointAgainThoughOthersFall)
{
    // An arm of bonded bricks lies on a post by a single stud, and beside bricks that lie on the rest of the post. The
    // brick at its end is said to fall, since a small force there would hold the arm. From there, the post is farther
    // away than any attempt reaches.
    LaidParts parts;
    const auto addRow = [&parts](std::uint16_t z, std::uint16_t x, const std::vector<std::uint8_t>& lengths)
    {
        for (const std::uint8_t length : lengths)
        {
            parts.push_back({{x, 0, z}, {length, 1, 1}});
            x = static_cast<std::uint16_t>(x + length);
        }
    };
    addRow(0, 0, {8, 8, 8, 8, 8, 8, 8, 8});
    addRow(1, 0, {4, 8, 8, 8, 8, 8, 8, 8, 4});
    addRow(2, 0, {8});
    addRow(3, 0, {4, 4});
    addRow(4, 0, {8});
    addRow(5, 0, {4, 3, 8, 8, 8, 8, 8, 8, 8});
    addRow(6, 11, {8, 8, 8, 8, 8, 8, 4});
    const SupportedLayout bare = createLayout(parts, {64, 1, 7});
    const std::vector<std::uint32_t> falling = computeStanding(bare.problem, bare.parts, {})->falling;
    for (const std::uint32_t part : falling)
        ASSERT_GE(bare.parts[part].place[0], 55);
    ASSERT_FALSE(falling.empty());
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(layout.isLaidAgain);
    EXPECT_EQ(layout.columns.size(), 0u);
}

TEST(SupportBuilder, PrefersPartsThatOverlapToFewParts)
{
    // A bridge of 2x16 on thin posts, and a pile of bricks beside its middle. The fewest bricks, two in each layer,
    // have their joints above each other. Below, bricks connect the posts.
    constexpr std::uint16_t PILE = 32;
    LaidParts parts{{{0, 0, 0}, {8, 2, 1}}, {{8, 0, 0}, {8, 2, 1}}, {{4, 0, 1}, {8, 2, 1}}};
    for (std::uint16_t z = 1; z < 4; ++z)
        for (const std::uint16_t x : {std::uint16_t(0), std::uint16_t(15)})
            parts.push_back({{x, 0, z}, {1, 2, 1}});
    for (std::uint16_t z = 4; z < 6; ++z)
        for (const std::uint16_t x : {std::uint16_t(0), std::uint16_t(8)})
            parts.push_back({{x, 0, z}, {8, 2, 1}});
    for (std::uint16_t z = 6; z < 6 + PILE; ++z)
        parts.push_back({{6, 0, z}, {2, 2, 1}});
    const SupportedLayout bare = createLayout(parts, {16, 2, 6 + PILE});
    ASSERT_FALSE(stands(bare));
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(layout.isLaidAgain);
    EXPECT_EQ(layout.columns.size(), 0u);
}

TEST(SupportBuilder, LargeGroupsGetColumnsFirstIfThereAreTooManyGroups)
{
    // Bricks in the air, one more than the columns that are built at most, and a second brick on the last one.
    constexpr int SIDE = 13;
    LaidParts parts{{{0, 0, 0}}};
    for (int number = 0; number < 65; ++number)
        parts.push_back({{static_cast<std::uint16_t>(2 + 4 * (number % SIDE)),
                          static_cast<std::uint16_t>(2 + 4 * (number / SIDE)), 1}});
    LaidPart upper = parts.back();
    ++upper.place[2];
    parts.push_back(upper);
    const SupportedLayout bare = createLayout(parts, {4 * SIDE, 4 * SIDE, 3});
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_FALSE(layout.stands);
    EXPECT_EQ(layout.columns.size(), 64u);
    const std::vector<std::uint32_t> falling = computeStanding(layout.problem, layout.parts, {})->falling;
    ASSERT_EQ(falling.size(), 1u);
    EXPECT_NE(layout.parts[falling[0]], upper);
}

TEST(SupportBuilder, ReportsItsOwnProgressAndNotThatOfLayingParts)
{
    const LayoutProblem problem = drawProblem({{"a......."}, {"a......."}, {"aaaaaaaa"}});
    SupportedLayout layout{problem, {{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}, {8, 1, 1}}}};
    LayoutOptions options;
    std::vector<double> fractions;
    options.progress = [&fractions](double fraction) { fractions.push_back(fraction); };
    EXPECT_TRUE(SupportBuilder(options).build(layout));
    EXPECT_TRUE(layout.stands);
    EXPECT_GT(fractions.size(), 5u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.back(), 1.0);
}

TEST(SupportBuilder, PutsColumnsBelowPartsThatStandIfThoseOnThemTipOver)
{
    // A pile on the end of an arm: the only places for columns are below the arm.
    const LayoutProblem problem = drawProblem({{"a......."}, {"a......."}, {"aaaaaaaa"}, {".......a"}, {".......a"}});
    const LaidParts parts{{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}, {8, 1, 1}}, {{7, 0, 3}}, {{7, 0, 4}}};
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_EQ(layout.columns.size(), 1u);
}

TEST(SupportBuilder, LaysAllWeakPlacesAgainAtOnce)
{
    // More bridges than attempts, like that above.
    constexpr int NUM_BRIDGES = 8;
    LaidParts parts;
    for (int bridge = 0; bridge < NUM_BRIDGES; ++bridge)
    {
        const auto y = static_cast<std::uint16_t>(20 * bridge);
        for (std::uint16_t z = 0; z < 4; ++z)
        {
            parts.push_back({{0, y, z}, {2, 2, 1}});
            parts.push_back({{6, y, z}, {2, 2, 1}});
            if (z >= 2) parts.push_back({{2, y, z}, {4, 2, 1}});
        }
    }
    const SupportedLayout bare = createLayout(parts, {8, 20 * NUM_BRIDGES, 4});
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_EQ(layout.columns.size(), 0u);
}

TEST(SupportBuilder, LaysPartsAgainWithinTwoCellsOfTheWeakPlace)
{
    // The bridge of LaysBricksAcrossTheWeakPlaceBeforeItAddsColumns, which stands after the first attempt. Beside it,
    // two bricks could be one.
    for (const int gap : {0, 1, 2, 3, 4, 5})
    {
        LaidParts parts;
        for (std::uint16_t z = 0; z < 4; ++z)
        {
            parts.push_back({{0, 0, z}, {2, 2, 1}});
            parts.push_back({{6, 0, z}, {2, 2, 1}});
            if (z >= 2) parts.push_back({{2, 0, z}, {4, 2, 1}});
        }
        const LaidParts pair{{{3, static_cast<std::uint16_t>(2 + gap), 0}, {1, 2, 1}},
                             {{4, static_cast<std::uint16_t>(2 + gap), 0}, {1, 2, 1}}};
        parts.insert(parts.end(), pair.begin(), pair.end());
        const SupportedLayout bare = createLayout(parts, {8, 10, 4});
        const SupportedLayout layout = support(bare.problem, bare.parts);
        EXPECT_TRUE(layout.stands);
        for (const LaidPart& part : pair)
            EXPECT_EQ(std::count(layout.parts.begin(), layout.parts.end(), part), gap <= 2 ? 0 : 1) << gap;
    }
}

TEST(SupportBuilder, EachGroupOfFloatingPartsGetsAColumnBelowItsMiddle)
{
    // Two bricks of 8x2 in the air topple over on a column below their ends, where the outermost places are.
    constexpr std::uint16_t SECOND = 10;
    const LaidParts parts{{{8, 0, 0}, {1, 2, 1}}, {{0, 0, 2}, {8, 2, 1}}, {{SECOND, 0, 2}, {8, 2, 1}}};
    const SupportedLayout bare = createLayout(parts, {SECOND + 8, 2, 3});
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_TRUE(stands(layout));
    EXPECT_EQ(layout.numPropped, 1u) << "besides the largest piece";
    EXPECT_EQ(layout.columns.size(), 2u);
    for (const int x : {3, SECOND + 3})
        EXPECT_EQ(std::count(layout.parts.begin(), layout.parts.end(),
                             LaidPart{{static_cast<std::uint16_t>(x), 0, 1}, {2, 2, 1}}),
                  1)
            << x;
}

TEST(SupportBuilder, ColumnsBelowNeighborsDoNotOverlap)
{
    // Two bricks in the air, with one cell between them. The column below the first one is 2x2; beside it, there is no
    // place for another one of 2x2.
    const LaidParts parts{{{0, 0, 0}}, {{4, 0, 1}}, {{6, 0, 1}}};
    const SupportedLayout bare = createLayout(parts, {7, 2, 2});
    const SupportedLayout layout = support(bare.problem, bare.parts);
    EXPECT_TRUE(stands(layout));
    EXPECT_EQ(layout.numPropped, 2u);
    EXPECT_EQ(layout.columns.size(), 2u);
    EXPECT_EQ(std::count(layout.parts.begin(), layout.parts.end(), LaidPart{{4, 0, 0}, {2, 2, 1}}), 1);
    EXPECT_EQ(std::count(layout.parts.begin(), layout.parts.end(), LaidPart{{6, 0, 0}}), 1);
}

} // namespace

} // namespace osgLego
