#pragma once

#include <string>

#include <osg/ref_ptr>
#include <osgDB/Callbacks>
#include <osgDB/Options>
#include <osgDB/ReaderWriter>

namespace osgLego
{

/** Has osgDB write the bricks of LegoNodes, as geometry, into files of formats that can't store the node.
 *
 * A callback of osgDB's registry, which is where every file is written through whose format OSG chooses by its name
 * (osgDB::writeNodeFile, osgconv), and the one place where the format is known before a writer walks over the scene.
 * Hands everything on to the callback that was there before, or to the registry.
 */
class BrickFileWriter : public osgDB::WriteFileCallback
{
public:
    using WriteResult = osgDB::ReaderWriter::WriteResult;
    using Options = osgDB::Options;

    /** Install one, the first time that this is called. May be called from any thread. */
    static void install();

    /** @param next what everything is handed on to; null: the registry. */
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

    /** Write a node, its bricks replaced if they must be, by `write(node)`. */
    template <typename Write>
    static WriteResult writeBricks(const osg::Node& node, const std::string& fileName, const Write& write);

    osg::ref_ptr<osgDB::WriteFileCallback> _next;
};

} // namespace osgLego
