#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/BrickGeometry.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <Probes.h>
#include <TemporaryFolder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Notify>
#include <osg/TriangleFunctor>
#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

namespace osgLego::test
{

namespace
{

class PseudoLoader : public TemporaryFolderTest
{
protected:
    void SetUp() override
    {
        TemporaryFolderTest::SetUp();
        ASSERT_TRUE(osgDB::writeNodeFile(*createSphere(6), pathOf("ball.osgt")));
    }

    static osgDB::ReaderWriter::ReadResult read(const std::string& name, const std::string& options = {})
    {
        osg::ref_ptr<osgDB::Options> readOptions = new osgDB::Options(options);
        return osgDB::Registry::instance()->readNode(name, readOptions);
    }

    /** The bricks in the result of a reader. */
    static osg::ref_ptr<LegoNode> findLego(osg::Object* object)
    {
        if (auto* lego = dynamic_cast<LegoNode*>(object)) return lego;
        auto* group = dynamic_cast<osg::Group*>(object);
        return group && group->getNumChildren() == 1 ? findLego(group->getChild(0)) : nullptr;
    }

    static osg::ref_ptr<LegoNode> readLego(const std::string& name, const std::string& options = {})
    {
        osgDB::ReaderWriter::ReadResult result = read(name, options);
        EXPECT_TRUE(result.validNode()) << name << ": " << result.message();
        return findLego(result.getNode());
    }

