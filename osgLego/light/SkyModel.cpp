#include <osgLego/light/SkyModel.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

namespace
{

const osg::Vec3d ZENITH(0.43, 0.50, 0.60);
const osg::Vec3d HORIZON(0.60, 0.62, 0.65);
const osg::Vec3d GROUND(0.230, 0.220, 0.205);
const osg::Vec3d GLOW(2.30, 2.12, 1.88);
// Half the glow's light is within 18 degrees of its middle, as in a large softbox.
constexpr double GLOW_SHARPNESS = 14.0;
constexpr double HORIZON_SOFTNESS = 0.06; // as a height on the unit sphere

osg::Vec3d glowDirection()
{
    osg::Vec3d direction(0.45, -0.45, 0.77);
    direction.normalize();
    return direction;
}

osg::Vec3d mix(const osg::Vec3d& a, const osg::Vec3d& b, double share)
{
    return a * (1.0 - share) + b * share;
}

double smoothStep(double begin, double end, double value)
{
    const double share = std::clamp((value - begin) / (end - begin), 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}

} // namespace

osg::Vec3d computeSkyRadiance(const osg::Vec3d& direction)
{
    static const osg::Vec3d glow = glowDirection();
    const double height = direction.z();
    const osg::Vec3d sky = mix(HORIZON, ZENITH, std::sqrt(std::max(height, 0.0))) +
                           GLOW * std::exp(GLOW_SHARPNESS * (direction * glow - 1.0));
    return mix(GROUND, sky, smoothStep(-HORIZON_SOFTNESS, HORIZON_SOFTNESS, height));
}

} // namespace osgLego
