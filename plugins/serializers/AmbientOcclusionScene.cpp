#include "SettingsField.h"

#include <osgLego/AmbientOcclusionScene.h>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

static bool checkSettings(const osgLego::AmbientOcclusionScene&)
{
    return true;
}

static bool readSettings(osgDB::InputStream& stream, osgLego::AmbientOcclusionScene& scene)
{
    const std::string text = readSettingsField(stream);
    osgLego::AmbientOcclusionSettings settings;
    std::string error;
    if (osgLego::AmbientOcclusionSettings::parse(text, settings, error)) return scene.setSettings(settings);
    OSG_WARN << "osgLego: in the settings of an AmbientOcclusionScene: " << error << std::endl;
    return false;
}

static bool writeSettings(osgDB::OutputStream& stream, const osgLego::AmbientOcclusionScene& scene)
{
    writeSettingsField(stream, scene.getSettings().toString());
    return true;
}

static bool checkLight(const osgLego::AmbientOcclusionScene&)
{
    return true;
}

static bool readLight(osgDB::InputStream& stream, osgLego::AmbientOcclusionScene& scene)
{
    const osg::ref_ptr<osgLego::LightProbe> probe = stream.readObjectOfType<osgLego::LightProbe>();
    if (probe) scene.setLightProbe(probe);
    return probe.valid();
}

static bool writeLight(osgDB::OutputStream& stream, const osgLego::AmbientOcclusionScene& scene)
{
    stream.writeObject(scene.getLightProbe());
    return true;
}

REGISTER_OBJECT_WRAPPER(osgLego_AmbientOcclusionScene, new osgLego::AmbientOcclusionScene,
                        osgLego::AmbientOcclusionScene,
                        "osg::Object osg::Node osg::Group osgLego::AmbientOcclusionScene")
{
    ADD_BOOL_SERIALIZER(Enabled, true);
    ADD_USER_SERIALIZER(Settings);
    ADD_USER_SERIALIZER(Light);
}
