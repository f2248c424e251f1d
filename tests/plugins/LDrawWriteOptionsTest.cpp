#include <ldraw/LDrawWriteOptions.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(LDrawWriteOptions, HasTheBasePlateOfEither)
{
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("author=Ann base=plate");
    EXPECT_TRUE(LDrawWriteOptions::read(options).isOnPlate);
    options->setOptionString("base=table");
    EXPECT_FALSE(LDrawWriteOptions::read(options).isOnPlate);
    options->setPluginStringData("BASE", "plate");
    EXPECT_TRUE(LDrawWriteOptions::read(options).isOnPlate);
    EXPECT_FALSE(LDrawWriteOptions::read(nullptr).isOnPlate);
}

} // namespace

} // namespace osgLego::test