    static std::string errorOf(const std::string& name, const std::string& options = {})
    {
        osgDB::ReaderWriter::ReadResult result = read(name, options);
        EXPECT_FALSE(result.validNode()) << name;
        return result.statusMessage();
    }
};

TEST_F(PseudoLoader, PutsTheFileUnderALegoNode)
{
    const osg::ref_ptr<LegoNode> plain = readLego(pathOf("ball.osgt.legolize"));
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->getSettings(), LegoSettings());
    EXPECT_EQ(plain->getNumChildren(), 1u);
    EXPECT_EQ(readLego(pathOf("ball.osgt.32.legolize"))->getSettings().toString(), "32");
    EXPECT_EQ(readLego(pathOf("ball.osgt.(32,proportions=plate,up=y).legolize"))->getSettings().toString(),
              "32,proportions=plate,up=y");
}

TEST_F(PseudoLoader, PutsOnlyBricksOccludedInThePictureUnderAScene)
{
    EXPECT_TRUE(
        dynamic_cast<AmbientOcclusionScene*>(read(pathOf("ball.osgt.(16,occlusion=screen).legolize")).getNode()));
    EXPECT_TRUE(dynamic_cast<AmbientOcclusionScene*>(read(pathOf("ball.osgt.(16,occlusion=both).legolize")).getNode()));
    EXPECT_TRUE(dynamic_cast<LegoNode*>(read(pathOf("ball.osgt.(16,look=plain).legolize")).getNode()));
    osgDB::ReaderWriter::ReadResult result = read(pathOf("ball.osgt.16.legolize"));
    const auto* lego = dynamic_cast<LegoNode*>(result.getNode());
    ASSERT_TRUE(lego);
    EXPECT_EQ(lego->getAppearance().occlusion, BrickOcclusion::GRID);
}

/** A picture of light that comes only from below. */
osg::ref_ptr<osg::Image> createLightFromBelow()
{
    return createLatitudeLongitude(16, [](const osg::Vec3d& direction)
                                   { return osg::Vec3d(1, 1, 1) * (direction.z() < 0.0 ? 1.0 : 0.0); });
}

TEST_F(PseudoLoader, OcclusionChoosesTheQualityOrTheNodeAloneInTheFullLook)
{
    const auto qualityOf = [](const osg::ref_ptr<osg::Node>& node)
    { return dynamic_cast<AmbientOcclusionScene&>(*node).getSettings().quality; };
    const std::string name = pathOf("ball.osgt");
    EXPECT_EQ(qualityOf(read(name + ".(8,occlusion=low).legolize").getNode()), AmbientOcclusionQuality::LOW);
    EXPECT_EQ(qualityOf(read(name + ".occlusion=high.legolize").getNode()), AmbientOcclusionQuality::HIGH);
    EXPECT_EQ(qualityOf(read(name + ".(8,occlusion=screen).legolize").getNode()), AmbientOcclusionQuality::MEDIUM);
    EXPECT_EQ(qualityOf(read(name + ".8.legolize", "occlusion=low").getNode()), AmbientOcclusionQuality::LOW);
    EXPECT_EQ(qualityOf(read(name + ".(occlusion=high).legolize", "8,occlusion=off").getNode()),
              AmbientOcclusionQuality::HIGH);
    osgDB::ReaderWriter::ReadResult off = read(name + ".(8,occlusion=off).legolize");
    const auto* lego = dynamic_cast<LegoNode*>(off.getNode());
    ASSERT_TRUE(lego);
    EXPECT_EQ(lego->getSettings().view.look, Look::FULL);
}

TEST_F(PseudoLoader, SupportedOptionsDescribeEveryKey)
{
    const std::string error = read(pathOf("ball.osgt.(8,colour=red).legolize")).message();
    const std::string start = "the keys are ";
    const auto place = error.find(start);
    ASSERT_NE(place, std::string::npos) << error;
    std::istringstream keys(error.substr(place + start.size()));
    const auto& options = osgDB::Registry::instance()->getReaderWriterForExtension("legolize")->supportedOptions();
    std::size_t count = 0;
    for (std::string key; std::getline(keys >> std::ws, key, ','); ++count)
        EXPECT_TRUE(std::any_of(options.begin(), options.end(),
                                [&](const auto& option) { return option.first.rfind(key + "=", 0) == 0; }))
            << key;
    EXPECT_GT(count, 10u) << error;
}

TEST_F(PseudoLoader, AProbeIsTheLightOfTheBricksAndOfTheOcclusionAroundThem)
{
    const std::string probe = pathOf("light.from.below (1).exr");
    ASSERT_TRUE(osgDB::writeImageFile(*createLightFromBelow(), probe + ".oiio"));
    for (const char* occlusion : {"off", "low"})
    {
        osgDB::ReaderWriter::ReadResult result =
            read(pathOf("ball.osgt.(8,probe=" + probe + ",occlusion=" + occlusion + ").legolize"));
        ASSERT_TRUE(result.validNode()) << result.message();
        const osg::ref_ptr<const LightProbe> ofBricks = findLego(result.getNode())->getLightProbe();
        EXPECT_NEAR(ofBricks->getIrradiance(osg::Vec3d(0, 0, -1)).x(), 1.0, 0.1);
        EXPECT_NEAR(ofBricks->getIrradiance(osg::Vec3d(0, 0, 1)).x(), 0.0, 0.1);
        const auto* scene = dynamic_cast<AmbientOcclusionScene*>(result.getNode());
        EXPECT_EQ(scene != nullptr, std::string(occlusion) == "low");
        if (scene)
        {
            EXPECT_NEAR(scene->getLightProbe()->getIrradiance(osg::Vec3d(0, 0, -1)).x(), 1.0, 0.1);
        }
    }
    // Bricks are turned upright, so that light from below needs no turn.
    const osg::ref_ptr<const LightProbe> upright =
        readLego(pathOf("ball.osgt.(8,up=y,probe=" + probe + ").legolize"))->getLightProbe();
    EXPECT_NEAR(upright->getIrradiance(osg::Vec3d(0, 0, -1)).x(), 1.0, 0.1);
}

TEST_F(PseudoLoader, ARelativeProbeIsLookedForInTheOptionsDataPath)
{
    ASSERT_TRUE(osgDB::writeImageFile(*createLightFromBelow(), pathOf("below.exr.oiio")));
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options("8,probe=below.exr");
    options->getDatabasePathList().push_back(_folder.string());
    osgDB::ReaderWriter::ReadResult result = osgDB::Registry::instance()->readNode("sample.legolize", options);
    ASSERT_TRUE(result.validNode()) << result.message();
    EXPECT_NEAR(findLego(result.getNode())->getLightProbe()->getIrradiance(osg::Vec3d(0, 0, -1)).x(), 1.0, 0.1);
    EXPECT_NE(errorOf("sample.legolize", "8,probe=below.exr").find("'below.exr' was not found"), std::string::npos);
}

TEST_F(PseudoLoader, TakesSettingsFromOptionsAndThoseInTheNameCountForMore)
{
    const std::string options = "24,proportions=brick somethingForAnotherReader";
    EXPECT_EQ(readLego(pathOf("ball.osgt.legolize"), options)->getSettings().toString(), "24,proportions=brick");
    EXPECT_EQ(readLego(pathOf("ball.osgt.48.legolize"), options)->getSettings().toString(), "48,proportions=brick");
}

TEST_F(PseudoLoader, CellsReplaceTheResolutionOfTheOptions)
{
    const osg::ref_ptr<LegoNode> part = readLego("sample.(cell=0.2,origin=0:-1:0,size=9:8:7).legolize", "32,up=y");
    EXPECT_EQ(part->getSettings().toString(), "cell=0.2,origin=0:-1:0,size=9:8:7,up=y");
    EXPECT_EQ(readLego("sample.16.legolize", "cell=0.2")->getSettings().toString(), "16");
}

TEST_F(PseudoLoader, KnowsTheBuiltInModel)
{
    const osg::ref_ptr<LegoNode> sample = readLego("sample.16.legolize");
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->hasTriangles());
}

