#include <booklet/Base64.h>
#include <booklet/BookletText.h>

#include <common/ColorName.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

PartsList::Row createRow(PartFamily family, int width, int length, const std::string& color)
{
    PartsList::Row row;
    row.type = findPartType(family, width, length);
    row.color.name = color;
    row.color.code = 4;
    return row;
}

} // namespace

TEST(Base64Test, EncodesTheExamplesOfTheStandard)
{
    EXPECT_EQ(toBase64(""), "");
    EXPECT_EQ(toBase64("f"), "Zg==");
    EXPECT_EQ(toBase64("fo"), "Zm8=");
    EXPECT_EQ(toBase64("foo"), "Zm9v");
    EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(toBase64("\xff\xfe\xfd"), "//79");
}

TEST(BookletTextTest, DescribesPartsInASentence)
{
    EXPECT_EQ(describeParts(createRow(PartFamily::BRICK, 2, 4, "Dark_Red"), 2), "2 dark red bricks 2 x 4");
    EXPECT_EQ(describeParts(createRow(PartFamily::PLATE, 1, 1, "White"), 1), "1 white plate 1 x 1");
}

TEST(BookletTextTest, NamesColorsAsBrickLinkDoes)
{
    PaletteColor color;
    color.name = "Light_Bluish_Grey";
    EXPECT_EQ(nameBrickLinkColor(color), "");
    color.brickLink = 86;
    EXPECT_EQ(nameBrickLinkColor(color), "Light Bluish Gray");
    EXPECT_EQ(nameColor(color), "Light Bluish Grey");
    color.name = "Medium_Lilac";
    color.brickLink = 89;
    EXPECT_EQ(nameBrickLinkColor(color), "Dark Purple");
}

} // namespace osgLego
