#include "Harness.h"

#include <ldraw/LDrawReader.h>
#include <ldraw/LDrawScene.h>
#include <ldraw/LDrawWriter.h>

#include <sstream>

// Files of LDraw: .ldr and .mpd.

namespace
{

using osgLego::fuzz::require;

osg::ref_ptr<osg::Node> read(const std::string& text)
{
    // A folder that does not exist, so that the names of parts find no files.
    osgLego::LDrawLibrary library("/nonexistent", "");
    osgLego::LDrawReader reader("model.mpd", library);
    std::string error;
    osg::ref_ptr<osg::Node> node = reader.read(text, error);
    require(node.valid() == error.empty(), "there is a model, or there is a reason: " + error);
    return node;
}

/** Write the bricks of a scene. @return an empty text if it has none, only surfaces. */
std::string write(const osg::Node& node, const std::string& fileName)
{
    osgLego::LDrawScene scene;
    std::string error;
    if (!osgLego::LDrawScene::create(node, scene, error))
    {
        require(!error.empty(), "a scene that can't be written has a reason");
        return {};
    }
    const osgLego::LDrawWriter writer(scene, fileName);
    std::ostringstream stream;
    writer.write(stream);
    require(writer.check(stream.str()).empty(), "a written file has the parts of the model");
    return stream.str();
}

void checkWriting(const osg::Node& node, const std::string& fileName)
{
    const std::string text = write(node, fileName);
    if (text.empty()) return;
    const osg::ref_ptr<osg::Node> again = read(text);
    require(again.valid(), "a written file can be read");
    require(write(*again, fileName) == text, "a file that was read and written stays the same");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const osg::ref_ptr<osg::Node> node = read(std::string(osgLego::fuzz::toText(data, size)));
    if (!node) return 0;
    checkWriting(*node, "model.mpd");
    checkWriting(*node, "model.ldr");
    return 0;
}
