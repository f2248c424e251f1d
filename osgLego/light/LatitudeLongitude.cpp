#include <osgLego/light/LatitudeLongitude.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace osgLego::LatitudeLongitude
{

namespace
{

constexpr double PI = std::numbers::pi;

} // namespace

osg::Vec3d directionAt(double u, double v)
{
    const double longitude = 2.0 * PI * (u - 0.5);
    const double latitude = PI * (v - 0.5);
    return {std::cos(latitude) * std::sin(longitude), std::cos(latitude) * std::cos(longitude), std::sin(latitude)};
}

osg::Vec2d coordinatesOf(const osg::Vec3d& direction)
{
    return {0.5 + std::atan2(direction.x(), direction.y()) / (2.0 * PI),
            0.5 + std::asin(std::clamp(direction.z(), -1.0, 1.0)) / PI};
}

double solidAngleOf(int row, int width, int height)
{
    const auto heightAt = [&](int edge) { return std::sin(PI * (static_cast<double>(edge) / height - 0.5)); };
    return 2.0 * PI / width * (heightAt(row + 1) - heightAt(row));
}

} // namespace osgLego::LatitudeLongitude
