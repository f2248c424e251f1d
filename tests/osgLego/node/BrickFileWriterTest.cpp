#include <osgLego/LegoNode.h>
#include <osgLego/node/BrickFileWriter.h>

#include <Meshes.h>
#include <Notices.h>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Image>
#include <osgDB/Registry>

namespace osgLego::test
{

namespace
{

using WriteResult = osgDB::ReaderWriter::WriteResult;

/** Keeps the objects that it is asked to write, and returns a result without writing. */
class Recorder : public osgDB::WriteFileCallback
{
public:
    WriteResult writeNode(const osg::Node& node, const std::string&, const osgDB::Options*) override
    {
        written = &node;
        return answer;
    }
    WriteResult writeObject(const osg::Object& object, const std::string&, const osgDB::Options*) override
    {
        written = &object;
        return answer;
    }
    WriteResult writeImage(const osg::Image& image, const std::string&, const osgDB::Options*) override
    {
        written = &image;
        return answer;
    }

    osg::ref_ptr<const osg::Object> written;
    WriteResult answer = WriteResult(WriteResult::FILE_NOT_HANDLED);
};

class BrickFileWriterTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        LegoSettings settings;
        settings.grid.resolution = 8;
        _lego->setSettings(settings);
        _lego->addChild(createSphere(4));
    }

    osg::ref_ptr<LegoNode> _lego = new LegoNode;
    osg::ref_ptr<Recorder> _next = new Recorder;
    osg::ref_ptr<BrickFileWriter> _writer = new BrickFileWriter(_next);
};

TEST_F(BrickFileWriterTest, TheFirstNodeInstallsOneInTheRegistry)
{
    EXPECT_TRUE(dynamic_cast<BrickFileWriter*>(osgDB::Registry::instance()->getWriteFileCallback()));
}

TEST_F(BrickFileWriterTest, TheNextCallbackGetsTheNodeForOsgsOwnFormatsAndBricksForOthers)
{
    for (const char* name : {"lego.osgt", "lego.OSGB", "lego.osgx", "lego.osgt.gz"})
    {
        _writer->writeNode(*_lego, name, nullptr);
        EXPECT_EQ(_next->written, _lego) << name;
        _writer->writeObject(*_lego, name, nullptr);
        EXPECT_EQ(_next->written, _lego) << name;
    }
    for (const char* name : {"lego.obj", "lego.ive", "lego.osg", "lego.ive.gz", "lego.unknown", "lego"})
    {
        _writer->writeNode(*_lego, name, nullptr);
        EXPECT_TRUE(dynamic_cast<const osg::Geode*>(_next->written.get())) << name;
        _writer->writeObject(*_lego, name, nullptr);
        EXPECT_TRUE(dynamic_cast<const osg::Geode*>(_next->written.get())) << name;
    }
}

TEST_F(BrickFileWriterTest, AModelWhoseBricksCannotBeMadeIsNotWrittenAsItsMesh)
{
    LegoSettings settings;
    settings.grid.resolution = 600;
    settings.parts.fill = Fill::SOLID;
    _lego->setSettings(settings);
    for (const char* name : {"lego.obj", "lego.ldr", "lego.ive"})
    {
        const WriteResult result = _writer->writeNode(*_lego, name, nullptr);
        EXPECT_TRUE(result.error()) << name;
        EXPECT_NE(result.message().find("cells; expected at most 67108864"), std::string::npos) << result.message();
        EXPECT_FALSE(_next->written) << name;
    }
    _writer->writeNode(*_lego, "lego.osgt", nullptr);
    EXPECT_EQ(_next->written, _lego);
}

TEST_F(BrickFileWriterTest, TheOptionBakeStoresBricksInOsgsOwnFormats)
{
    const auto writtenWith = [&](const char* name, const char* options)
    {
        const osg::ref_ptr<osgDB::Options> parsed = new osgDB::Options(options);
        _writer->writeNode(*_lego, name, parsed);
        return dynamic_cast<const LegoNode*>(_next->written.get());
    };
    for (const char* name : {"lego.osgt", "lego.osgb", "lego.osgx"})
        for (const char* options : {"bake", "Ascii bake", "64,up=y  bake noRotation"})
        {
            const LegoNode* baked = writtenWith(name, options);
            ASSERT_TRUE(baked) << name;
            EXPECT_EQ(baked->getStoredBricks(), _lego->getBricks()) << options;
        }
    for (const char* options : {"", "rebake", "bake=no", "Bake"})
        EXPECT_EQ(writtenWith("lego.osgb", options), _lego) << options;
    EXPECT_FALSE(writtenWith("lego.obj", "bake")) << "this format has geometry in any case";
}

TEST_F(BrickFileWriterTest, TheOptionBakeGivesOneWarningIfASceneWithoutBricksIsWritten)
{
    const osg::ref_ptr<osgDB::Options> bake = new osgDB::Options("bake");
    const auto noticesFor = [&](const osg::Node& node, const osgDB::Options* options)
    { return noticesOf([&] { _writer->writeNode(node, "scene.osgb", options); }); };
    const osg::ref_ptr<osg::Node> sphere = createSphere(4);
    EXPECT_EQ(noticesFor(*sphere, bake), "") << "nothing was written";
    _next->answer = WriteResult(WriteResult::FILE_SAVED);
    EXPECT_EQ(noticesFor(*sphere, bake), "osgLego: 'scene.osgb' holds no bricks, because the scene has none to bake; "
                                         "expected a LegoNode with triangles, as from 'bunny.ply.64.legolize'\n");
    EXPECT_EQ(_next->written, sphere);
    EXPECT_EQ(noticesFor(*sphere, nullptr), "");
    EXPECT_EQ(noticesFor(*_lego, bake), "");
}

TEST_F(BrickFileWriterTest, ObjectsOtherThanScenesArePassedOn)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    _writer->writeImage(*image, "image.png", nullptr);
    EXPECT_EQ(_next->written, image);
    _next->written = nullptr;
    _writer->writeObject(*image, "image.png", nullptr);
    EXPECT_EQ(_next->written, image);
}

TEST_F(BrickFileWriterTest, AWriterThatReportsSuccessWithoutAFileIsAnError)
{
    _next->answer = WriteResult(WriteResult::FILE_SAVED);
    const WriteResult result = _writer->writeNode(*_lego, "/none/lego.obj", nullptr);
    EXPECT_FALSE(result.success());
    EXPECT_NE(result.message().find("has written no file '/none/lego.obj'"), std::string::npos) << result.message();
    EXPECT_TRUE(_writer->writeNode(*createSphere(4), "/none/sphere.obj", nullptr).success())
        << "a scene without bricks is not checked";
}

} // namespace

} // namespace osgLego::test
