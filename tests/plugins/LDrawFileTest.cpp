#include <osgLego/LegoNode.h>

#include <Notices.h>
#include <PartModels.h>
#include <TemporaryFolder.h>

#include <algorithm>
#include <fstream>
#include <new>
#include <streambuf>

#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>
#include <sys/stat.h>

namespace osgLego::test
{

namespace
{

/** Reads and writes files through osgDB. */
class LDrawFile : public TemporaryFolderTest
{
protected:
    static osg::ref_ptr<LegoNode> createModel()
    {
        PartFilling filling;
        filling.heights = {1, 3};
        const osg::ref_ptr<const BrickModel> model = createParts(createPartGrid({9, 8, 7}, 0.4), filling);
        return createStoredNode(*model, "parts=bricks,proportions=plate");
    }

    static osg::ref_ptr<const BrickModel> bricksOf(const osg::ref_ptr<osg::Node>& node)
    {
        const auto* lego = node ? dynamic_cast<const LegoNode*>(node->asGroup()->getChild(0)) : nullptr;
        return lego ? lego->getStoredBricks() : nullptr;
    }
};

TEST_F(LDrawFile, PartsSurviveInFilesOfEveryName)
{
    const osg::ref_ptr<LegoNode> lego = createModel();
    for (const char* name : {"a.ldr", "b.mpd", "C D.LDR", "e.ldr.gz"})
    {
        ASSERT_TRUE(osgDB::writeNodeFile(*lego, pathOf(name))) << name;
        const osg::ref_ptr<const BrickModel> back = bricksOf(osgDB::readRefNodeFile(pathOf(name)));
        ASSERT_TRUE(back) << name;
        const std::vector<Part>& parts = lego->getBricks()->getParts();
        ASSERT_EQ(back->getParts().size(), parts.size());
        for (std::size_t index = 0; index < parts.size(); ++index)
        {
            EXPECT_EQ(back->getParts()[index].cell, parts[index].cell);
            EXPECT_EQ(back->getParts()[index].size, parts[index].size);
            EXPECT_EQ(back->getParts()[index].colorCode, parts[index].colorCode);
        }
    }
    EXPECT_EQ(countFiles(), 4u) << "no temporary file is left";
}

TEST_F(LDrawFile, FilesOfBasePlatesInTheCurrentFolderAreNotThoseOfTheModel)
{
    const std::filesystem::path former = std::filesystem::current_path();
    std::filesystem::current_path(_folder);
    std::ofstream("3865.dat") << "0 Base plate\n";
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("base=plate");
    EXPECT_TRUE(osgDB::writeNodeFile(*createModel(), pathOf("a.ldr"), options));
    std::filesystem::current_path(former);
    EXPECT_NE(contentsOf(pathOf("a.ldr")).find(" 3865.dat"), std::string::npos);
}

TEST_F(LDrawFile, AModelThatCannotBeWrittenLeavesTheOldFile)
{
    ASSERT_TRUE(osgDB::writeNodeFile(*createModel(), pathOf("a.ldr")));
    const std::string before = contentsOf(pathOf("a.ldr"));
    const auto cubes = BrickModel::create(createPartGrid({1, 1, 1}), {{{0, 0, 0}, {1, 2, 3}}});
    bool isWritten = true;
    const std::string said =
        noticesOf([&] { isWritten = osgDB::writeNodeFile(*createStoredNode(*cubes, "8"), pathOf("a.ldr")); });
    EXPECT_FALSE(isWritten);
    EXPECT_NE(said.find("expected proportions=brick or plate"), std::string::npos) << said;
    EXPECT_EQ(contentsOf(pathOf("a.ldr")), before);
    EXPECT_EQ(countFiles(), 1u);
}

TEST_F(LDrawFile, AFolderThatDoesNotExistIsAnError)
{
    const std::string said = noticesOf([&] { osgDB::writeNodeFile(*createModel(), pathOf("none/a.ldr")); });
    EXPECT_NE(said.find("there is no folder"), std::string::npos) << said;
}

TEST_F(LDrawFile, FilesThatAreNotLDrawGiveOneMessageAndNoNode)
{
    std::ofstream(pathOf("solid.ldr")) << "solid cube\nfacet normal 0 0 1\n";
    osg::ref_ptr<osg::Node> node;
    const std::string said = noticesOf([&] { node = osgDB::readRefNodeFile(pathOf("solid.ldr")); });
    EXPECT_FALSE(node);
    EXPECT_NE(said.find("solid.ldr': line 1: it begins with 'solid'"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST_F(LDrawFile, WarningsNameTheFile)
{
    std::ofstream(pathOf("odd.ldr")) << "1 4 0 0 0 1 0 0 0 1 0 0 0 1 3005.dat\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 wheel.dat\n";
    osg::ref_ptr<osg::Node> node;
    const std::string said = noticesOf([&] { node = osgDB::readRefNodeFile(pathOf("odd.ldr")); });
    EXPECT_TRUE(bricksOf(node));
    EXPECT_NE(said.find("odd.ldr': these parts are not known and are left out: wheel.dat"), std::string::npos) << said;
}

TEST_F(LDrawFile, APipeIsRefusedRatherThanWaitedFor)
{
    ASSERT_EQ(mkfifo(pathOf("a.ldr").c_str(), 0600), 0);
    osg::ref_ptr<osg::Node> node;
    const std::string said = noticesOf([&] { node = osgDB::readRefNodeFile(pathOf("a.ldr")); });
    EXPECT_FALSE(node);
    EXPECT_NE(said.find("a.ldr': it is a device or a pipe; expected a regular file"), std::string::npos) << said;
}

/** A buffer of a stream that can't allocate memory. */
class BufferWithoutMemory : public std::streambuf
{
private:
    int_type underflow() override { throw std::bad_alloc(); }
    int_type overflow(int_type) override { throw std::bad_alloc(); }
};

TEST_F(LDrawFile, AShortageOfMemoryIsAnErrorAndNoException)
{
    osgDB::ReaderWriter* plugin = osgDB::Registry::instance()->getReaderWriterForExtension("ldr");
    ASSERT_TRUE(plugin);
    BufferWithoutMemory buffer;
    std::iostream stream(&buffer);
    stream.exceptions(std::ios::badbit); // rethrow the buffer's exceptions
    const osgDB::ReaderWriter::ReadResult read = plugin->readNode(stream, nullptr);
    EXPECT_FALSE(read.success());
    EXPECT_NE(read.message().find("there is not enough memory for it"), std::string::npos) << read.message();
    stream.clear();
    const osgDB::ReaderWriter::WriteResult written = plugin->writeNode(*createModel(), stream, nullptr);
    EXPECT_FALSE(written.success());
    EXPECT_NE(written.message().find("there is not enough memory for it"), std::string::npos) << written.message();
}

} // namespace

} // namespace osgLego::test
