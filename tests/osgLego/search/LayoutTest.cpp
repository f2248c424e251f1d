#include "../layout/LaidModel.h"

#include <osgLego/PartType.h>
#include <osgLego/layout/LayoutFigures.h>
#include <osgLego/layout/PossibleComponents.h>
#include <osgLego/search/Layout.h>
#include <osgLego/search/LayoutCosts.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include <Layouts.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

namespace osgLego
{

namespace
{

constexpr int NO_CELL = -1;

LayoutOptions makeOptions(Effort effort, std::uint32_t seed = 0)
{
    LayoutOptions options;
    options.effort = effort;
    options.seed = seed;
    return options;
}

void expectValid(const LayoutProblem& problem, const LaidParts& parts)
{
    EXPECT_EQ(LaidModel(problem, parts).findMistake(), "");
}

/** A row of cells with gaps. The colours are random, and parts of random sizes exist in each. */
LayoutProblem makeRandomRow(std::uint32_t seed)
{
    constexpr int NUM_COLORS = 3;
    std::mt19937 random(seed);
    std::vector<LayoutColor> colors(NUM_COLORS);
    for (LayoutColor& color : colors)
        color.bricks = static_cast<std::uint16_t>(random() & 0x7ff);
    int left = 0;
    int choice = 0;
    const auto getColor = [&](int, int, int)
    {
        if (left-- == 0)
        {
            left = static_cast<int>(random() % 9);
            choice = static_cast<int>(random() % (NUM_COLORS + 2));
        }
        if (choice == NUM_COLORS) return static_cast<int>(LayoutCell::ANY_COLOR);
        return choice < NUM_COLORS ? choice : NO_CELL;
    };
    return makeCells({1 + static_cast<int>(random() % 30), 1, 1}, getColor, colors);
}

/** The cost of a part of a row, which nothing connects to another part. ANY_COLOR stands for the cheapest colour. */
std::int64_t costInRow(const LayoutProblem& problem, int length, std::uint16_t color)
{
    const std::size_t size = findPartType(PartFamily::BRICK, 1, length)->getSizeIndex();
    bool isMade = false;
    for (std::size_t i = 0; i < problem.colors.size(); ++i)
        if (color == LayoutCell::ANY_COLOR || color == i) isMade |= (problem.colors[i].bricks >> size & 1) != 0;
    if (!isMade && length > 1) return 1'000'000'000;
    return LayoutCosts::PART + LayoutCosts::COMPONENT + (isMade ? 0 : LayoutCosts::UNMADE);
}

/** The least cost of a row, by dynamic programming from left to right over the length of the last part. */
std::int64_t findLeastCostOfRow(const LayoutProblem& problem)
{
    const std::vector<LayoutCell>& cells = problem.cells;
    std::vector<std::int64_t> least(cells.size() + 1, 1'000'000'000);
    least[0] = 0;
    for (std::size_t begin = 0; begin < cells.size(); ++begin)
    {
        std::uint16_t color = LayoutCell::ANY_COLOR;
        for (std::size_t end = begin; end < cells.size() && end < begin + 8; ++end)
        {
            const bool isNext = cells[end].place[0] == cells[begin].place[0] + (end - begin);
            const bool suits = color == LayoutCell::ANY_COLOR || cells[end].color == LayoutCell::ANY_COLOR ||
                               cells[end].color == color;
            if (!isNext || !suits) break;
            if (color == LayoutCell::ANY_COLOR) color = cells[end].color;
            const auto length = static_cast<int>(end - begin + 1);
            if (!findPartType(PartFamily::BRICK, 1, length)) continue;
            least[end + 1] = std::min(least[end + 1], least[begin] + costInRow(problem, length, color));
        }
    }
    return least.back();
}

} // namespace

/** Stairs along x, each of which overlaps the next one by a cell. */
LayoutProblem makeStairs(int width, int depth, int numStairs)
{
    return makeCells({numStairs * width + 1, depth, numStairs},
                     [=](int x, int, int z) { return x >= z * width && x <= (z + 1) * width ? 0 : NO_CELL; });
}

TEST(Layout, OfNoCellsHasNoParts)
{
    EXPECT_TRUE(layOut(makeCells({4, 4, 4}, [](int, int, int) { return -1; }), {}).empty());
}

TEST(Layout, OfOneCellIsOnePart)
{
    const LaidParts parts =
        layOut(makeCells({9, 9, 9}, [](int x, int y, int z) { return x == 3 && y == 4 && z == 5 ? 0 : NO_CELL; }), {});
    EXPECT_EQ(parts, (LaidParts{{{3, 4, 5}, {1, 1, 1}, 0}}));
}

TEST(Layout, CoversEveryCellOnceByPartsThatWereMadeInItsColor)
{
    const LayoutColor onlyLong{0b00000100100, 0b00000001000};
    for (const bool isOfPlates : {false, true})
        for (const Effort effort : {Effort::INSTANT, Effort::NORMAL, Effort::BEST})
            for (std::uint32_t seed = 0; seed < 4; ++seed)
            {
                LayoutProblem problem =
                    makeRandomCells({9, 7, 6}, 85, seed, {LayoutColor{}, onlyLong, LayoutColor{0x7fe, 0x3f}});
                problem.isOfPlates = isOfPlates;
                expectValid(problem, layOut(problem, makeOptions(effort, seed)));
            }
}

TEST(Layout, AGreedyOneIsNotSearchedForBetterParts)
{
    for (std::uint32_t seed = 0; seed < 4; ++seed)
    {
        const LayoutProblem problem = makeRandomCells({13, 11, 9}, 85, seed);
        LayoutOptions options = makeOptions(Effort::INSTANT, seed);
        const std::size_t numSearched = layOut(problem, options).size();
        options.isGreedy = true;
        const LaidParts greedy = layOut(problem, options);
        expectValid(problem, greedy);
        EXPECT_GT(greedy.size(), numSearched) << "seed " << seed;
        EXPECT_LT(greedy.size(), numSearched * 5 / 4) << "seed " << seed;
    }
}

/** The cost that layouts are compared by. */
std::int64_t costOf(const LayoutProblem& problem, const LaidParts& parts)
{
    const LayoutFigures figures = computeLayoutFigures(problem, parts);
    return static_cast<std::int64_t>(figures.parts * LayoutCosts::PART + figures.components * LayoutCosts::COMPONENT +
                                     figures.unavailable * LayoutCosts::UNMADE) +
           static_cast<std::int64_t>(figures.stackedLength) * 2 * LayoutCosts::getHalfSeam(problem);
}

TEST(Layout, OfTheBestEffortIsNeverWorseThanThatOfNormalEffort)
{
    for (std::uint32_t seed = 18; seed < 26; ++seed)
    {
        const LayoutProblem problem = createRandomProblem({8, 8, 5}, "aab.", seed);
        EXPECT_LE(costOf(problem, layOut(problem, makeOptions(Effort::BEST, seed))),
                  costOf(problem, layOut(problem, makeOptions(Effort::NORMAL, seed))))
            << seed;
    }
}

TEST(Layout, IsSortedByZThenYThenX)
{
    const LaidParts parts = layOut(makeRandomCells({13, 11, 9}, 80, 1), {});
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end(),
                               [](const LaidPart& a, const LaidPart& b) {
                                   return std::tuple(a.place[2], a.place[1], a.place[0]) <
                                          std::tuple(b.place[2], b.place[1], b.place[0]);
                               }));
}

