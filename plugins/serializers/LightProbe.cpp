#include <osgLego/LightProbe.h>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

// OSG's own formats store a light probe's picture, by file name if it has one, and its mapping onto the scene.

static bool checkPicture(const osgLego::LightProbe& probe)
{
    return probe.getImage() != nullptr;
}

static bool readPicture(osgDB::InputStream& stream, osgLego::LightProbe& probe)
{
    int mapping = 0;
    stream >> mapping;
    const bool isKnown = mapping >= osgLego::LightProbe::AUTO && mapping <= osgLego::LightProbe::ANGULAR;
    const osg::ref_ptr<osg::Image> image = stream.readImage();
    std::string error = "its picture can't be read";
    if (image && isKnown && probe.setImage(image, static_cast<osgLego::LightProbe::Mapping>(mapping), error))
        return true;
    OSG_WARN << "osgLego: a light probe falls back to the built-in sky: " << error << std::endl;
    return true;
}

static bool writePicture(osgDB::OutputStream& stream, const osgLego::LightProbe& probe)
{
    stream << static_cast<int>(probe.getMapping());
    stream.writeImage(probe.getImage());
    stream << std::endl;
    return true;
}

REGISTER_OBJECT_WRAPPER(osgLego_LightProbe, new osgLego::LightProbe, osgLego::LightProbe,
                        "osg::Object osgLego::LightProbe")
{
    ADD_USER_SERIALIZER(Picture);
    ADD_QUAT_SERIALIZER(Rotation, osg::Quat());
    ADD_DOUBLE_SERIALIZER(Intensity, 1.0);
}
