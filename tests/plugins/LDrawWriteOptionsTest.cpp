#include <ldraw/LDrawWriteOptions.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

LDrawWriteOptions readOptions(const osg::ref_ptr<osgDB::Options>& options)
{
    std::string error;
    const std::optional<LDrawWriteOptions> read = LDrawWriteOptions::read(options, error);
    EXPECT_EQ(error, "");
    return read.value_or(LDrawWriteOptions());
}

TEST(LDrawWriteOptions, HaveTheTextsOfAnOptionString)
{
    const ModelHeader header =
        readOptions(new osgDB::Options("nolicense=x author=\"Ann Smith\" license=MIT title=\"My car\"")).header;
    EXPECT_EQ(header.author, "Ann Smith");
    EXPECT_EQ(header.license, "MIT");
    EXPECT_EQ(header.title, "My car");
}

TEST(LDrawWriteOptions, PluginDataComesBeforeTheOptionString)
{
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("author=Ann");
    options->setPluginStringData("AUTHOR", "Bob Smith");
    EXPECT_EQ(readOptions(options).header.author, "Bob Smith");
}

TEST(LDrawWriteOptions, GrantAndRefuseNothingByDefault)
{
    for (const osg::ref_ptr<osgDB::Options>& options :
         {osg::ref_ptr<osgDB::Options>(), osg::ref_ptr(new osgDB::Options)})
    {
        EXPECT_EQ(readOptions(options).header.license, "");
        EXPECT_EQ(readOptions(options).header.author, "");
        EXPECT_FALSE(readOptions(options).isOnPlate);
    }
}

TEST(LDrawWriteOptions, HaveTheBasePlateOfEither)
{
    EXPECT_TRUE(readOptions(new osgDB::Options("author=Ann base=plate")).isOnPlate);
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    options->setPluginStringData("BASE", "plate");
    EXPECT_TRUE(readOptions(options).isOnPlate);
}

TEST(LDrawWriteOptions, KeysInTextsAreNone)
{
    const LDrawWriteOptions options = readOptions(new osgDB::Options("title=\"a base=plate b\" author=title=x"));
    EXPECT_FALSE(options.isOnPlate);
    EXPECT_EQ(options.header.title, "a base=plate b");
    EXPECT_EQ(options.header.author, "title=x");
}

TEST(LDrawWriteOptions, AnotherBaseIsAnError)
{
    std::string error;
    EXPECT_FALSE(LDrawWriteOptions::read(osg::ref_ptr(new osgDB::Options("base=Plate")), error));
    EXPECT_EQ(error, "bad value 'Plate' for base; expected plate");
}

} // namespace

} // namespace osgLego::test
