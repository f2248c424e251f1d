#include <osgLego/light/SkyModel.h>

#include <algorithm>
#include <cmath>

namespace osgLego
{

namespace
{

// With this light and a headlight, the display value of a white surface is 0.84 in front, above 0.9 on top, and below
// 0.7 at the sides, so that a brick's faces can be distinguished without any other light.
const osg::Vec3d ZENITH(0.52, 0.60, 0.72);
const osg::Vec3d HORIZON(0.087, 0.090, 0.095);
const osg::Vec3d GROUND(0.094, 0.090, 0.085);
const osg::Vec3d GLOW(5.75, 5.30, 4.70);
// Half of the glow's light is within 19 degrees of its centre, as with a large softbox.
constexpr double GLOW_SHARPNESS = 13.0;
constexpr double HORIZON_SOFTNESS = 0.06; // a height on the unit sphere

osg::Vec3d glowDirection()
{
    osg::Vec3d direction(0.18, -0.46, 0.90);
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
