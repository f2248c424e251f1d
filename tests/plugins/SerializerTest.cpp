#include <common/RacingCar.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <Notices.h>
#include <PartModels.h>
#include <Settings.h>
#include <TemporaryFolder.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

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
    const LegoSettings settings = parseSettings("12,proportions=plate,up=y,method=points,target=addressed,edge=0.5");
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
    const LegoSettings settings = parseSettings("cell=0.1,origin=-0.5:0.25:1e-3,size=5:6:7");
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

TEST_F(Serializer, SettingsSurviveIfTheirPaletteIsMissingAndAnObstacleNamesIt)
{
    for (const char* palette :
         {"palette.csv", "my  new\tpalette.csv", "a--b---c.csv", "50%20.csv", "\"a\\b\" & <c>.csv"})
        for (const char* name : {"lego.osgt", "lego.osgb", "lego.osgx"})
        {
            SCOPED_TRACE(std::string(palette) + " " + name);
            LegoSettings settings = parseSettings("32,proportions=plate,parts=bricks,look=plain");
            settings.colors.palette = pathOf(palette);
            std::ofstream(*settings.colors.palette)
                << "code,name,rgb,edge,bricklink,bricks,plates\n4,Red,#B40000,#333333,5,11111111111,11111111111\n";
            osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
            ASSERT_EQ(lego->getSettings(), settings);
            lego->addChild(createSphere(6));
            ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf(name)));
            std::filesystem::remove(*settings.colors.palette);
            const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf(name));
            const auto* back = dynamic_cast<LegoNode*>(node.get());
            ASSERT_TRUE(back);
            EXPECT_EQ(back->getSettings(), settings);
            EXPECT_EQ(back->getNumChildren(), 1u);
            EXPECT_NE(back->getObstacle().find(*settings.colors.palette), std::string::npos) << back->getObstacle();
        }
}

TEST_F(Serializer, SettingsOfFilesWithoutCellsAreRead)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->addChild(createSphere(4));
    ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf("lego.osgt")));
    std::string content = contentsOf(pathOf("lego.osgt"));
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
    appearance.occlusion = BrickOcclusion::SCREEN;
    appearance.distantOcclusion = false;
    appearance.joints = false;
    appearance.variation = 0.5;
    appearance.outline = 1.5;
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
        EXPECT_DOUBLE_EQ(backAppearance.outline, 1.5);
        EXPECT_EQ(backAppearance.occlusion, BrickOcclusion::SCREEN);
        EXPECT_FALSE(backAppearance.distantOcclusion);
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
    std::string content = contentsOf(pathOf("lego.osgt"));
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

/** A car, stored as bricks in files of OSG's own formats. */
class StoredBricks : public Serializer
{
protected:
    void SetUp() override
    {
        Serializer::SetUp();
        const LegoSettings settings = parseSettings("16,proportions=plate");
        _lego = new LegoNode(settings);
        _lego->addChild(createRacingCar());
        _bricks = _lego->getBricks();
    }

    /** Write the car. @return the bytes of the file. */
    std::string write(const std::string& name)
    {
        const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("bake");
        EXPECT_TRUE(osgDB::writeNodeFile(*_lego, pathOf(name), options)) << name;
        return contentsOf(pathOf(name));
    }

    osg::ref_ptr<osg::Node> readFile(const std::string& name) { return osgDB::readRefNodeFile(pathOf(name)); }

    /** Read a file with these bytes. @return null, after checking that there is a message. */
    osg::ref_ptr<osg::Node> readDamaged(const std::string& name, const std::string& bytes)
    {
        std::ofstream(pathOf(name), std::ios::binary) << bytes;
        osg::ref_ptr<osg::Node> node;
        const std::string notices = noticesOf([&] { node = readFile(name); });
        EXPECT_TRUE(node || !notices.empty()) << name;
        return node;
    }

