#include "BrickTowers.h"

#include <osgLego/Stability.h>
#include <osgLego/stability/StabilityAnalysis.h>

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(StabilityAnalysis, SubsetsStandOnTheirOwnLowestLayer)
{
    // A column of three bricks with a beam on top, and a brick beside the third one.
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 2, 2), createBrick({0, 0, 1}, 2, 2), createBrick({0, 0, 2}, 2, 2),
                         createBrick({0, 0, 3}, 8, 1), createBrick({2, 0, 2}, 2, 2)});
    StabilityAnalysis analysis(*model, BuildingBase::PLATE);
    const auto solve = [&](const std::vector<std::uint32_t>& parts) { return *analysis.solve(parts); };
    EXPECT_TRUE(solve({0}).stands);
    EXPECT_EQ(solve({0, 2}).falling, (std::vector<std::uint32_t>{2}));
    EXPECT_TRUE(solve({2, 0, 1}).stands);
    const StabilityReport whole = solve({0, 1, 2, 3, 4});
    EXPECT_NEAR(whole.margin, computeStability(*model, {BuildingBase::PLATE, {}})->margin, 1e-9);
    const StabilityReport upper = solve({4, 2});
    EXPECT_TRUE(upper.stands);
    EXPECT_EQ(upper.loads.size(), model->getParts().size());
    EXPECT_EQ(upper.loads[0], 0.0f);
    // Results that are kept between calls don't change them.
    EXPECT_NEAR(solve({0, 1, 2, 3, 4}).margin, whole.margin, 1e-9);
    EXPECT_NEAR(upper.margin, StabilityAnalysis(*model, BuildingBase::PLATE).solve(std::vector{2u, 4u})->margin, 1e-9);
    EXPECT_TRUE(solve({}).stands);
}

} // namespace

} // namespace osgLego::test