TEST(Layout, HasTheFewestComponentsThatDenseCellsAllow)
{
    for (std::uint32_t seed = 0; seed < 12; ++seed)
    {
        const LayoutProblem problem = makeRandomCells({12, 12, 8}, 96, seed);
        const LaidParts parts = layOut(problem, makeOptions(Effort::NORMAL, seed));
        EXPECT_EQ(LaidModel(problem, parts).countComponents(), static_cast<int>(countPossibleComponents(problem)))
            << "seed " << seed;
    }
}

TEST(Layout, ConnectsColumnsOfTwoColorsWhereOneLayerAllowsIt)
{
    // Two towers touch, and only the cells in layer 5 may share a part.
    const LayoutProblem problem = makeCells(
        {2, 1, 9}, [](int x, int, int z) { return z == 5 ? 2 : x; }, std::vector<LayoutColor>(3));
    const LaidParts parts = layOut(problem, makeOptions(Effort::INSTANT));
    EXPECT_EQ(LaidModel(problem, parts).countComponents(), 1);
    EXPECT_EQ(parts.size(), 17u);
}

TEST(Layout, JoinsComponentsAgainAfterItsRounds)
{
    // The greedy layout of each of these models, in a row of rows, consists of two towers. One phase joins at most
    // 1000.
    constexpr int NUM_MODELS = 1100;
    const LayoutProblem problem = makeCells(
        {4, 2 * NUM_MODELS, 2}, [](int, int y, int) { return y % 2 == 0 ? 0 : NO_CELL; }, {LayoutColor{0b11, 0b11}});
    const LaidParts parts = layOut(problem, makeOptions(Effort::NORMAL));
    EXPECT_EQ(LaidModel(problem, parts).countComponents(), NUM_MODELS);
}