    /** Whether a node has the bricks of the car; no other node may be read. */
    void expectCar(osg::Node* node, const std::string& where)
    {
        const auto* lego = dynamic_cast<LegoNode*>(node);
        ASSERT_TRUE(lego) << where;
        ASSERT_TRUE(lego->getStoredBricks()) << where;
        EXPECT_EQ(lego->getStoredBricks()->getGrid(), _bricks->getGrid()) << where;
        EXPECT_TRUE(lego->getStoredBricks()->getBricks() == _bricks->getBricks()) << where;
    }

    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<const BrickModel> _bricks;
};

TEST_F(StoredBricks, EqualBricksSettingsAndLookWithoutTheSourceSurviveEveryVariantOfOsgsFormat)
{
    BrickAppearance appearance;
    appearance.joints = false;
    _lego->setAppearance(appearance);
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    probe->setIntensity(2.0);
    _lego->setLightProbe(probe);
    _lego->setName("a \"car\"");
    for (const char* name : {"car.osgt", "car.osgb", "car.osgx"})
    {
        write(name);
        const osg::ref_ptr<osg::Node> node = readFile(name);
        expectCar(node, name);
        const auto& lego = dynamic_cast<LegoNode&>(*node);
        EXPECT_EQ(lego.getNumChildren(), 0u);
        EXPECT_EQ(lego.getSettings(), _lego->getSettings());
        EXPECT_FALSE(lego.getAppearance().joints);
        EXPECT_DOUBLE_EQ(lego.getLightProbe()->getIntensity(), 2.0);
        EXPECT_EQ(lego.getName(), "a \"car\"");
    }
}

TEST_F(StoredBricks, TheySurviveWritingAgainWithAndWithoutTheOption)
{
    write("car.osgb");
    const osg::ref_ptr<osg::Node> first = readFile("car.osgb");
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("bake");
    ASSERT_TRUE(osgDB::writeNodeFile(*first, pathOf("again.osgt"), options));
    expectCar(readFile("again.osgt"), "with the option");
    ASSERT_TRUE(osgDB::writeNodeFile(*first, pathOf("again.osgx")));
    expectCar(readFile("again.osgx"), "without the option");
}

TEST_F(StoredBricks, PartsSurviveEveryVariantOfOsgsFormatAndWritingAgain)
{
    PartFilling filling;
    filling.heights = {1, 3};
    filling.colors = {{200, 30, 20}, {20, 80, 170}};
    const osg::ref_ptr<const BrickModel> model = createParts(createPartGrid({12, 9, 6}, 0.4), filling);
    osg::ref_ptr<LegoNode> lego = createStoredNode(*model, "12");
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("bake");
    for (const char* name : {"parts.osgt", "parts.osgb", "parts.osgx"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf(name), options)) << name;
        const osg::ref_ptr<osg::Node> node = readFile(name);
        lego = dynamic_cast<LegoNode*>(node.get());
        ASSERT_TRUE(lego && lego->getStoredBricks()) << name;
        EXPECT_TRUE(lego->getStoredBricks()->getParts() == model->getParts()) << name;
        EXPECT_TRUE(lego->getStoredBricks()->getPartIndices() == model->getPartIndices()) << name;
        EXPECT_TRUE(lego->getStoredBricks()->getBricks() == model->getBricks()) << name;
    }
}

TEST_F(StoredBricks, PartsThatAreTooLargeAreNotWritten)
{
    BrickGrid grid;
    grid.dimensions = {8, 8, 4};
    Part part;
    part.size = {8, 8, 4};
    const osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->setStoredBricks(BrickModel::createOfParts(grid, {part}));
    for (const char* name : {"large.osgt", "large.osgb", "large.osgx"})
    {
        const std::string notices = noticesOf([&] { EXPECT_FALSE(osgDB::writeNodeFile(*lego, pathOf(name))) << name; });
        EXPECT_NE(notices.find("a part has 256 cells; expected at most 48"), std::string::npos) << notices;
    }
}

