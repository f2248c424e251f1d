#include <osgLego/LegoNode.h>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

// In OSG's own formats a LegoNode is its settings, as text, and its source; bricks are made anew when it is read.

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

REGISTER_OBJECT_WRAPPER(osgLego_LegoNode, new osgLego::LegoNode, osgLego::LegoNode,
                        "osg::Object osg::Node osg::Group osgLego::LegoNode")
{
    ADD_USER_SERIALIZER(Settings);
}
