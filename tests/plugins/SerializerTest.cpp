#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <TemporaryFolder.h>

#include <fstream>
#include <sstream>

#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

namespace osgLego::test
{

namespace
{

class Serializer : public TemporaryFolderTest
{
};

TEST_F(Serializer, SettingsAndSourceComeBackFromEveryFormOfOsgsFormat)
{
    LegoSettings settings;
    std::string error;
    ASSERT_TRUE(
        LegoSettings::parse("12,proportions=plate,up=y,method=points,target=addressed,edge=0.5", settings, error));
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->addChild(createSphere(6));
    for (const char* name : {"lego.osgt", "lego.osgb", "lego.osgx"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf(name))) << name;
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf(name));
        const auto* back = dynamic_cast<LegoNode*>(node.get());
        ASSERT_TRUE(back) << name;
        EXPECT_EQ(back->getSettings(), settings);
        // The text forms round the coordinates.
        EXPECT_NEAR(static_cast<double>(back->getBricks()->getBricks().size()),
                    static_cast<double>(lego->getBricks()->getBricks().size()), 20.0);
    }
}

TEST_F(Serializer, BadSettingsInAFileAreSaidAndTheDefaultsTaken)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->addChild(createSphere(4));
    ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf("lego.osgt")));
    std::stringstream text;
    text << std::ifstream(pathOf("lego.osgt")).rdbuf();
    std::string content = text.str();
    const auto place = content.find("Settings");
    ASSERT_NE(place, std::string::npos);
    content.replace(content.find("64", place), 2, "0");
    std::ofstream(pathOf("bad.osgt")) << content;
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf("bad.osgt"));
    if (!node) return; // the reader may refuse the file instead
    const auto* back = dynamic_cast<LegoNode*>(node.get());
    ASSERT_TRUE(back);
    EXPECT_EQ(back->getSettings(), LegoSettings());
}

} // namespace

} // namespace osgLego::test
