#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <TemporaryFolder.h>

#include <fstream>

#include <osg/MatrixTransform>
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

    /** The bricks that a reader's answer holds. */
    static osg::ref_ptr<LegoNode> findLego(osg::Object* object)
    {
        const auto* scene = dynamic_cast<AmbientOcclusionScene*>(object);
        if (scene && scene->getNumChildren() != 1) return nullptr;
        return dynamic_cast<LegoNode*>(scene ? const_cast<osg::Node*>(scene->getChild(0)) : object);
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

TEST_F(PseudoLoader, PutsBricksOfTheFullLookUnderAmbientOcclusion)
{
    EXPECT_TRUE(dynamic_cast<AmbientOcclusionScene*>(read(pathOf("ball.osgt.16.legolize")).getNode()));
    EXPECT_TRUE(dynamic_cast<LegoNode*>(read(pathOf("ball.osgt.(16,look=plain).legolize")).getNode()));
}

TEST_F(PseudoLoader, TakesSettingsFromOptionsAndThoseInTheNameCountForMore)
{
    const std::string options = "24,proportions=brick somethingForAnotherReader";
    EXPECT_EQ(readLego(pathOf("ball.osgt.legolize"), options)->getSettings().toString(), "24,proportions=brick");
    EXPECT_EQ(readLego(pathOf("ball.osgt.48.legolize"), options)->getSettings().toString(), "48,proportions=brick");
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
    std::ofstream(pathOf("strange.xyzzy")) << "?";
    EXPECT_NE(errorOf(pathOf("strange.xyzzy.64.legolize")).find("there is no reader for"), std::string::npos);
    ASSERT_TRUE(osgDB::writeNodeFile(*osg::ref_ptr<osg::Group>(new osg::Group), pathOf("empty.osgt")));
    EXPECT_NE(errorOf(pathOf("empty.osgt.64.legolize")).find("no triangles"), std::string::npos);
}

TEST_F(PseudoLoader, OtherFormatsGetTheBricksAsTriangles)
{
    const osg::ref_ptr<LegoNode> lego = readLego(pathOf("ball.osgt.8.legolize"));
    ASSERT_TRUE(lego);
    for (const char* name : {"bricks.obj", "bricks.stl"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf(name)));
        const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("noRotation");
        const osg::ref_ptr<osg::Node> back = osgDB::readRefNodeFile(pathOf(name), options);
        ASSERT_TRUE(back) << name;
        EXPECT_NEAR(back->getBound().radius(), lego->getBound().radius(), 0.15 * lego->getBound().radius()) << name;
    }
}

} // namespace

} // namespace osgLego::test
