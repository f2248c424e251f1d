#include <osgLego/model/LayoutStanding.h>

#include <Layouts.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(LayoutStanding, FewerFallingPartsAreBetterAndThenAHigherMargin)
{
    StabilityReport none;
    none.margin = 0.1;
    StabilityReport steadier = none;
    steadier.margin = 0.2;
    StabilityReport one = steadier;
    one.falling = {0};
    EXPECT_TRUE(standsBetter(steadier, none));
    EXPECT_FALSE(standsBetter(none, steadier));
    EXPECT_FALSE(standsBetter(none, none));
    EXPECT_TRUE(standsBetter(none, one));
    EXPECT_FALSE(standsBetter(one, none));
}

TEST(LayoutStanding, PartsThatMayFallCountAsFalling)
{
    StabilityReport stands;
    stands.margin = -1.0;
    StabilityReport unknown;
    unknown.unknown = {0, 1};
    StabilityReport falls;
    falls.falling = {0};
    EXPECT_TRUE(standsBetter(stands, unknown));
    EXPECT_TRUE(standsBetter(falls, unknown));
    EXPECT_FALSE(standsBetter(unknown, falls));
}

TEST(LayoutStanding, CellsHaveTheHeightOfBricksOrOfPlates)
{
    // A cantilever 1 x 8 on a brick 1 x 1 on a base 1 x 8: plates weigh less.
    LayoutProblem problem = drawProblem({{"aaaaaaaa"}, {"a......."}, {"aaaaaaaa"}});
    const LaidParts parts{{{0, 0, 0}, {8, 1, 1}}, {{0, 0, 1}}, {{0, 0, 2}, {8, 1, 1}}};
    const double bricks = computeStanding(problem, parts, {})->margin;
    problem.isOfPlates = true;
    const double plates = computeStanding(problem, parts, {})->margin;
    // The weight of the upper part times its lever of 3.25 pitches, of 0.98 N. For plates, 0.10937 * 8 + 0.05671 * 9 -
    // 0.02207 = 1.3632 g.
    EXPECT_NEAR(bricks, 1.0 - 9.8e-3 * 3.03 * 3.25 / 0.98, 1e-6);
    EXPECT_GT(plates, bricks);
    EXPECT_NEAR(plates, 1.0 - 9.8e-3 * 1.3632 * 3.25 / 0.98, 1e-3);
}

} // namespace

} // namespace osgLego
