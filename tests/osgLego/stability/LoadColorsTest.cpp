#include "BrickTowers.h"

#include <osgLego/stability/LoadColors.h>

#include <array>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

TEST(LoadColors, GoFromBlueOverGreenAndYellowToRed)
{
    EXPECT_EQ(findLoadColor(0.0f), (Color{49, 84, 190}));
    EXPECT_EQ(findLoadColor(1.0f / 3.0f), (Color{38, 160, 90}));
    EXPECT_EQ(findLoadColor(2.0f / 3.0f), (Color{240, 205, 40}));
    EXPECT_EQ(findLoadColor(1.0f), (Color{205, 30, 30}));
    EXPECT_EQ(findLoadColor(-0.5f), (Color{49, 84, 190}));
    EXPECT_EQ(findLoadColor(7.0f), (Color{205, 30, 30}));
    EXPECT_EQ(findLoadColor(std::numeric_limits<float>::quiet_NaN()), (Color{128, 128, 128}));
}

TEST(LoadColors, AreMixedBetweenTheColorsOfThirds)
{
    EXPECT_EQ(findLoadColor(0.5f), (Color{139, 183, 65}));  // (38 + 240) / 2, (160 + 205) / 2 and (90 + 40) / 2
    EXPECT_EQ(findLoadColor(0.75f), (Color{231, 161, 38})); // a quarter from yellow to red
}

TEST(LoadColors, PartsAreColoredByTheirLoad)
{
    // Nothing pulls in the column, and the third part is in the air.
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 2, 2), createBrick({0, 0, 1}, 2, 2), createBrick({9, 0, 1}, 2, 2)});
    const osg::ref_ptr<const BrickModel> colored = colorByLoad(*model);
    EXPECT_EQ(colored->getParts()[0].color, (Color{49, 84, 190}));
    EXPECT_EQ(colored->getParts()[1].color, (Color{49, 84, 190}));
    EXPECT_EQ(colored->getParts()[2].color, (Color{220, 0, 200}));
    EXPECT_EQ(model->getParts()[0].color, Color{});
    EXPECT_FALSE(colorByLoad(*model, [] { return true; }));
    const osg::ref_ptr<const BrickModel> cells = BrickModel::create(model->getGrid(), model->getBricks());
    EXPECT_EQ(colorByLoad(*cells), cells);
}

TEST(LoadColors, AreThoseOfTheLoadOnBothPartsOfAJoint)
{
    // A brick 1 x 8 of 3.03 g on the last stud of another one. Its lever is 3.5 - 1/4, so that it pulls with 0.0965 N,
    // which is 0.295 of a third of 0.98 N.
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 8, 1), createBrick({7, 0, 1}, 8, 1)});
    const osg::ref_ptr<const BrickModel> colored = colorByLoad(*model);
    EXPECT_EQ(colored->getParts()[0].color, (Color{46, 106, 160}));
    EXPECT_EQ(colored->getParts()[1].color, (Color{46, 106, 160}));
}

} // namespace

} // namespace osgLego::test
