#include <osgLego/LegoNode.h>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

// OSG's own formats store a LegoNode's settings, as text, its appearance, its light and its source. The bricks are made
// again after reading.

static bool checkSettings(const osgLego::LegoNode&)
{
    return true;
}

static bool readSettings(osgDB::InputStream& stream, osgLego::LegoNode& node)
{
    std::string text;
    stream.readWrappedString(text);
    osgLego::LegoSettings settings;
    std::string error;
    if (osgLego::LegoSettings::parse(text, settings, error)) return node.setSettings(settings);
    OSG_WARN << "osgLego: in the settings of a LegoNode: " << error << std::endl;
    return false;
}

static bool writeSettings(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    stream.writeWrappedString(node.getSettings().toString());
    stream << std::endl;
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
        appearance.materialSpecular >> hasImage;
    if (hasImage) appearance.reliefImage = stream.readImage();
    return node.setAppearance(appearance);
}

static bool writeAppearance(osgDB::OutputStream& stream, const osgLego::LegoNode& node)
{
    const osgLego::BrickAppearance appearance = node.getAppearance();
    stream << appearance.joints << appearance.reliefHeight << appearance.roughness << appearance.variation
           << appearance.materialSpecular << appearance.reliefImage.valid();
    if (appearance.reliefImage) stream.writeImage(appearance.reliefImage);
    stream << std::endl;
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

REGISTER_OBJECT_WRAPPER(osgLego_LegoNode, new osgLego::LegoNode, osgLego::LegoNode,
                        "osg::Object osg::Node osg::Group osgLego::LegoNode")
{
    ADD_USER_SERIALIZER(Settings);
    ADD_USER_SERIALIZER(Appearance);
    ADD_USER_SERIALIZER(Light);
}
