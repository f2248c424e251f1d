#include <osgLego/light/LatitudeLongitude.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace osgLego::LatitudeLongitude
{

namespace
{

using std::numbers::pi;

} // namespace

osg::Vec3d directionAt(double u, double v)
{
    const double longitude = 2.0 * pi * (u - 0.5);
    const double latitude = pi * (v - 0.5);
    return {std::cos(latitude) * std::sin(longitude), std::cos(latitude) * std::cos(longitude), std::sin(latitude)};
}

osg::Vec2d coordinatesOf(const osg::Vec3d& direction)
{
    return {0.5 + std::atan2(direction.x(), direction.y()) / (2.0 * pi),
            0.5 + std::asin(std::clamp(direction.z(), -1.0, 1.0)) / pi};
}

double solidAngleOf(int row, int width, int height)
{
    const auto heightAt = [&](int edge) { return std::sin(pi * (static_cast<double>(edge) / height - 0.5)); };
    return 2.0 * pi / width * (heightAt(row + 1) - heightAt(row));
}

} // namespace osgLego::LatitudeLongitude
