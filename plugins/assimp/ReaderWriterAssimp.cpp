#include "AssimpFormats.h"
#include "AssimpReader.h"

#include <common/CompleteFile.h>
#include <common/ReadableFile.h>
#include <gltf/GltfWriter.h>

#include <exception>
#include <functional>
#include <new>
#include <sstream>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReaderWriter>
#include <osgDB/Registry>

/** Reads models through Assimp, in formats for which OpenSceneGraph 3.6 has no plugin: .glb, .gltf, .fbx, .off and
 * those of AssimpFormats.cpp; and writes bricks to .glb.
 *
 *     osgviewer duck.glb.64.legolize
 *     osgconv -O noRotation engine.gltf engine.obj
 *     osgconv sample.64.legolize bricks.glb
 *
 * Models with Y upwards, as those of glTF, are turned upright, as OpenSceneGraph's reader of .obj files turns its
 * models, unless the option `noRotation` is given. */
class ReaderWriterAssimp : public osgDB::ReaderWriter
{
public:
    ReaderWriterAssimp()
    {
        for (const AssimpFormat& format : getAssimpFormats())
            supportsExtension(std::string(format.extension), std::string(format.name) + " through Assimp");
        supportsOption("noRotation", "Keep the Y axis of the model, instead of turning the model upright");
    }

    const char* className() const override { return "Assimp reader and glTF writer"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readNode(name, options);
    }

    ReadResult readNode(const std::string& name, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string path = osgDB::findDataFile(name, options);
        if (path.empty()) return ReadResult::FILE_NOT_FOUND;
        const osg::ref_ptr<Options> used = copyOptions(options);
        used->getDatabasePathList().push_front(osgDB::getFilePath(path));
        return createNode(name, *used,
                          [&path](AssimpReader& reader, std::string& error)
                          {
                              error = osgLego::findObstacleToReading(path);
                              return error.empty() ? reader.readFile(path, error) : nullptr;
                          });
    }

    // Streams are the content of archives and of files from servers.
    ReadResult readObject(std::istream& stream, const Options* options) const override
    {
        return readNode(stream, options);
    }

    ReadResult readNode(std::istream& stream, const Options* options) const override
    {
        const std::string name = options ? options->getPluginStringData("STREAM_FILENAME") : std::string();
        return createNode(name.empty() ? "a stream" : name, *copyOptions(options),
                          [&](AssimpReader& reader, std::string& error)
                          {
                              std::ostringstream content;
                              content << stream.rdbuf();
                              return reader.readContent(content.str(), osgDB::getLowerCaseFileExtension(name), error);
                          });
    }

    WriteResult writeObject(const osg::Object& object, const std::string& fileName,
                            const Options* options) const override
    {
        const auto* node = dynamic_cast<const osg::Node*>(&object);
        return node ? writeNode(*node, fileName, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeNode(const osg::Node& node, const std::string& fileName, const Options*) const override
    {
        if (osgDB::getLowerCaseFileExtension(fileName) != "glb") return WriteResult::FILE_NOT_HANDLED;
        return writeBricks(node, fileName,
                           [&fileName](const osgLego::GltfWriter& writer) {
                               return osgLego::writeCompleteFile(fileName, [&writer](std::ostream& stream)
                                                                 { return writer.write(stream); });
                           });
    }

    WriteResult writeObject(const osg::Object& object, std::ostream& stream, const Options* options) const override
    {
        const auto* node = dynamic_cast<const osg::Node*>(&object);
        return node ? writeNode(*node, stream, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeNode(const osg::Node& node, std::ostream& stream, const Options*) const override
    {
        return writeBricks(node, "a stream",
                           [&stream](const osgLego::GltfWriter& writer) { return writer.write(stream); });
    }

private:
    using Write = std::function<std::string(const osgLego::GltfWriter& writer)>;
    using Read = std::function<osg::ref_ptr<osg::Node>(AssimpReader& reader, std::string& error)>;

    static osg::ref_ptr<Options> copyOptions(const Options* options)
    {
        return options ? options->cloneOptions() : new Options;
    }

    /** The reason why some work fails. OSG expects no exceptions of its plugins. */
    template <typename Work> // no std::function, which takes memory before any exception is caught
    static std::string findError(const Work& work)
    {
        std::string error;
        try
        {
            work(error);
        }
        catch (const std::bad_alloc&)
        {
            error = "there is not enough memory for it";
        }
        catch (const std::exception& exception)
        {
            error = exception.what();
        }
        return error;
    }

    static ReadResult createNode(const std::string& name, const Options& options, const Read& read)
    {
        osg::ref_ptr<osg::Node> node;
        const std::string error = findError(
            [&](std::string& why)
            {
                AssimpReader reader(name, options);
                node = read(reader, why);
            });
        return node ? ReadResult(node.get()) : ReadResult("osgLego: can't read '" + name + "': " + error);
    }

    static WriteResult writeBricks(const osg::Node& node, const std::string& name, const Write& write)
    {
        osgLego::GltfWriter writer;
        const std::string error = findError(
            [&](std::string& why)
            {
                if (writer.add(node, why)) why = write(writer);
            });
        if (!error.empty()) return WriteResult("osgLego: can't write '" + name + "': " + error);
        for (const std::string& warning : writer.getWarnings())
            OSG_WARN << "osgLego: '" << name << "': " << warning << std::endl;
        return WriteResult::FILE_SAVED;
    }
};

REGISTER_OSGPLUGIN(assimp, ReaderWriterAssimp)