TEST_F(PseudoLoader, NestsWithOtherPseudoLoaders)
{
    osgDB::ReaderWriter::ReadResult outer = read(pathOf("ball.osgt.16.legolize.(0,0,90).rot"));
    ASSERT_TRUE(outer.validNode()) << outer.message();
    EXPECT_TRUE(dynamic_cast<osg::MatrixTransform*>(outer.getNode()));
    const osg::ref_ptr<LegoNode> inner = readLego(pathOf("ball.osgt.(2,1,1).scale.16.legolize"));
    ASSERT_TRUE(inner);
    EXPECT_EQ(inner->getBricks()->getGrid().dimensions, glm::ivec3(16, 8, 8));
    const osg::ref_ptr<LegoNode> twice = readLego(pathOf("ball.osgt.4.legolize.16.legolize"));
    ASSERT_TRUE(twice);
    EXPECT_GT(twice->getBricks()->getBricks().size(), 100u);
}

TEST_F(PseudoLoader, HandsOutObjectsAsWell)
{
    const osg::ref_ptr<osg::Object> object = osgDB::readRefObjectFile(pathOf("ball.osgt.16.legolize"));
    EXPECT_TRUE(findLego(object));
}

TEST_F(PseudoLoader, SaysWhatIsWrong)
{
    EXPECT_NE(errorOf(pathOf("none.osgt.64.legolize")).find("not found"), std::string::npos);
    EXPECT_NE(errorOf(pathOf("ball.osgt.2000.legolize")).find("bad value '2000' for resolution"), std::string::npos);
    EXPECT_NE(errorOf(pathOf("ball.osgt.(64,colour=red).legolize")).find("unknown key 'colour'"), std::string::npos);
    EXPECT_NE(errorOf(pathOf("ball.osgt.legolize"), "proportions=tile").find("bad value 'tile'"), std::string::npos);
    EXPECT_NE(errorOf("sample.(cell=1e-3).legolize").find("the model reaches into"), std::string::npos);
    EXPECT_NE(
        errorOf("sample.(8,occlusion=best).legolize").find("expected off, grid, screen, both, low, medium or high"),
        std::string::npos);
    EXPECT_NE(errorOf("sample.(8,probe=" + pathOf("ball.osgt") + ").legolize").find("can't be"), std::string::npos);
    std::ofstream(pathOf("strange.xyzzy")) << "?";
    EXPECT_NE(errorOf(pathOf("strange.xyzzy.64.legolize")).find("there is no reader for"), std::string::npos);
    ASSERT_TRUE(osgDB::writeNodeFile(*osg::ref_ptr<osg::Group>(new osg::Group), pathOf("empty.osgt")));
    EXPECT_NE(errorOf(pathOf("empty.osgt.64.legolize")).find("no triangles"), std::string::npos);
}

