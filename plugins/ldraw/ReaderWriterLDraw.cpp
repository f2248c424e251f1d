#include "LDrawReader.h"
#include "LDrawText.h"
#include "LDrawWriter.h"

#include <common/CompleteFile.h>

#include <cstdlib>
#include <functional>
#include <new>
#include <sstream>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReaderWriter>
#include <osgDB/Registry>

namespace osgLego
{

/** Reads and writes the models of bricks and plates in LDraw's files .ldr and .mpd.
 *
 *     osgconv "bunny.ply.(48,proportions=brick,parts=bricks).legolize" bunny.ldr
 *     osgviewer bunny.ldr
 *
 * Streams are written as .ldr, unless the option's plugin data STREAM_FILENAME gives them another name, with its
 * extension. LDrawWriteOptions::read() describes options for written files.
 *
 * The environment variable LDRAWDIR may name the folder of LDraw's part library, from which other parts are read. */
class ReaderWriterLDraw : public osgDB::ReaderWriter
{
public:
    ReaderWriterLDraw()
    {
        supportsExtension("ldr", "A model of LDraw");
        supportsExtension("mpd", "A model of LDraw with submodels");
        supportsOption("title=\"TEXT\"",
                       "The title of written files (that of the file that was read, or the model's name)");
        supportsOption("author=\"TEXT\"", "The author of written files (that of the file that was read, or osgLego)");
        supportsOption("license=\"TEXT\"",
                       "The text after !LICENSE in written files (that of the file that was read, or no such line)");
        supportsOption("base=plate", "Have models in written files stand on a base plate");
    }

    const char* className() const override { return "LDraw reader and writer"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readNode(name, options);
    }

    ReadResult readNode(const std::string& name, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string path = osgDB::findDataFile(name, options);
        if (path.empty()) return ReadResult::FILE_NOT_FOUND;
        return createNode(name, osgDB::getFilePath(path),
                          [&path](std::string& error) { return readText(path, error); });
    }

    // Streams are the content of compressed files, among others.
    ReadResult readObject(std::istream& stream, const Options* options) const override
    {
        return readNode(stream, options);
    }

    ReadResult readNode(std::istream& stream, const Options*) const override
    {
        return createNode(STREAM_NAME, {}, [&stream](std::string& error) { return readText(stream, error); });
    }

    WriteResult writeObject(const osg::Object& object, const std::string& fileName,
                            const Options* options) const override
    {
        const auto* node = dynamic_cast<const osg::Node*>(&object);
        return node ? writeNode(*node, fileName, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeObject(const osg::Object& object, std::ostream& stream, const Options* options) const override
    {
        const auto* node = dynamic_cast<const osg::Node*>(&object);
        return node ? writeNode(*node, stream, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeNode(const osg::Node& node, const std::string& fileName, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(fileName))) return WriteResult::FILE_NOT_HANDLED;
        // Before the order of building is planned, which may take long.
        if (const std::string obstacle = findObstacleToWriting(fileName); !obstacle.empty())
            return WriteResult("osgLego: can't write '" + fileName + "': " + obstacle);
        return writeScene(node, fileName, options,
                          [&fileName](const LDrawWriter& writer) {
                              return writeCompleteFile(fileName, [&writer](std::ostream& stream)
                                                       { return writeChecked(writer, stream); });
                          });
    }

    WriteResult writeNode(const osg::Node& node, std::ostream& stream, const Options* options) const override
    {
        return writeScene(node, nameStream(options), options,
                          [&stream](const LDrawWriter& writer)
                          {
                              std::string why = writeChecked(writer, stream);
                              if (why.empty() && !stream) why = "the stream can't be written to";
                              return why;
                          });
    }

private:
    static constexpr const char* STREAM_NAME = "model.ldr";

    /** The name that a file has in its text. OSG's archives give streams names in this way, too. */
    static std::string nameStream(const Options* options)
    {
        const std::string name = options ? options->getPluginStringData("STREAM_FILENAME") : std::string();
        return name.empty() ? STREAM_NAME : name;
    }

    /** Call a function that returns the reason if it fails. @return that reason, also if memory runs out. */
    template <typename Function>
    static std::string catchShortage(const Function& function)
    try
    {
        return function();
    }
    catch (const std::bad_alloc&)
    {
        return "there is not enough memory for it";
    }

    /** Create a node of the text that a function reads. */
    static ReadResult createNode(const std::string& name, const std::string& folder,
                                 const std::function<std::optional<std::string>(std::string& error)>& readContent)
    {
        osg::ref_ptr<osg::Node> node;
        const auto create = [&]
        {
            std::string error;
            const std::optional<std::string> text = readContent(error);
            if (!text) return error;
            const char* libraryFolder = std::getenv("LDRAWDIR");
            LDrawLibrary library(folder, libraryFolder ? libraryFolder : "");
            LDrawReader reader(name, library);
            node = reader.read(*text, error);
            if (node) warn(name, reader.getWarnings());
            return error;
        };
        const std::string why = catchShortage(create);
        return node ? ReadResult(node.get()) : ReadResult("osgLego: can't read '" + name + "': " + why);
    }

    /** Write a node by a function that returns the reason if it fails. */
    static WriteResult writeScene(const osg::Node& node, const std::string& name, const Options* options,
                                  const std::function<std::string(const LDrawWriter&)>& write)
    {
        LDrawScene scene;
        const std::string why = catchShortage(
            [&]
            {
                std::string error;
                const std::optional<LDrawWriteOptions> read = LDrawWriteOptions::read(options, error);
                return read && LDrawScene::create(node, scene, error) ? write(LDrawWriter(scene, name, *read)) : error;
            });
        if (!why.empty()) return WriteResult("osgLego: can't write '" + name + "': " + why);
        warn(name, scene.warnings);
        return WriteResult::FILE_SAVED;
    }

    static void warn(const std::string& name, const std::vector<std::string>& warnings)
    {
        for (const std::string& warning : warnings)
            OSG_WARN << "osgLego: '" << name << "': " << warning << std::endl;
    }

    /** Write a text that has been compared with the scene. @return the reason if it differs, or nothing. */
    static std::string writeChecked(const LDrawWriter& writer, std::ostream& stream)
    {
        std::ostringstream text;
        text.exceptions(std::ios::badbit); // else a lack of memory would only shorten the text
        writer.write(text);
        std::string why = writer.check(text.str());
        if (why.empty()) stream << text.str();
        return why;
    }
};

} // namespace osgLego

using osgLego::ReaderWriterLDraw;
REGISTER_OSGPLUGIN(ldraw, ReaderWriterLDraw)
