#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <Notices.h>
#include <TemporaryFolder.h>

#include <algorithm>
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

TEST_F(Serializer, SettingsAndSourceSurviveEveryVariantOfOsgsFormat)
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
        // The text formats round the coordinates.
        EXPECT_NEAR(static_cast<double>(back->getBricks()->getBricks().size()),
                    static_cast<double>(lego->getBricks()->getBricks().size()), 20.0);
    }
}

TEST_F(Serializer, CellsOriginAndSizeSurvive)
{
    LegoSettings settings;
    std::string error;
    ASSERT_TRUE(LegoSettings::parse("cell=0.1,origin=-0.5:0.25:1e-3,size=5:6:7", settings, error)) << error;
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->addChild(createSphere(6));
    for (const char* name : {"part.osgt", "part.osgb", "part.osgx"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf(name))) << name;
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf(name));
        const auto* back = dynamic_cast<LegoNode*>(node.get());
        ASSERT_TRUE(back) << name;
        EXPECT_EQ(back->getSettings(), settings);
    }
}

TEST_F(Serializer, SettingsOfFilesWithoutCellsAreRead)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->addChild(createSphere(4));
    ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf("lego.osgt")));
    std::stringstream text;
    text << std::ifstream(pathOf("lego.osgt")).rdbuf();
    std::string content = text.str();
    const auto place = content.find("\"64\"");
    ASSERT_NE(place, std::string::npos);
    // As version 0.1.0 wrote it.
    content.replace(place, 4, "\"7,proportions=plate,up=y,method=points,target=addressed,fbo=16,edge=3.25\"");
    std::ofstream(pathOf("old.osgt")) << content;
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf("old.osgt"));
    const auto* back = dynamic_cast<LegoNode*>(node.get());
    ASSERT_TRUE(back);
    EXPECT_EQ(back->getSettings().toString(),
              "7,proportions=plate,up=y,method=points,target=addressed,fbo=16,edge=3.25");
}

TEST_F(Serializer, AppearanceAndLightSurvive)
{
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(4, 2, 1, GL_RGB, GL_FLOAT);
    std::fill_n(reinterpret_cast<float*>(picture->data()), 4 * 2 * 3, 0.5f);
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    std::string error;
    ASSERT_TRUE(probe->setImage(picture, LightProbe::LATITUDE_LONGITUDE, error)) << error;
    probe->setRotation(osg::Quat(0.5, osg::Vec3d(0, 0, 1)));
    probe->setIntensity(2.0);

    osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->addChild(createSphere(6));
    BrickAppearance appearance;
    appearance.joints = false;
    appearance.variation = 0.5;
    lego->setAppearance(appearance);
    lego->setLightProbe(probe);
    osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    AmbientOcclusionSettings settings;
    ASSERT_TRUE(AmbientOcclusionSettings::parse("high,radius=0.25,show=irradiance", settings, error)) << error;
    scene->setSettings(settings);
    scene->setLightProbe(probe);
    scene->setEnabled(false);
    scene->addChild(lego);
    for (const char* name : {"look.osgt", "look.osgb"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*scene, pathOf(name))) << name;
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf(name));
        const auto* back = dynamic_cast<AmbientOcclusionScene*>(node.get());
        ASSERT_TRUE(back) << name;
        EXPECT_EQ(back->getSettings(), settings);
        EXPECT_FALSE(back->getEnabled());
        EXPECT_DOUBLE_EQ(back->getLightProbe()->getIntensity(), 2.0);
        EXPECT_NEAR(back->getLightProbe()->getRotation().z(), probe->getRotation().z(), 1e-5);
        EXPECT_NEAR(back->getLightProbe()->getIrradiance(osg::Vec3d(0, 0, 1)).x(), 1.0, 0.01);
        const auto* backLego = dynamic_cast<const LegoNode*>(back->getChild(0));
        ASSERT_TRUE(backLego) << name;
        const BrickAppearance backAppearance = backLego->getAppearance();
        EXPECT_FALSE(backAppearance.joints);
        EXPECT_DOUBLE_EQ(backAppearance.variation, 0.5);
        EXPECT_NEAR(backAppearance.reliefHeight, appearance.reliefHeight, 1e-9); // the text format rounds it
        const osg::ref_ptr<const LightProbe> backProbe = backLego->getLightProbe();
        EXPECT_NEAR(backProbe->getIrradiance(osg::Vec3d(0, 0, 1)).x(), 1.0, 0.01);
    }
}

TEST_F(Serializer, BadSettingsInAFileGiveAWarningAndTheDefaults)
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
    osg::ref_ptr<osg::Node> node;
    const std::string notices = noticesOf([&] { node = osgDB::readRefNodeFile(pathOf("bad.osgt")); });
    EXPECT_NE(notices.find("bad value '0' for resolution"), std::string::npos) << notices;
    const auto* back = dynamic_cast<LegoNode*>(node.get());
    ASSERT_TRUE(back);
    EXPECT_EQ(back->getSettings(), LegoSettings());
    EXPECT_EQ(back->getNumChildren(), 1u);
}

} // namespace

} // namespace osgLego::test