TEST_F(PseudoLoader, SaysWhyAFileCantBeRead)
{
    EXPECT_NE(errorOf(pathOf("ball.osgt.(16,up=y.legolize")).find("is not closed; expected ')'"), std::string::npos);
    EXPECT_NE(errorOf(pathOf("ball.osgt.(16up=y).legolize")).find("a comma is missing before 'up=y'"),
              std::string::npos);
    std::filesystem::create_directory(pathOf("folder.osgt"));
    EXPECT_NE(errorOf(pathOf("folder.osgt.16.legolize"))
                  .find("can't read '" + pathOf("folder.osgt") + "': it is a folder; expected a file"),
              std::string::npos);
}

TEST_F(PseudoLoader, AFileWithALoneBracketInItsNameIsRead)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*createSphere(6), pathOf("odd(ball.osgt")));
    EXPECT_TRUE(readLego(pathOf("odd(ball.osgt.16.legolize")));
}

/** Collects the number, bounds and colours of the bricks' triangles in a file. */
class Findings : public osg::NodeVisitor
{
public:
    Findings() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Drawable& drawable) override
    {
        osg::TriangleFunctor<Counter> counter;
        drawable.accept(counter);
        numTriangles += counter.count;
        bounds.expandBy(drawable.getBoundingBox());
        const osg::Geometry* geometry = drawable.asGeometry();
        if (const auto* colors = geometry ? dynamic_cast<const osg::Vec4Array*>(geometry->getColorArray()) : nullptr)
            for (const osg::Vec4& color : *colors)
                vertexColors.insert(toBytes(color));
        if (const auto* colors = geometry ? dynamic_cast<const osg::Vec4ubArray*>(geometry->getColorArray()) : nullptr)
            for (const osg::Vec4ub& color : *colors)
                vertexColors.insert({color[0], color[1], color[2]});
        for (const osg::Node* node : getNodePath())
            if (const auto* material = findMaterial(*node))
                materials.insert(toBytes(material->getDiffuse(osg::Material::FRONT)));
    }

    using Color = std::array<std::uint8_t, 3>;
    std::size_t numTriangles = 0;
    osg::BoundingBox bounds;
    std::set<Color> vertexColors;
    std::set<Color> materials;

private:
    struct Counter
    {
        std::size_t count = 0;
        void operator()(const osg::Vec3&, const osg::Vec3&, const osg::Vec3&, bool = false) { ++count; }
    };

    static const osg::Material* findMaterial(const osg::Node& node)
    {
        const osg::StateSet* state = node.getStateSet();
        return state ? dynamic_cast<const osg::Material*>(state->getAttribute(osg::StateAttribute::MATERIAL)) : nullptr;
    }

    static Color toBytes(const osg::Vec4& color)
    {
        Color bytes{};
        for (std::size_t channel = 0; channel < 3; ++channel)
            bytes[channel] = static_cast<std::uint8_t>(std::lround(255.0f * color[static_cast<unsigned int>(channel)]));
        return bytes;
    }
};

/** The messages that OSG writes during the lifetime of an object of this class. */
class Messages : public osg::NotifyHandler
{
public:
    Messages() : _before(osg::getNotifyHandler()) { osg::setNotifyHandler(this); }
    void stop() { osg::setNotifyHandler(_before); }
    void notify(osg::NotifySeverity severity, const char* message) override
    {
        if (severity <= osg::WARN) text += message;
    }

    std::string text;

private:
    ~Messages() override = default;

    osg::ref_ptr<osg::NotifyHandler> _before;
};

