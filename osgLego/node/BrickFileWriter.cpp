#include <osgLego/node/BrickFileWriter.h>

#include <osgLego/BrickScene.h>
#include <osgLego/LegoNode.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <new>
#include <sstream>
#include <string_view>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ObjectWrapper>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

template <std::size_t COUNT>
bool isOneOf(const std::array<std::string_view, COUNT>& list, std::string_view extension)
{
    return std::find(list.begin(), list.end(), extension) != list.end();
}

/** The extension of the format, in lower case; for a compressed file, `bricks.osgt.gz`, without the extension .gz. */
std::string formatOf(std::string fileName)
{
    if (osgDB::getLowerCaseFileExtension(fileName) == "gz") fileName = osgDB::getNameLessExtension(fileName);
    return osgDB::getLowerCaseFileExtension(fileName);
}

/** Whether OSG's serializers, for which this project has a plugin, write files of a format. */
bool storesNodes(const std::string& format)
{
    const osgDB::ReaderWriter* writer = osgDB::Registry::instance()->getReaderWriterForExtension(format);
    return writer && writer->acceptsExtension("osgt");
}

/** Whether the words of the options include "bake". */
bool mustBake(const osgDB::Options* options)
{
    std::istringstream words(options ? options->getOptionString() : std::string());
    return std::find(std::istream_iterator<std::string>(words), {}, "bake") != std::istream_iterator<std::string>();
}

/** Have OSG compress binary files, unless the options choose otherwise: damage is then found by the compressor's check
 * sum, before OSG interprets the file. */
osg::ref_ptr<const osgDB::Options> protect(const osgDB::Options& options)
{
    constexpr const char* KEY = "Compressor";
    const std::string zlib = "zlib";
    const osg::ref_ptr<osgDB::Options> result = new osgDB::Options(options);
    if (result->getPluginStringData(KEY).empty() &&
        osgDB::Registry::instance()->getObjectWrapperManager()->findCompressor(zlib))
        result->setPluginStringData(KEY, zlib);
    return result;
}

// The formats written by OSG 3.6.5 that keep colours by vertex. All others keep them only as materials.
constexpr std::array<std::string_view, 4> COLORS_BY_VERTEX{"flt", "ive", "osg", "osgjs"};
constexpr std::array<std::string_view, 3> NO_COLORS{"3dc", "sta", "stl"};
// Formats whose writers ignore osg::Geometry or, like Debian's for .dae, report success without writing any file.
constexpr std::array<std::string_view, 3> NO_GEOMETRY{"dae", "iv", "wrl"};
// Formats of this project's plugins, which write the parts of LegoNodes.
constexpr std::array<std::string_view, 3> PARTS{"glb", "ldr", "mpd"};

/** Finds the reason why a LegoNode of a scene has triangles but no bricks. */
class ObstacleVisitor : public osg::NodeVisitor
{
public:
    ObstacleVisitor() : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN) {}

    using osg::NodeVisitor::apply;
    void apply(osg::Group& group) override
    {
        const auto* lego = dynamic_cast<const LegoNode*>(&group);
        if (!lego)
            traverse(group);
        else if (_obstacle.empty() && !lego->getBricks())
            _obstacle = lego->getObstacle();
    }

    const std::string& getObstacle() const { return _obstacle; }

private:
    std::string _obstacle;
};

std::string findObstacle(const osg::Node& node)
{
    ObstacleVisitor visitor;
    const_cast<osg::Node&>(node).accept(visitor); // which changes nothing
    return visitor.getObstacle();
}

BrickColors colorsOf(const std::string& format)
{
    const bool isByVertex = isOneOf(COLORS_BY_VERTEX, format) || isOneOf(NO_COLORS, format);
    return isByVertex ? BrickColors::BY_VERTEX : BrickColors::BY_MATERIAL;
}

} // namespace

BrickFileWriter::BrickFileWriter(osgDB::WriteFileCallback* next) : _next(next ? next : new osgDB::WriteFileCallback) {}

void BrickFileWriter::install()
{
    static std::once_flag once;
    std::call_once(once,
                   []
                   {
                       osgDB::Registry* registry = osgDB::Registry::instance();
                       registry->setWriteFileCallback(new BrickFileWriter(registry->getWriteFileCallback()));
                   });
}

