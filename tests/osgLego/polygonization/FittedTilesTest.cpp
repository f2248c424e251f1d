#include <osgLego/polygonization/FittedTiles.h>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

const glm::ivec2 SIZE{640, 360};

glm::vec4 toArea(const glm::vec4& pixels)
{
    return 2.0f * pixels / glm::vec4(SIZE, SIZE) - 1.0f;
}

TEST(FittedTiles, CoverTheirAreaAndFewPixelsBesideIt)
{
    for (float width = 3.5f; width < 130.0f; width += 7.25f)
        for (float left = 20.0f; left < 28.0f; left += 0.75f)
        {
            const float height = 0.7f * width;
            const FittedTiles tiles = FittedTiles::fit(toArea({left, 31.5f, left + width, 31.5f + height}), SIZE);
            const glm::ivec2 end = tiles.first + tiles.count * tiles.side;
            ASSERT_LE(tiles.first.x, static_cast<int>(left));
            ASSERT_LE(tiles.first.y, 31);
            ASSERT_GE(static_cast<float>(end.x), left + width);
            ASSERT_GE(static_cast<float>(end.y), 31.5f + height);
            // At most a block of 4 pixels and half a tile more on each side.
            const int numPixels = tiles.count.x * tiles.count.y * tiles.side * tiles.side;
            EXPECT_LT(static_cast<float>(numPixels), (width + 10.0f) * (height + 10.0f)) << width << " from " << left;
        }
}

TEST(FittedTiles, StayInThePicture)
{
    const FittedTiles corner = FittedTiles::fit({0.95f, 0.95f, 3.0f, 4.0f}, SIZE);
    EXPECT_EQ(corner.first, glm::ivec2(620, 348)) << "624 - 0.5 and 351 - 0.5, in blocks of 4 pixels";
    EXPECT_EQ((corner.count * corner.side), glm::ivec2(24, 12));
    EXPECT_EQ(FittedTiles::fit({-9.0f, -9.0f, -0.95f, -0.95f}, SIZE).first, glm::ivec2(0));
    for (const glm::vec4& outside : {glm::vec4(1.1f, 0.0f, 1.2f, 0.1f), glm::vec4(0.0f, -2.0f, 0.1f, -1.5f)})
        EXPECT_EQ(FittedTiles::fit(outside, SIZE).count, glm::ivec2(0));
    EXPECT_EQ(FittedTiles::fit({-1.0f, -1.0f, 1.0f, 1.0f}, {0, 20}).count, glm::ivec2(0));
}

TEST(FittedTiles, AreForAreasThatAreSmallInThePicture)
{
    EXPECT_TRUE(FittedTiles::isSmall(toArea({10.0f, 10.0f, 137.0f, 137.0f}), SIZE));
    EXPECT_FALSE(FittedTiles::isSmall(toArea({10.0f, 10.0f, 139.0f, 139.0f}), SIZE));
    EXPECT_TRUE(FittedTiles::isSmall({-50.0f, -50.0f, -0.9f, -0.9f}, SIZE)) << "no more than 32 x 18 pixels inside";
}

} // namespace

} // namespace osgLego::test
