#pragma once

#include <osgLego/ProbeFormat.h>
#include <osgLego/light/RadianceGrid.h>
#include <osgLego/light/SphericalHarmonics.h>

#include <array>

#include <osg/Image>
#include <osg/Referenced>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego
{

/** The data computed from the picture of a light probe; LightProbe describes it.
 *
 * Immutable once created: every function may be called from any thread, and probes with the same light share one
 * object. */
class ProbeLight : public osg::Referenced
{
public:
    /** Throws std::bad_alloc if memory runs out. */
    static osg::ref_ptr<const ProbeLight> create(const RadiancePicture& picture);
    /** The light of the built-in sky, computed on the first call. */
    static const ProbeLight& getSky();

    const SphericalHarmonics::Coefficients& getCoefficients() const { return _coefficients; }
    osg::Image* getConvolvedMap() const { return _convolvedMap.get(); }
    osg::Image* getReflectionMap(int level) const { return _reflectionMaps[static_cast<std::size_t>(level)].get(); }
    double getHarmonicError() const { return _harmonicError; }

    osg::Vec3d getHarmonicIrradiance(const osg::Vec3d& normal) const;
    /** The value interpolated from the convolved map. */
    osg::Vec3d getConvolvedIrradiance(const osg::Vec3d& normal) const;

private:
    explicit ProbeLight(const RadiancePicture& picture);
    ~ProbeLight() override = default;

    double computeHarmonicError() const;
    osg::Vec3d getConvolvedPixel(int column, int row) const;

    SphericalHarmonics::Coefficients _coefficients;
    SphericalHarmonics::Coefficients _irradiancePolynomial;
    osg::ref_ptr<osg::Image> _convolvedMap;
    std::array<osg::ref_ptr<osg::Image>, ProbeFormat::REFLECTION_LEVELS> _reflectionMaps;
    double _harmonicError = 0.0;
};

} // namespace osgLego
