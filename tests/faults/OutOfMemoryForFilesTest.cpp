#include "Shortages.h"
#include "SmallModel.h"

#include <osgLego/LegoNode.h>

#include <PartModels.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include <osg/NodeVisitor>
#include <osgDB/Registry>

namespace osgLego::test
{

namespace
{

/** Finds the stored bricks of a scene. */
class BrickCollector : public osg::NodeVisitor
{
public:
    BrickCollector() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Group& group) override
    {
        if (const auto* lego = dynamic_cast<const LegoNode*>(&group))
            bricks = lego->getStoredBricks();
        else
            traverse(group);
    }

    osg::ref_ptr<const BrickModel> bricks;
};

/** Writes nodes to a text, and reads them. */
class FileFormat
{
public:
    using ReadResult = osgDB::ReaderWriter::ReadResult;
    using WriteResult = osgDB::ReaderWriter::WriteResult;

    explicit FileFormat(const std::string& extension) :
        _format(osgDB::Registry::instance()->getReaderWriterForExtension(extension)), _options(new osgDB::Options)
    {
        _options->setPluginStringData("STREAM_FILENAME", "model." + extension);
    }

    /** Forget the last text and node. @param text the next one to read. */
    void prepare(const std::string& text = {})
    {
        _output = std::ostringstream();
        _input = std::istringstream(text);
        _written = WriteResult();
        _read = ReadResult();
    }

    void write(const osg::Node& node) { _written = _format->writeNode(node, _output, _options); }
    void read() { _read = _format->readNode(_input, _options); }

    /** The text that was written, if that has succeeded. */
    std::string getText() const { return _written.success() && _output ? _output.str() : std::string(); }
    /** The bytes of the bricks that were read, if there are any. */
    std::string getBricks()
    {
        BrickCollector collector;
        if (_read.getNode()) _read.getNode()->accept(collector);
        return encode(collector.bricks);
    }

    std::string getMessage() { return _written.message() + _read.message(); }

private:
    osg::ref_ptr<osgDB::ReaderWriter> _format;
    osg::ref_ptr<osgDB::Options> _options;
    std::ostringstream _output;
    std::istringstream _input;
    WriteResult _written;
    ReadResult _read;
};

class OutOfMemoryForFiles : public ::testing::TestWithParam<Scarcity>
{
protected:
    static void surviveWriting(const std::string& extension, bool mayThrow)
    {
        const osg::ref_ptr<LegoNode> lego = createStoredNode(*createSmallModel(), "8,proportions=plate");
        FileFormat format(extension);
        surviveShortages({.mayThrow = mayThrow,
                          .prepare = [&] { format.prepare(); },
                          .work = [&] { format.write(*lego); },
                          .getResult = [&] { return format.getText(); },
                          .getMessage = [&] { return format.getMessage(); }},
                         GetParam());
    }

    /** The same, to a file, which is complete or not there. */
    static void surviveWritingAFile(const std::string& extension)
    {
        const osg::ref_ptr<LegoNode> lego = createStoredNode(*createSmallModel(), "8,proportions=plate");
        const std::string name = "osglego-" + std::to_string(getpid()) + '.' + extension;
        const std::string file = std::filesystem::temp_directory_path() / name;
        osgDB::ReaderWriter& format = *osgDB::Registry::instance()->getReaderWriterForExtension(extension);
        osgDB::ReaderWriter::WriteResult written;
        surviveShortages({.mayThrow = false,
                          .prepare =
                              [&]
                          {
                              std::filesystem::remove(file);
                              written = {};
                          },
                          .work = [&] { written = format.writeNode(*lego, file, nullptr); },
                          .getResult =
                              [&]
                          {
                              std::ostringstream content;
                              content << std::ifstream(file).rdbuf();
                              return content.str();
                          },
                          .getMessage = [&] { return written.message(); }},
                         GetParam());
        std::filesystem::remove(file);
    }

    static void surviveReading(const std::string& extension, bool mayThrow)
    {
        FileFormat format(extension);
        format.write(*createStoredNode(*createSmallModel(), "8,proportions=plate"));
        const std::string text = format.getText();
        surviveShortages({.mayThrow = mayThrow,
                          .prepare = [&] { format.prepare(text); },
                          .work = [&] { format.read(); },
                          .getResult = [&] { return format.getBricks(); },
                          .getMessage = [&] { return format.getMessage(); }},
                         GetParam());
    }
};

INSTANTIATE_TEST_SUITE_P(Scarcities, OutOfMemoryForFiles,
                         ::testing::Values(Scarcity(MemoryFaults::Extent::ONE, 1),
                                           Scarcity(MemoryFaults::Extent::ALL_AFTER, 1)),
                         nameOf);

TEST_P(OutOfMemoryForFiles, IsAMessageOfTheWriterOfLDraw)
{
    surviveWriting("ldr", false);
}

TEST_P(OutOfMemoryForFiles, IsAMessageOfTheReaderOfLDraw)
{
    surviveReading("ldr", false);
}

TEST_P(OutOfMemoryForFiles, IsAMessageOfTheWriterOfGltf)
{
    surviveWriting("glb", false);
}

TEST_P(OutOfMemoryForFiles, LeavesNoIncompleteFileOfTheWriterOfGltf)
{
    surviveWritingAFile("glb");
}

// OSG itself throws there.
TEST_P(OutOfMemoryForFiles, ThrowsWhileStoredBricksAreWritten)
{
    surviveWriting("osgb", true);
}

TEST_P(OutOfMemoryForFiles, ThrowsWhileStoredBricksAreRead)
{
    surviveReading("osgb", true);
}

} // namespace

} // namespace osgLego::test
