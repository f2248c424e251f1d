#include <common/ReadableName.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(ReadableName, HasWordsWithCapitalsInsteadOfTheSignsOfFileNames)
{
    EXPECT_EQ(toReadableName("stanford_bunny-v2.ply"), "Stanford Bunny v2");
    EXPECT_EQ(toReadableName("racing-car"), "Racing Car");
    EXPECT_EQ(toReadableName("small__tower_"), "Small Tower");
    EXPECT_EQ(toReadableName("myTower of NASA.mpd"), "MyTower Of NASA");
    EXPECT_EQ(toReadableName("vase.obj"), "Vase");
    EXPECT_EQ(toReadableName(""), "");
}

TEST(ReadableName, LeavesFoldersAndSettingsOut)
{
    EXPECT_EQ(toReadableName("models.64/bunny.ply.(64,palette=/a/b.csv).legolize"), "Bunny");
    EXPECT_EQ(toReadableName("mug.ply.90,0,0.rot.24.legolize"), "Mug");
    EXPECT_EQ(toReadableName("/models/two\nlines"), "Two Lines");
}

} // namespace

} // namespace osgLego::test
