#include "BookletModels.h"
#include "FakePictures.h"

#include <booklet/SheetMeasures.h>

#include <sstream>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr std::size_t TWO_COLUMNS = 1;   // of SheetBlock::heads
constexpr std::size_t THREE_COLUMNS = 2; // likewise

/** Measures of a model whose parts all have pictures of one size, in pixels of CSS. */
class SheetMeasuresTest : public testing::Test
{
protected:
    static SheetBlock measureStep(const BookletModel& model, int width, int height, std::size_t step)
    {
        FakePictures pictures(model);
        std::ostringstream stream;
        BookletMarkup markup(model);
        markup.setStream(stream);
        BookletPicture picture;
        picture.width = width;
        picture.height = height;
        for (std::size_t kind = 0; kind < model.getKinds().size(); ++kind)
            markup.writeKind(kind, picture);
        const std::vector<bool> isWhole(model.getChapters().size(), false);
        return SheetMeasures(model, pictures, markup, isWhole).measureStep(0, step, true);
    }
};

TEST_F(SheetMeasuresTest, TheSymbolForTurningTakesNoWidthFromTheList)
{
    // Two parts of 19 mm, which are beside each other in a column of 61 mm.
    const SheetBlock upright = measureStep(createTower(), 162, 160, 2);
    const SheetBlock turned = measureStep(createTower({.turnsOfLastStep = 3}), 162, 160, 2);
    EXPECT_EQ(turned.heads, upright.heads);
    EXPECT_EQ(turned.scales, upright.scales);
    EXPECT_LT(upright.heads[TWO_COLUMNS], upright.heads[THREE_COLUMNS]);
}

TEST_F(SheetMeasuresTest, TheSymbolForTurningIsBelowTheNumber)
{
    // A number of 9 mm and a symbol of 9 mm are higher than a list of one flat part.
    const SheetBlock upright = measureStep(createTower(), 40, 20, 2);
    const SheetBlock turned = measureStep(createTower({.turnsOfLastStep = 3}), 40, 20, 2);
    EXPECT_GT(turned.heads[0], 18.0);
    EXPECT_LT(upright.heads[0], 12.0);
}

TEST_F(SheetMeasuresTest, PicturesOfPartsAreNotShrunkToTheWidthOfTheirColumn)
{
    constexpr double PIXEL_OF_PART = 0.44 * 25.4 / 96.0; // millimetres
    // A number takes at least 11 mm of the width of a column.
    for (const int width : {162, 190, 250})
    {
        const SheetBlock block = measureStep(createTower(), width, 80, 0);
        EXPECT_EQ(block.scales[TWO_COLUMNS], 1.0);
        const double scale = block.scales[THREE_COLUMNS];
        EXPECT_LE(scale * (width * PIXEL_OF_PART + 11.0), SheetArrangement::getColumnWidth(3)) << width;
        EXPECT_LT(block.heads[THREE_COLUMNS], SheetArrangement::HEIGHT) << width;
    }
    EXPECT_EQ(measureStep(createTower(), 162, 80, 0).scales[THREE_COLUMNS], 1.0) << "the longest brick, 2x8";
    EXPECT_GE(measureStep(createTower(), 350, 80, 0).heads[THREE_COLUMNS], SheetFilling::IMPOSSIBLE);
}

} // namespace

} // namespace osgLego::test