TEST(Layout, OfInstantEffortJoinsTheManyPiecesOfAGreedyOne)
{
    for (const bool isOfPlates : {false, true})
        for (const int width : {3, 5, 7})
        {
            LayoutProblem problem = makeStairs(width, 60, 20);
            problem.isOfPlates = isOfPlates;
            LayoutOptions options = makeOptions(Effort::INSTANT);
            const LaidParts joined = layOut(problem, options);
            expectValid(problem, joined);
            EXPECT_EQ(LaidModel(problem, joined).countComponents(), 1) << "width " << width;
            options.isGreedy = true;
            const LaidParts draft = layOut(problem, options);
            EXPECT_GT(LaidModel(problem, draft).countComponents(), 20) << "width " << width;
        }
}

TEST(Layout, LeavesCellsApartThatNoPartCanCover)
{
    const auto ownColor = [](int x, int y, int) { return 3 * y + x; };
    const LayoutProblem plate = makeCells({3, 3, 1}, ownColor, std::vector<LayoutColor>(9));
    EXPECT_EQ(layOut(plate, {}).size(), 9u);
    const LayoutProblem board = makeCells(
        {8, 8, 1}, [](int x, int y, int) { return (x + y) % 2; }, std::vector<LayoutColor>(2));
    EXPECT_EQ(layOut(board, {}).size(), 64u);
    expectValid(board, layOut(board, {}));
}

TEST(Layout, OfABoxHasAsFewPartsAsItsVolumeAllows)
{
    const LayoutProblem problem = makeCells({16, 16, 1}, [](int, int, int) { return 0; });
    EXPECT_EQ(layOut(problem, {}).size(), 16u);
}

TEST(Layout, OfADomeHasFewStackedSeams)
{
    for (const int thickness : {2, 3, 12})
    {
        const LayoutProblem problem = makeDome(12, thickness);
        const LaidParts parts = layOut(problem, {});
        const LaidModel model(problem, parts);
        EXPECT_EQ(model.findMistake(), "");
        EXPECT_EQ(model.countComponents(), 1);
        EXPECT_LT(model.countStackedSeams(), static_cast<int>(parts.size()) / 2) << "thickness " << thickness;
    }
}

TEST(Layout, DoesNotDependOnTheNumberOfThreads)
{
    for (const bool isOfPlates : {false, true})
    {
        LayoutProblem problem = makeRandomCells({16, 16, 40}, 97, 5);
        problem.isOfPlates = isOfPlates;
        std::vector<LaidParts> layouts;
        for (const std::size_t numThreads : {1, 2, 4, 8})
        {
            const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, numThreads);
            LayoutOptions options = makeOptions(Effort::INSTANT, 7);
            int numSteps = 0;
            options.progress = [&](double) { ++numSteps; };
            layouts.push_back(layOut(problem, options));
            EXPECT_GT(numSteps, 1) << "there are no rounds of the search";
        }
        for (std::size_t i = 1; i < layouts.size(); ++i)
            EXPECT_TRUE(layouts[i] == layouts[0]) << i;
    }
}

