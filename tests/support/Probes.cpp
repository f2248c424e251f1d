#include "Probes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <osg/Vec3f>

namespace osgLego::test
{

namespace
{

using std::numbers::pi;

osg::ref_ptr<osg::Image> createImage(int width, int height)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGB, GL_FLOAT);
    return image;
}

void setPixel(osg::Image& image, int column, int row, const osg::Vec3d& color)
{
    auto* pixel = image.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
    *reinterpret_cast<osg::Vec3f*>(pixel) = color;
}

double solidAngleOf(int row, int width, int height)
{
    return 2.0 * pi / width * (std::cos(pi * row / height) - std::cos(pi * (row + 1) / height));
}

} // namespace

osg::Vec3d latitudeLongitudeDirection(int column, int row, int width, int height)
{
    const double azimuth = 2.0 * pi * ((column + 0.5) / width - 0.5);
    const double fromTop = pi * (1.0 - (row + 0.5) / height);
    return {std::sin(fromTop) * std::sin(azimuth), std::sin(fromTop) * std::cos(azimuth), std::cos(fromTop)};
}

osg::ref_ptr<osg::Image> createLatitudeLongitude(int width, const RadianceOf& radianceOf)
{
    osg::ref_ptr<osg::Image> image = createImage(width, width / 2);
    for (int row = 0; row < image->t(); ++row)
        for (int column = 0; column < width; ++column)
            setPixel(*image, column, row, radianceOf(latitudeLongitudeDirection(column, row, width, width / 2)));
    return image;
}

osg::ref_ptr<osg::Image> createAngularMap(int size, const RadianceOf& radianceOf)
{
    osg::ref_ptr<osg::Image> image = createImage(size, size);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
        {
            const double right = 2.0 * (column + 0.5) / size - 1.0;
            const double up = 2.0 * (row + 0.5) / size - 1.0;
            const double distance = std::hypot(right, up);
            // The centre of a pixel on the rim is outside the circle, but part of the pixel is inside.
            const double angle = pi * std::min(distance, 1.0);
            const osg::Vec3d direction(right / distance * std::sin(angle), std::cos(angle),
                                       up / distance * std::sin(angle));
            const bool outside = distance > 1.0 + 3.0 / size;
            setPixel(*image, column, row, outside ? osg::Vec3d(1000.0, 1000.0, 1000.0) : radianceOf(direction));
        }
    return image;
}

osg::Vec3d pixelOf(const osg::Image& image, int column, int row)
{
    return *reinterpret_cast<const osg::Vec3f*>(
        image.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row)));
}

osg::Vec3d meanOf(const osg::Image& image)
{
    osg::Vec3d sum;
    for (int row = 0; row < image.t(); ++row)
        for (int column = 0; column < image.s(); ++column)
            sum += pixelOf(image, column, row) * solidAngleOf(row, image.s(), image.t());
    return sum / (4.0 * pi);
}

std::vector<osg::Vec3d> sumIrradiance(const osg::Image& image, const std::vector<osg::Vec3d>& normals)
{
    std::vector<osg::Vec3d> sums(normals.size());
    for (int row = 0; row < image.t(); ++row)
        for (int column = 0; column < image.s(); ++column)
        {
            const osg::Vec3d direction = latitudeLongitudeDirection(column, row, image.s(), image.t());
            osg::Vec3d light = pixelOf(image, column, row) * (solidAngleOf(row, image.s(), image.t()) / pi);
            for (unsigned int channel = 0; channel < 3; ++channel)
                light[channel] = std::max(light[channel], 0.0);
            for (std::size_t index = 0; index < normals.size(); ++index)
                sums[index] += light * std::max(direction * normals[index], 0.0);
        }
    return sums;
}

std::vector<osg::Vec3d> createNormals()
{
    constexpr int COUNT = 100;
    std::vector<osg::Vec3d> normals;
    for (int index = 0; index < COUNT; ++index)
    {
        const double height = 1.0 - (2.0 * index + 1.0) / COUNT;
        const double azimuth = index * pi * (3.0 - std::sqrt(5.0)); // the golden angle
        const double radius = std::sqrt(1.0 - height * height);
        normals.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), height);
    }
    return normals;
}

} // namespace osgLego::test
