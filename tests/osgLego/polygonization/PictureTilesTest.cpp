#include <osgLego/polygonization/PictureTiles.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Numbers = std::vector<int>;

TEST(PictureTiles, AreThoseThatAnAreaLiesIn)
{
    PictureTiles tiles;
    tiles.clear({64, 48});
    EXPECT_EQ(tiles.getNumAcross(), 4);
    tiles.add({-0.4f, -0.2f, 0.4f, 0.9f}); // pixels 19 to 45, and 19 to 46
    tiles.findRuns();
    EXPECT_EQ(tiles.getFirsts(), (Numbers{5, 9}));
    EXPECT_EQ(tiles.getCounts(), (Numbers{2, 2}));
}

TEST(PictureTiles, GoOnFromRowToRow)
{
    PictureTiles tiles;
    tiles.clear({64, 48});
    tiles.add({-1.0f, -1.0f, 1.0f, 1.0f});
    tiles.findRuns();
    EXPECT_EQ(tiles.getFirsts(), Numbers{0});
    EXPECT_EQ(tiles.getCounts(), Numbers{12});
}

TEST(PictureTiles, APictureWithoutPixelsHasNone)
{
    PictureTiles tiles;
    for (const glm::ivec2& size : {glm::ivec2(0, 0), glm::ivec2(0, 20), glm::ivec2(40, 0)})
    {
        tiles.clear(size);
        tiles.add({-1.0f, -1.0f, 1.0f, 1.0f});
        tiles.findRuns();
        EXPECT_TRUE(tiles.getFirsts().empty());
    }
}

TEST(PictureTiles, StayInThePicture)
{
    PictureTiles tiles;
    tiles.clear({40, 20});
    tiles.add({0.9f, 0.9f, 7.0f, 8.0f});
    tiles.findRuns();
    EXPECT_EQ(tiles.getFirsts(), Numbers{5}) << "the last one, beyond whose middle the picture ends";
    tiles.clear({40, 20});
    tiles.findRuns();
    EXPECT_TRUE(tiles.getFirsts().empty());
}

} // namespace

} // namespace osgLego::test