TEST(Layout, OfAShellHangsFewPartsOnASingleOne)
{
    // The same cells, with and without an interior colour: leaves cost more in shells.
    LayoutProblem surface = makeDome(14, 2);
    LayoutProblem shell = surface;
    shell.isHollow = true;
    for (std::size_t cell = 0; cell < shell.cells.size(); cell += 3)
        shell.cells[cell].color = LayoutCell::ANY_COLOR;
    const LaidParts hanging = layOut(surface, {});
    const LaidParts held = layOut(shell, {});
    EXPECT_LT(LaidModel(shell, held).countLeaves(), LaidModel(surface, hanging).countLeaves());
}

TEST(Layout, OfASolidHasStackedSeamsWithTheBestEffortToHaveFewerParts)
{
    // Above squares of two colours in turn, four squares have six stacked seams. Halves at both ends avoid them.
    constexpr std::uint16_t HALF_AND_SQUARE = 0b1000010;
    const LayoutProblem problem =
        makeCells({8, 2, 3},
                  [](int x, int, int z)
                  {
                      if (z == 0) return x == 0 ? static_cast<int>(LayoutCell::ANY_COLOR) : 0;
                      return z == 1 ? x / 2 % 2 : 2;
                  },
                  {LayoutColor{}, LayoutColor{}, LayoutColor{HALF_AND_SQUARE, HALF_AND_SQUARE}});
    const auto countOnTop = [&](Effort effort)
    {
        const LaidParts parts = layOut(problem, makeOptions(effort));
        return std::count_if(parts.begin(), parts.end(), [](const LaidPart& part) { return part.place[2] == 2; });
    };
    EXPECT_EQ(countOnTop(Effort::NORMAL), 5);
    EXPECT_EQ(countOnTop(Effort::BEST), 4);
}

TEST(Layout, KeepsAllPartsOfThePreviousLayoutOfTheSameCells)
{
    const LayoutProblem problem = makeRandomCells({20, 20, 6}, 90, 2);
    const LaidParts previous = layOut(problem, makeOptions(Effort::INSTANT, 1));
    EXPECT_EQ(layOut(problem, makeOptions(Effort::NORMAL, 2), previous), previous);
}

/** The coordinates along an axis at which some parts are longer than a cell. */
std::set<int> findLongParts(const LaidParts& parts, std::size_t axis)
{
    std::set<int> places;
    for (const LaidPart& part : parts)
        if (part.size != std::array<std::uint8_t, 3>{1, 1, 1}) places.insert(part.place[axis]);
    return places;
}

TEST(Layout, LaysOnlyPartsWithinEightCellsOfAChangeAgain)
{
    // Stripes of eight cells, each of a different colour than the next ones, so that no window contains cells of two.
    constexpr int NUM_STRIPES = 24;
    constexpr int NUM_KEPT = 20;
    for (const std::size_t axis : {0, 2})
    {
        const glm::ivec3 size = axis == 0 ? glm::ivec3(NUM_STRIPES, 8, 1) : glm::ivec3(1, 8, NUM_STRIPES);
        const LayoutProblem problem = makeCells(
            size, [](int x, int, int z) { return (x + z) % 2; }, std::vector<LayoutColor>(2));
        // A long part connects the columns of single cells.
        LaidParts previous{{{0, 0, 0}, {1, 8, 1}, 0}};
        for (const LayoutCell& cell : problem.cells)
            if (cell.place[axis] > 0 && cell.place[axis] < NUM_KEPT)
                previous.push_back({cell.place, {1, 1, 1}, cell.color});
        const LaidParts parts = layOut(problem, makeOptions(Effort::NORMAL), previous);
        expectValid(problem, parts);
        std::set<int> expected{0};
        for (int stripe = NUM_KEPT - 8; stripe < NUM_STRIPES; ++stripe)
            expected.insert(stripe);
        EXPECT_EQ(findLongParts(parts, axis), expected);
    }
}

TEST(Layout, IgnoresPreviousPartsThatDoNotFit)
{
    const LayoutProblem problem = makeCells({6, 1, 1}, [](int, int, int) { return 0; }, {LayoutColor{0x0f, 0x0f}});
    const LaidParts previous{{{0, 0, 0}, {6, 1, 1}, 0}, {{0, 0, 0}, {4, 1, 1}, 7}, {{4, 0, 0}, {4, 1, 1}, 0},
                             {{0, 0, 0}, {3, 1, 1}, 0}, {{2, 0, 0}, {3, 1, 1}, 0}, {{0, 0, 0}, {0, 200, 3}, 0},
                             {{9, 9, 9}, {1, 1, 1}, 0}, {{0, 0, 0}, {1, 1, 3}, 0}};
    expectValid(problem, layOut(problem, {}, previous));
}

