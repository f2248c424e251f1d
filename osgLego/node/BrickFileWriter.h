#pragma once

#include <string>

#include <osg/ref_ptr>
#include <osgDB/Callbacks>
#include <osgDB/Options>
#include <osgDB/ReaderWriter>

namespace osgLego
{

/** Makes osgDB write the bricks of LegoNodes as geometry to files whose format can't store the node, and instead of
 * the source to files whose format can, if the option "bake" is given. Writers of LDraw's files and of .glb get the
 * nodes.
 *
 * It is a callback of osgDB's registry. The registry writes every file whose format OSG chooses by its name
 * (osgDB::writeNodeFile, osgconv), and only there is the format known before a writer traverses the scene. All calls
 * are forwarded to the previous callback, or to the registry.
 */
class BrickFileWriter : public osgDB::WriteFileCallback
{
public:
    using WriteResult = osgDB::ReaderWriter::WriteResult;
    using Options = osgDB::Options;

    /** Install a writer in the registry; only the first call has an effect. May be called from any thread. */
    static void install();

    /** @param next the callback to which calls are forwarded; null: the registry. */
    explicit BrickFileWriter(osgDB::WriteFileCallback* next);

    WriteResult writeObject(const osg::Object& object, const std::string& fileName, const Options* options) override;
    WriteResult writeImage(const osg::Image& image, const std::string& fileName, const Options* options) override;
    WriteResult writeHeightField(const osg::HeightField& field, const std::string& fileName,
                                 const Options* options) override;
    WriteResult writeNode(const osg::Node& node, const std::string& fileName, const Options* options) override;
    WriteResult writeShader(const osg::Shader& shader, const std::string& fileName, const Options* options) override;
    WriteResult writeScript(const osg::Script& script, const std::string& fileName, const Options* options) override;

private:
    ~BrickFileWriter() override = default;

    /** Write a node by `write(node, options)`, after replacing its bricks by geometry if the format requires it, or its
     * sources by their bricks if the options request it. @return an error also if memory runs out. */
    template <typename Write>
    static WriteResult writeBricks(const osg::Node& node, const std::string& fileName, const Options* options,
                                   const Write& write);

    /** Write a node by `write(node, options)`, after replacing its sources by their bricks; warn if it has none. */
    template <typename Write>
    static WriteResult writeBaked(const osg::Node& node, const std::string& fileName, const Options& options,
                                  const Write& write);

    osg::ref_ptr<osgDB::WriteFileCallback> _next;
};

} // namespace osgLego
