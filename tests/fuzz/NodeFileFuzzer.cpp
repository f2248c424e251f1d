#include "Harness.h"

#include <osgLego/BrickCodec.h>
#include <osgLego/LegoNode.h>

#include <sstream>

#include <osgDB/Options>
#include <osgDB/Registry>

// Files of OSG's own formats with a LegoNode: the properties that this project reads, in a frame that OSG has written,
// since OSG's own readers trust most of a file.

namespace
{

using osgLego::fuzz::require;

/** The bytes of a file around those that an input replaces. */
struct Frame
{
    std::string before;
    std::string after;
};

osg::ref_ptr<osgDB::ReaderWriter> getPlugin(const char* extension)
{
    osgDB::ReaderWriter* plugin = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
    require(plugin, std::string("OSG has a plugin for .") + extension);
    return plugin;
}

osg::ref_ptr<osgDB::Options> createOptions(const char* extension)
{
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    if (std::string_view(extension) == "osgt") options->setPluginStringData("fileType", "Ascii");
    return options;
}

osg::ref_ptr<const osgLego::BrickModel> createBricks()
{
    osgLego::BrickGrid grid;
    grid.dimensions = {3, 2, 1};
    return osgLego::BrickModel::create(grid, {{{0, 0, 0}, {255, 0, 0}}, {{2, 1, 0}, {1, 2, 3}}});
}

std::string write(const osgLego::LegoNode& node, const char* extension)
{
    std::ostringstream stream;
    const auto result = getPlugin(extension)->writeObject(node, stream, createOptions(extension));
    require(result.success(), "a node can be written: " + result.message());
    return stream.str();
}

std::string writeExample(const char* extension)
{
    const osg::ref_ptr<osgLego::LegoNode> node = new osgLego::LegoNode;
    node->setStoredBricks(createBricks());
    return write(*node, extension);
}

/** All properties from the settings on. */
Frame createTextFrame()
{
    const std::string file = writeExample("osgt");
    const auto place = file.find("Settings ");
    require(place != std::string::npos, "the file has settings");
    return {file.substr(0, place), file.substr(file.rfind('}'))};
}

/** The stored bricks, which are last, with the number and the size of their parts before them. */
Frame createBinaryFrame()
{
    const std::string bytes = osgLego::encodeBricks(*createBricks());
    const std::string file = writeExample("osgb");
    const auto place = file.find(bytes);
    constexpr std::size_t NUMBERS = 8;
    require(place != std::string::npos && place > NUMBERS, "the file has stored bricks");
    return {file.substr(0, place - NUMBERS), file.substr(place + bytes.size())};
}

osg::ref_ptr<osg::Object> read(const std::string& file, const char* extension)
{
    std::istringstream stream(file);
    return getPlugin(extension)->readObject(stream, createOptions(extension)).takeObject();
}

/** Whether a text may have an image, a name or children, on which OSG 3.6.5 throws exceptions or does not return if
 * they are damaged. */
bool hasOtherProperties(const std::string& text)
{
    constexpr std::size_t IMAGE = 7; // the property Appearance has six numbers, and whether there is an image
    std::istringstream stream(text);
    std::size_t place = 0; // after the word Appearance; 0 before it
    for (std::string word; stream >> word;)
    {
        if (place > 0 && ++place > IMAGE && word != "FALSE") return true;
        if (place > IMAGE) place = 0;
        if (word == "Appearance") place = 1;
        for (const char* other : {"Picture", "Name", "UserDataContainer", "Children", "StateSet", "Callback"})
            if (word.find(other) != std::string::npos) return true;
    }
    return false;
}

void checkNode(const osg::Object* object, const char* extension)
{
    const auto* node = dynamic_cast<const osgLego::LegoNode*>(object);
    if (!node) return;
    require(node->getSettings().check().empty(), "the settings of a node are valid");
    const osg::ref_ptr<const osgLego::BrickModel> bricks = node->getStoredBricks();
    if (bricks) osgLego::fuzz::requirePossible(*bricks);
    const std::string file = write(*node, extension);
    const osg::ref_ptr<osg::Object> again = read(file, extension);
    require(again.valid(), "a written node can be read");
    require(write(dynamic_cast<const osgLego::LegoNode&>(*again), extension) == file,
            "a node is the same after writing and reading");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    const bool isText = *data % 2 == 0;
    const std::string input(osgLego::fuzz::toText(data + 1, size - 1));
    if (isText && hasOtherProperties(input)) return 0;
    static const Frame text = createTextFrame();
    static const Frame binary = createBinaryFrame();
    const char* extension = isText ? "osgt" : "osgb";
    const Frame& frame = isText ? text : binary;
    checkNode(read(frame.before + input + frame.after, extension), extension);
    return 0;
}