TEST(Layout, PrefersSizesThatExistInAColor)
{
    // Five cells in a row: without parts of one cell, 2 + 3 is possible and 4 + 1 is not.
    const LayoutProblem problem = makeCells({5, 1, 1}, [](int, int, int) { return 0; }, {LayoutColor{0x0e, 0x0e}});
    const LaidParts parts = layOut(problem, {});
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_GE(parts[0].size[0], 2);
    EXPECT_GE(parts[1].size[0], 2);
}

TEST(Layout, GivesInteriorPartsTheCommonestColorAroundInWhichTheyExist)
{
    constexpr std::uint16_t ONLY_SINGLE = 1;
    // A cube of any colour in a shell: three sides have colour 1, the others colour 2, which has no part of this size.
    const LayoutProblem problem =
        makeCells({4, 4, 3},
                  [](int x, int y, int z)
                  {
                      if (z == 1 && x >= 1 && x <= 2 && y >= 1 && y <= 2)
                          return static_cast<int>(LayoutCell::ANY_COLOR);
                      return z == 1 && x == 0 ? 1 : 2;
                  },
                  {LayoutColor{ONLY_SINGLE, ONLY_SINGLE}, LayoutColor{}, LayoutColor{ONLY_SINGLE, ONLY_SINGLE}});
    const LaidParts parts = layOut(problem, {});
    expectValid(problem, parts);
    for (const LaidPart& part : parts)
        EXPECT_TRUE(part.color == 1 || part.size == (std::array<std::uint8_t, 3>{1, 1, 1}));
    EXPECT_LT(parts.size(), problem.cells.size());
}

TEST(Layout, OfARowIsAsCheapAsDynamicProgrammingFinds)
{
    for (std::uint32_t seed = 0; seed < 400; ++seed)
    {
        const LayoutProblem problem = makeRandomRow(seed);
        const LaidParts parts = layOut(problem, makeOptions(Effort::NORMAL, seed));
        expectValid(problem, parts);
        std::int64_t cost = 0;
        for (const LaidPart& part : parts)
            cost += costInRow(problem, part.size[0], part.color);
        EXPECT_EQ(cost, findLeastCostOfRow(problem)) << "seed " << seed;
    }
}

TEST(Layout, MakesABrickOfThreePlates)
{
    LayoutProblem problem = makeCells({4, 2, 3}, [](int, int, int) { return 0; });
    problem.isOfPlates = true;
    EXPECT_EQ(layOut(problem, {}), (LaidParts{{{0, 0, 0}, {4, 2, 3}, 0}}));
    problem.colors[0].bricks = 0;
    EXPECT_EQ(layOut(problem, {}).size(), 3u);
}

TEST(Layout, MixesPlatesAndBricks)
{
    LayoutProblem problem = makeCells({16, 16, 16}, [](int, int, int) { return 0; });
    problem.isOfPlates = true;
    const std::size_t mixed = layOut(problem, {}).size();
    problem.colors[0].bricks = 0;
    EXPECT_LT(mixed, layOut(problem, {}).size() * 6 / 10);
}

TEST(Layout, CoversALargePlate)
{
    const LayoutProblem problem = makeCells({1024, 1024, 1}, [](int, int, int) { return 0; });
    const LaidParts parts = layOut(problem, makeOptions(Effort::INSTANT));
    EXPECT_EQ(parts.size(), 1024u * 1024u / 16u);
}

TEST(Layout, CoversAHighColumn)
{
    const LayoutProblem problem = makeCells({2, 2, 2560}, [](int, int, int) { return 0; });
    const LaidParts parts = layOut(problem, {});
    EXPECT_EQ(parts.size(), 2560u);
    EXPECT_EQ(LaidModel(problem, parts).countComponents(), 1);
}

} // namespace osgLego