TEST_F(StoredBricks, EmptyModelsAndEmptyNodesSurvive)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const osg::ref_ptr<LegoNode> stored = new LegoNode;
    stored->setStoredBricks(BrickModel::create(BrickGrid(), {}));
    scene->addChild(stored);
    scene->addChild(new LegoNode);
    for (const char* name : {"empty.osgt", "empty.osgb", "empty.osgx"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*scene, pathOf(name)));
        const osg::ref_ptr<osg::Node> node = readFile(name);
        ASSERT_TRUE(node && node->asGroup() && node->asGroup()->getNumChildren() == 2) << name;
        const auto& first = dynamic_cast<LegoNode&>(*node->asGroup()->getChild(0));
        ASSERT_TRUE(first.getStoredBricks()) << name;
        EXPECT_TRUE(first.getStoredBricks()->getBricks().empty());
        EXPECT_EQ(first.getStoredBricks()->getGrid(), BrickGrid());
        EXPECT_FALSE(dynamic_cast<LegoNode&>(*node->asGroup()->getChild(1)).getStoredBricks());
    }
}

TEST_F(StoredBricks, LargeModelsSurviveEveryVariantOfOsgsFormat)
{
    // Random colours can't be compressed, so that the bytes have several parts.
    std::mt19937 engine(1);
    BrickGrid grid;
    grid.dimensions = {50, 50, 50};
    std::vector<Brick> bricks;
    for (int number = 0; number < 50 * 50 * 50; ++number)
    {
        Brick brick;
        brick.cell = {static_cast<std::uint16_t>(number % 50), static_cast<std::uint16_t>(number / 50 % 50),
                      static_cast<std::uint16_t>(number / 2500)};
        for (std::uint8_t& channel : brick.color)
            channel = static_cast<std::uint8_t>(engine());
        bricks.push_back(brick);
    }
    _bricks = BrickModel::create(grid, bricks);
    _lego->setStoredBricks(_bricks);
    for (const char* name : {"large.osgt", "large.osgb", "large.osgx"})
    {
        EXPECT_GT(write(name).size(), 300000u);
        expectCar(readFile(name), name);
    }
}

TEST_F(StoredBricks, ADamagedFileIsRefused)
{
    // OSG itself reads the header, with the version of its format and the name of the compressor, and in text formats
    // the names of properties. Only the bricks follow the place that is searched for.
    const std::pair<const char*, const char*> files[]{
        {"car.osgb", "zlib"}, {"car.osgt", "StoredBricks "}, {"car.osgx", "StoredBricks attribute="}};
    for (const auto& [name, mark] : files)
    {
        const std::string good = write(name);
        const std::size_t begin = good.find(mark) + std::string(mark).size();
        ASSERT_LT(begin, good.size());
        for (std::size_t place = begin; place < good.size(); place += 5)
        {
            std::string damaged = good;
            damaged[place] = static_cast<char>(damaged[place] ^ 0x15);
            if (const osg::ref_ptr<osg::Node> node = readDamaged(name, damaged))
                expectCar(node, std::string(name) + " " + std::to_string(place));
        }
    }
}

TEST_F(StoredBricks, ATruncatedFileIsRefused)
{
    for (const char* name : {"car.osgb", "car.osgt", "car.osgx"})
    {
        const std::string good = write(name);
        const std::size_t end = good.find_last_not_of("\n ");
        for (std::size_t size = good.size() / 20; size < end; size += 7)
        {
            // XML files may end without their last brackets.
            const osg::ref_ptr<osg::Node> node = readDamaged(name, good.substr(0, size));
            if (node && size > good.rfind('"'))
                expectCar(node, name);
            else
                EXPECT_FALSE(node) << name << " " << size;
        }
    }
}

TEST_F(StoredBricks, AMessageNamesTheReason)
{
    std::string text = write("car.osgt");
    text[text.find("StoredBricks") + 40] ^= 1;
    std::ofstream(pathOf("car.osgt")) << text;
    const std::string notices = noticesOf([&] { EXPECT_FALSE(readFile("car.osgt")); });
    EXPECT_NE(notices.find("the stored bricks are damaged or incomplete"), std::string::npos) << notices;
}

} // namespace

} // namespace osgLego::test