class BrickFiles : public PseudoLoader
{
protected:
    void SetUp() override
    {
        PseudoLoader::SetUp();
        _scene = read(pathOf("ball.osgt.8.legolize")).getNode();
        ASSERT_TRUE(_scene);
        const osg::ref_ptr<const BrickModel> model = findLego(_scene)->getBricks();
        _numTriangles = createBrickGeometry(*model)->getPrimitiveSet(0)->getNumIndices() / 3;
        _bounds = model->getGrid().getBrickBounds();
        for (const Brick& brick : model->getBricks())
            if (brick.openSides != 0) _colors.insert(brick.color);
        ASSERT_GT(_colors.size(), 50u);
    }

    /** Write the scene, read it back, and check shape and bounds. */
    Findings writeAndRead(const std::string& name) const
    {
        EXPECT_TRUE(osgDB::writeNodeFile(*_scene, pathOf(name))) << name;
        const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("noRotation");
        const osg::ref_ptr<osg::Node> back = osgDB::readRefNodeFile(pathOf(name), options);
        Findings findings;
        EXPECT_TRUE(back) << name;
        if (!back) return findings;
        back->accept(findings);
        EXPECT_EQ(findings.numTriangles, _numTriangles) << name;
        EXPECT_NEAR((findings.bounds._min - osg::Vec3(_bounds._min)).length(), 0.0, 1e-3) << name;
        EXPECT_NEAR((findings.bounds._max - osg::Vec3(_bounds._max)).length(), 0.0, 1e-3) << name;
        return findings;
    }

    osg::ref_ptr<osg::Node> _scene;
    std::size_t _numTriangles = 0;
    osg::BoundingBoxd _bounds;
    std::set<Findings::Color> _colors;
};

TEST_F(BrickFiles, FormatsWithVertexColorsKeepEveryColorByVertex)
{
    for (const char* name : {"bricks.ive", "bricks.osg", "bricks.flt", "bricks.osg.gz"})
        EXPECT_EQ(writeAndRead(name).vertexColors, _colors) << name;
}

TEST_F(BrickFiles, FormatsWithMaterialsKeepEveryColorAsAMaterial)
{
    for (const char* name : {"bricks.obj", "bricks.3ds", "bricks.ac", "bricks.OBJ"})
        EXPECT_EQ(writeAndRead(name).materials, _colors) << name;
}

TEST_F(BrickFiles, AFormatWithoutColorsKeepsTheShapeAndSaysSoOnce)
{
    const osg::ref_ptr<Messages> messages = new Messages;
    writeAndRead("bricks.stl");
    messages->stop();
    const auto place = messages->text.find("bricks.stl' holds the shape of the bricks without their colours");
    EXPECT_NE(place, std::string::npos) << messages->text;
    EXPECT_EQ(messages->text.find("without their colours", place + 60), std::string::npos) << messages->text;
}

TEST_F(BrickFiles, AWriterThatCantKeepBricksIsAnErrorAndLeavesNoFile)
{
    for (const char* name : {"bricks.iv", "bricks.wrl"})
    {
        const auto result = osgDB::Registry::instance()->writeNode(*_scene, pathOf(name), nullptr);
        EXPECT_FALSE(result.success()) << name;
        EXPECT_NE(result.message().find(std::string(name)), std::string::npos) << result.message();
        EXPECT_FALSE(std::filesystem::exists(pathOf(name))) << name;
    }
}

TEST_F(BrickFiles, ObjectsAreWrittenAsNodesAre)
{
    ASSERT_TRUE(osgDB::writeObjectFile(*_scene, pathOf("bricks.ive")));
    const osg::ref_ptr<osg::Node> back = osgDB::readRefNodeFile(pathOf("bricks.ive"));
    ASSERT_TRUE(back);
    Findings findings;
    back->accept(findings);
    EXPECT_EQ(findings.numTriangles, _numTriangles);
}

TEST_F(BrickFiles, FilesWithoutBricksAreWrittenAsEver)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*createSphere(6), pathOf("sphere.obj")));
    const osg::ref_ptr<osg::Node> back = osgDB::readRefNodeFile(pathOf("sphere.obj"));
    ASSERT_TRUE(back);
    Findings findings;
    back->accept(findings);
    EXPECT_EQ(findings.numTriangles, 2u * 2u * 6u * 6u);
}

} // namespace

} // namespace osgLego::test
