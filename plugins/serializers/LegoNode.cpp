#include "BytesField.h"
#include "SettingsField.h"

#include <osgLego/BrickCodec.h>
#include <osgLego/LegoNode.h>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <new>

// OSG's own formats store a LegoNode's settings, as text, its appearance, its light and its source, from which the
// bricks are made again after reading, or its stored bricks.

namespace osgLego
{

/** Gives a node the settings of a file. */
class LegoNodeSerializer
{
public:
    static bool setSettings(LegoNode& node, const LegoSettings& settings)
    {
        return node.changeSettings(settings, false);
    }
};

} // namespace osgLego

static bool checkSettings(const osgLego::LegoNode&)
{
    return true;
}

static bool readSettings(osgDB::InputStream& stream, osgLego::LegoNode& node)
{
    const std::string text = readSettingsField(stream);
    osgLego::LegoSettings settings;
    std::string error;
    if (osgLego::LegoSettings::parse(text, settings, error))
        return osgLego::LegoNodeSerializer::setSettings(node, settings);
    OSG_WARN << "osgLego: in the settings of a LegoNode: " << error << std::endl;
    return false;
}

static bool writeSettings(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    writeSettingsField(stream, node.getSettings().toString());
    return true;
}

static bool checkAppearance(const osgLego::LegoNode& node)
{
    return node.getAppearance() != osgLego::BrickAppearance();
}

static bool readAppearance(osgDB::InputStream& stream, osgLego::LegoNode& node)
{
    osgLego::BrickAppearance appearance;
    bool hasImage = false;
    stream >> appearance.joints >> appearance.reliefHeight >> appearance.roughness >> appearance.variation >>
        appearance.materialSpecular >> appearance.outline >> hasImage;
    if (hasImage) appearance.reliefImage = stream.readImage();
    return node.setAppearance(appearance);
}

static bool writeAppearance(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    const osgLego::BrickAppearance appearance = node.getAppearance();
    stream << appearance.joints << appearance.reliefHeight << appearance.roughness << appearance.variation
           << appearance.materialSpecular << appearance.outline << appearance.reliefImage.valid();
    if (appearance.reliefImage) stream.writeImage(appearance.reliefImage);
    stream << std::endl;
    return true;
}

static bool checkOcclusion(const osgLego::LegoNode& node)
{
    const osgLego::BrickAppearance appearance = node.getAppearance();
    const osgLego::BrickAppearance usual;
    return appearance.occlusion != usual.occlusion || appearance.distantOcclusion != usual.distantOcclusion;
}

static bool readOcclusion(osgDB::InputStream& stream, osgLego::LegoNode& node)
{
    osgLego::BrickAppearance appearance = node.getAppearance();
    unsigned int number = 0;
    stream >> number >> appearance.distantOcclusion;
    if (number > static_cast<unsigned int>(osgLego::BrickOcclusion::BOTH)) return false;
    appearance.occlusion = static_cast<osgLego::BrickOcclusion>(number);
    return node.setAppearance(appearance);
}

static bool writeOcclusion(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    const osgLego::BrickAppearance appearance = node.getAppearance();
    stream << static_cast<unsigned int>(appearance.occlusion) << appearance.distantOcclusion << std::endl;
    return true;
}

static bool checkLight(const osgLego::LegoNode&)
{
    return true;
}

static bool readLight(osgDB::InputStream& stream, osgLego::LegoNode& node)
{
    const osg::ref_ptr<osgLego::LightProbe> probe = stream.readObjectOfType<osgLego::LightProbe>();
    if (probe) node.setLightProbe(probe);
    return probe.valid();
}

static bool writeLight(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    stream.writeObject(node.getLightProbe());
    return true;
}

constexpr const char* NO_BRICKS = "none"; // in the place of stored bricks

// The last node whose stored bricks, or their absence, have been read by this thread.
static thread_local const osgLego::LegoNode* lastComplete = nullptr;

/** Refuses files that end, or are damaged, between a node without children and its stored bricks. In such a file, OSG
 * finds no property of this name, and would return an empty node. */
class StoredBricksCheck : public osgDB::FinishedObjectReadCallback
{
public:
    void objectRead(osgDB::InputStream& stream, osg::Object& object) override
    {
        const auto& node = static_cast<const osgLego::LegoNode&>(object);
        if (node.getNumChildren() == 0 && lastComplete != &node && !stream.getException())
            stream.throwException("osgLego: a LegoNode in the file is incomplete; expected a source or stored bricks");
        lastComplete = nullptr;
    }
};

static bool checkStoredBricks(const osgLego::LegoNode& node)
{
    return node.getStoredBricks().valid() || node.getNumChildren() == 0;
}

/** Read stored bricks, or their absence, into a node. @return one sentence if they can't be read; otherwise empty. */
static std::string readBricks(osgDB::InputStream& stream, osgLego::LegoNode& node)
try
{
    std::string bytes;
    std::string error = "the stored bricks are damaged or incomplete; expected the file as it was written";
    if (!readBytesField(stream, bytes)) return error;
    if (bytes == NO_BRICKS) return {};
    const osg::ref_ptr<const osgLego::BrickModel> bricks = osgLego::decodeBricks(bytes, error);
    if (!bricks) return error;
    node.setStoredBricks(bricks);
    return {};
}
catch (const std::bad_alloc&)
{
    return "there is not enough memory for the stored bricks; expected up to 40 bytes for each of them";
}

static bool readStoredBricks(osgDB::InputStream& stream, osgLego::LegoNode& node)
{
    lastComplete = &node;
    // Without its bricks, the node would be empty: the whole file is refused.
    if (const std::string error = readBricks(stream, node); !error.empty()) stream.throwException("osgLego: " + error);
    return true; // otherwise, OSG would add a message that names the property
}

/** @return the bytes of a node's bricks; empty, with one sentence in `error`, if they can't be stored. */
static std::string encodeBricksOf(const osgLego::LegoNode& node, std::string& error)
try
{
    const osg::ref_ptr<const osgLego::BrickModel> bricks = node.getStoredBricks();
    if (!bricks) return NO_BRICKS;
    error = "the bricks of a LegoNode can't be stored; expected a smaller model";
    return osgLego::encodeBricks(*bricks);
}
catch (const std::bad_alloc&)
{
    error = "there is not enough memory to store the bricks of a LegoNode; expected 20 bytes for each of them";
    return {};
}

static bool writeStoredBricks(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    std::string error;
    const std::string bytes = encodeBricksOf(node, error);
    if (bytes.empty())
        stream.throwException("osgLego: " + error);
    else
        writeBytesField(stream, bytes);
    return true; // as after reading
}

REGISTER_OBJECT_WRAPPER(osgLego_LegoNode, new osgLego::LegoNode, osgLego::LegoNode,
                        "osg::Object osg::Node osg::Group osgLego::LegoNode")
{
    ADD_USER_SERIALIZER(Settings);
    ADD_USER_SERIALIZER(Appearance);
    ADD_USER_SERIALIZER(Occlusion);
    ADD_USER_SERIALIZER(Light);
    ADD_USER_SERIALIZER(StoredBricks);
    wrapper->addFinishedObjectReadCallback(new StoredBricksCheck);
}
