#include <osgLego/LightProbe.h>

#include <osgLego/light/ProbeLight.h>
#include <osgLego/light/RadiancePicture.h>

#include <cmath>
#include <new>
#include <optional>

#include <osg/Notify>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

const char* const NO_MEMORY = "there is not enough memory for the picture of a light probe";

osgDB::ReaderWriter::ReadResult readImage(const std::string& fileName)
{
    osgDB::Registry* registry = osgDB::Registry::instance();
    // This project's plugin keeps floats and checks the values in the header; OSG's plugins may not.
    if (osgDB::ReaderWriter* plugin = registry->getReaderWriterForExtension("oiio"))
        return plugin->readImage(fileName + ".oiio", registry->getOptions());
    return registry->readImage(fileName, registry->getOptions());
}

} // namespace

LightProbe::LightProbe() = default;

LightProbe::LightProbe(const LightProbe& probe, const osg::CopyOp& copyop) :
    osg::Object(probe, copyop), _image(copyop(probe._image.get())), _mapping(probe._mapping), _light(probe._light),
    _rotation(probe._rotation), _intensity(probe._intensity)
{
}

LightProbe::~LightProbe() = default;

osg::ref_ptr<LightProbe> LightProbe::read(const std::string& fileName, std::string& error, Mapping mapping)
{
    const std::string name = "the light probe '" + fileName + "'";
    if (osgDB::findDataFile(fileName).empty())
    {
        error = name + " was not found";
        return nullptr;
    }
    try
    {
        osgDB::ReaderWriter::ReadResult result = readImage(fileName);
        const osg::ref_ptr<osg::Image> image = result.getImage();
        if (!image)
        {
            const std::string reason = result.statusMessage();
            error = name + " can't be read: " + (reason.empty() ? "it is not an image" : reason);
            return nullptr;
        }
        osg::ref_ptr<LightProbe> probe = new LightProbe;
        if (probe->setImage(image, mapping, error)) return probe;
        error = name + " can't be used: " + error;
    }
    catch (const std::bad_alloc&)
    {
        error = name + " can't be read: there is not enough memory for it";
    }
    return nullptr;
}

bool LightProbe::setImage(const osg::Image* image, Mapping mapping, std::string& error)
{
    if (!image)
    {
        _image = nullptr;
        _mapping = AUTO;
        _light = nullptr;
        return true;
    }
    try
    {
        const std::optional<RadiancePicture> picture = RadiancePicture::read(*image, mapping, error);
        if (!picture) return false;
        _light = ProbeLight::create(*picture);
        _image = image;
        _mapping = mapping;
        return true;
    }
    catch (const std::bad_alloc&)
    {
        error = NO_MEMORY;
        return false;
    }
}

void LightProbe::setRotation(const osg::Quat& rotation)
{
    const double length = rotation.length();
    if (!std::isfinite(length) || length <= 0.0)
    {
        OSG_WARN << "osgLego: the rotation of a light probe is a quaternion of length " << length
                 << "; expected a finite length above 0" << std::endl;
        return;
    }
    _rotation = rotation / length;
}

void LightProbe::setIntensity(double intensity)
{
    if (!std::isfinite(intensity) || intensity < 0.0)
    {
        OSG_WARN << "osgLego: the intensity of a light probe is " << intensity << "; expected 0 or more" << std::endl;
        return;
    }
    _intensity = intensity;
}

osg::Vec3d LightProbe::getIrradiance(const osg::Vec3d& worldNormal) const
{
    osg::Vec3d normal = _rotation.inverse() * worldNormal;
    const double length = normal.normalize();
    if (!std::isfinite(length) || length <= 0.0) return {};
    const ProbeLight& light = getLight();
    return (usesConvolvedMap() ? light.getConvolvedIrradiance(normal) : light.getHarmonicIrradiance(normal)) *
           _intensity;
}

const std::array<osg::Vec3d, 9>& LightProbe::getCoefficients() const
{
    return getLight().getCoefficients();
}

osg::Vec3d LightProbe::getHarmonicIrradiance(const osg::Vec3d& normal) const
{
    return getLight().getHarmonicIrradiance(normal);
}

osg::Image* LightProbe::getConvolvedMap() const
{
    return getLight().getConvolvedMap();
}

double LightProbe::getHarmonicError() const
{
    return getLight().getHarmonicError();
}

bool LightProbe::usesConvolvedMap() const
{
    return getHarmonicError() > MAXIMUM_HARMONIC_ERROR;
}

osg::Image* LightProbe::getReflectionMap(int level) const
{
    return level >= 0 && level < REFLECTION_LEVELS ? getLight().getReflectionMap(level) : nullptr;
}

const ProbeLight& LightProbe::getLight() const
{
    return _light ? *_light : ProbeLight::getSky();
}

} // namespace osgLego
