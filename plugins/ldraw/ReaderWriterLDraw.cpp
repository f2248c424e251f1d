#include "LDrawReader.h"
#include "LDrawWriter.h"

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

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
 * The environment variable LDRAWDIR may name the folder of LDraw's part library, from which other parts are read. */
class ReaderWriterLDraw : public osgDB::ReaderWriter
{
public:
    ReaderWriterLDraw()
    {
        supportsExtension("ldr", "A model of LDraw");
        supportsExtension("mpd", "A model of LDraw with submodels");
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
        std::string error;
        const std::optional<std::string> text = readText(path, error);
        const char* libraryFolder = std::getenv("LDRAWDIR");
        LDrawLibrary library(osgDB::getFilePath(path), libraryFolder ? libraryFolder : "");
        LDrawReader reader(name, library);
        osg::ref_ptr<osg::Node> node;
        if (text) node = reader.read(*text, error);
        if (!node) return ReadResult("osgLego: can't read '" + name + "': " + error);
        warn(name, reader.getWarnings());
        return node.get();
    }

    WriteResult writeObject(const osg::Object& object, const std::string& fileName,
                            const Options* options) const override
    {
        const auto* node = dynamic_cast<const osg::Node*>(&object);
        return node ? writeNode(*node, fileName, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeNode(const osg::Node& node, const std::string& fileName, const Options*) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(fileName))) return WriteResult::FILE_NOT_HANDLED;
        LDrawScene scene;
        std::string why;
        if (LDrawScene::create(node, scene, why))
        {
            const LDrawWriter writer(scene, fileName);
            why = writeCompleteFile(fileName,
                                    [&writer](const std::string& temporary) { return writeFile(writer, temporary); });
        }
        if (!why.empty()) return WriteResult("osgLego: can't write '" + fileName + "': " + why);
        warn(fileName, scene.warnings);
        return WriteResult::FILE_SAVED;
    }

private:
    static void warn(const std::string& name, const std::vector<std::string>& warnings)
    {
        for (const std::string& warning : warnings)
            OSG_WARN << "osgLego: '" << name << "': " << warning << std::endl;
    }

    /** Write a file, and read it back to compare it with the scene. @return the reason if this fails, or nothing. */
    static std::string writeFile(const LDrawWriter& writer, const std::string& name)
    {
        std::ofstream file(name, std::ios::binary);
        if (file) writer.write(file);
        file.close();
        if (!file) return std::strerror(errno);
        std::string error;
        // Devices and pipes give nothing back.
        if (osgDB::fileType(name) != osgDB::REGULAR_FILE) return {};
        const std::optional<std::string> text = readText(name, error);
        return text ? writer.check(*text) : error;
    }
};

} // namespace osgLego

using osgLego::ReaderWriterLDraw;
REGISTER_OSGPLUGIN(ldraw, ReaderWriterLDraw)