template <typename Write>
BrickFileWriter::WriteResult BrickFileWriter::writeBaked(const osg::Node& node, const std::string& fileName,
                                                         const Options& options, const Write& write)
{
    const osg::ref_ptr<const osg::Node> scene = createBakedScene(node);
    WriteResult result = write(*scene, protect(options));
    if (scene == &node && result.success())
        OSG_WARN << "osgLego: '" << fileName << "' holds no bricks, because the scene has none to bake; expected a "
                 << "LegoNode with triangles, as from 'bunny.ply.64.legolize'" << std::endl;
    return result;
}

template <typename Write>
BrickFileWriter::WriteResult BrickFileWriter::writeBricks(const osg::Node& node, const std::string& fileName,
                                                          const Options* options, const Write& write)
try
{
    const std::string format = formatOf(fileName);
    const bool writesSource = storesNodes(format) && !mustBake(options);
    if (const std::string obstacle = writesSource ? std::string() : findObstacle(node); !obstacle.empty())
        return WriteResult("osgLego: '" + fileName + "' is not written, since it would have no bricks: " + obstacle);
    if (storesNodes(format) && mustBake(options)) return writeBaked(node, fileName, *options, write);
    if (storesNodes(format) || isOneOf(PARTS, format)) return write(node, options);
    const osg::ref_ptr<const osg::Node> scene = createBrickScene(node, colorsOf(format));
    if (scene != &node && isOneOf(NO_GEOMETRY, format))
        return WriteResult("osgLego: OpenSceneGraph's writer of ." + format + " leaves bricks out; expected " +
                           "another format for '" + fileName + "', such as .obj");
    WriteResult result = write(*scene, options);
    if (scene == &node || !result.success()) return result;
    // Some writers write nothing and report success.
    if (!osgDB::containsServerAddress(fileName) && !osgDB::fileExists(fileName))
        return WriteResult("osgLego: OpenSceneGraph's writer of ." + format + " has written no file '" + fileName +
                           "'");
    if (isOneOf(NO_COLORS, format))
        OSG_WARN << "osgLego: '" << fileName << "' holds the shape of the bricks without their colours, which ."
                 << format << " can't store" << std::endl;
    return result;
}
catch (const std::bad_alloc&)
{
    return WriteResult("osgLego: there is not enough memory to write '" + fileName + "'; expected fewer bricks");
}

BrickFileWriter::WriteResult BrickFileWriter::writeObject(const osg::Object& object, const std::string& fileName,
                                                          const Options* options)
{
    const auto* node = dynamic_cast<const osg::Node*>(&object);
    if (!node) return _next->writeObject(object, fileName, options);
    return writeBricks(*node, fileName, options,
                       [&](const osg::Node& scene, const osg::ref_ptr<const Options>& used)
                       { return _next->writeObject(scene, fileName, used); });
}

BrickFileWriter::WriteResult BrickFileWriter::writeImage(const osg::Image& image, const std::string& fileName,
                                                         const Options* options)
{
    return _next->writeImage(image, fileName, options);
}

BrickFileWriter::WriteResult BrickFileWriter::writeHeightField(const osg::HeightField& field,
                                                               const std::string& fileName, const Options* options)
{
    return _next->writeHeightField(field, fileName, options);
}

BrickFileWriter::WriteResult BrickFileWriter::writeNode(const osg::Node& node, const std::string& fileName,
                                                        const Options* options)
{
    return writeBricks(node, fileName, options,
                       [&](const osg::Node& scene, const osg::ref_ptr<const Options>& used)
                       { return _next->writeNode(scene, fileName, used); });
}

BrickFileWriter::WriteResult BrickFileWriter::writeShader(const osg::Shader& shader, const std::string& fileName,
                                                          const Options* options)
{
    return _next->writeShader(shader, fileName, options);
}

BrickFileWriter::WriteResult BrickFileWriter::writeScript(const osg::Script& script, const std::string& fileName,
                                                          const Options* options)
{
    return _next->writeScript(script, fileName, options);
}

} // namespace osgLego
