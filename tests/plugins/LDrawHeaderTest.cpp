#include <ldraw/LDrawHeader.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(LDrawHeader, HasTheTextsOfAnOptionString)
{
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("nolicense=x author=\"Ann Smith\" license=MIT title=\"My car\"");
    const ModelHeader header = readLDrawHeader(options);
    EXPECT_EQ(header.author, "Ann Smith");
    EXPECT_EQ(header.license, "MIT");
    EXPECT_EQ(header.title, "My car");
}

TEST(LDrawHeader, PluginDataComesBeforeTheOptionString)
{
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("author=Ann");
    options->setPluginStringData("AUTHOR", "Bob Smith");
    EXPECT_EQ(readLDrawHeader(options).author, "Bob Smith");
}

TEST(LDrawHeader, GrantsAndRefusesNothingByDefault)
{
    for (const osg::ref_ptr<osgDB::Options>& options :
         {osg::ref_ptr<osgDB::Options>(), osg::ref_ptr(new osgDB::Options)})
    {
        const ModelHeader header = readLDrawHeader(options);
        EXPECT_EQ(header.license, "");
        EXPECT_EQ(header.author, "");
    }
}

} // namespace

} // namespace osgLego::test
