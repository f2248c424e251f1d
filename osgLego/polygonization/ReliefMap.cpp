#include <osgLego/polygonization/ReliefMap.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

namespace
{

constexpr std::size_t OWN_SIZE = 256;
constexpr std::size_t MAXIMUM_SIZE = 1024;

/** Height as a function of the position, both coordinates from -1 to 1. */
using HeightField = std::function<double(const glm::dvec2&)>;

double distanceToLine(const glm::dvec2& place, const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 along = b - a;
    const double part = glm::clamp(glm::dot(place - a, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::length(place - a - part * along);
}

/** A cube seen along its diagonal: a hexagon, and the three edges that meet at its centre. */
double ownHeight(const glm::dvec2& place)
{
    constexpr double SIZE = 0.62;
    constexpr double LINE = 0.055;
    constexpr double FLANK = 0.05;
    constexpr double SIXTH = 1.0471975511965976;
    double distance = 2.0;
    for (int corner = 0; corner < 6; ++corner)
    {
        const auto at = [](int number)
        {
            const double angle = (number + 0.5) * SIXTH;
            return SIZE * glm::dvec2(std::cos(angle), std::sin(angle));
        };
        distance = std::min(distance, distanceToLine(place, at(corner), at(corner + 1)));
        if (corner % 2 == 1) distance = std::min(distance, distanceToLine(place, glm::dvec2(0.0), at(corner)));
    }
    return 1.0 - glm::smoothstep(LINE - FLANK, LINE + FLANK, distance);
}

/** The heights of the image; 0 outside the disk. */
double imageHeight(const osg::Image& image, const glm::dvec2& place)
{
    const double inside = 1.0 - glm::smoothstep(0.8, 0.9, glm::length(place));
    const glm::dvec2 texel = (0.5 + 0.5 * place) * glm::dvec2(image.s(), image.t()) - 0.5;
    const auto valueAt = [&](double x, double y)
    {
        const auto column = static_cast<unsigned int>(std::clamp(x, 0.0, image.s() - 1.0));
        const auto row = static_cast<unsigned int>(std::clamp(y, 0.0, image.t() - 1.0));
        const double value = image.getColor(column, row).r();
        return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
    };
    const glm::dvec2 base = glm::floor(texel);
    const glm::dvec2 part = texel - base;
    const double lower = glm::mix(valueAt(base.x, base.y), valueAt(base.x + 1.0, base.y), part.x);
    const double upper = glm::mix(valueAt(base.x, base.y + 1.0), valueAt(base.x + 1.0, base.y + 1.0), part.x);
    return inside * glm::mix(lower, upper, part.y);
}

std::vector<glm::vec4> computeSlopes(const HeightField& heightAt, int size)
{
    std::vector<glm::vec4> slopes;
    slopes.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const double step = 1.0 / size; // half a texel
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
        {
            const glm::dvec2 place = (2.0 * glm::dvec2(column, row) + 1.0) * step - 1.0;
            const glm::dvec2 slope =
                glm::dvec2(heightAt(place + glm::dvec2(step, 0.0)) - heightAt(place - glm::dvec2(step, 0.0)),
                           heightAt(place + glm::dvec2(0.0, step)) - heightAt(place - glm::dvec2(0.0, step))) /
                (2.0 * step);
            slopes.emplace_back(slope, glm::dot(slope, slope), 0.0);
        }
    return slopes;
}

std::vector<glm::vec4> halved(const std::vector<glm::vec4>& slopes, std::size_t size)
{
    const std::size_t half = size / 2;
    std::vector<glm::vec4> result;
    result.reserve(half * half);
    for (std::size_t row = 0; row < half; ++row)
        for (std::size_t column = 0; column < half; ++column)
        {
            const glm::vec4* first = &slopes[2 * (row * size + column)];
            result.push_back(0.25f * (first[0] + first[1] + first[size] + first[size + 1]));
        }
    return result;
}

osg::ref_ptr<osg::Image> createMap(const HeightField& field, std::size_t size)
{
    std::vector<glm::vec4> level = computeSlopes(field, static_cast<int>(size));
    std::vector<glm::vec4> all = level;
    osg::Image::MipmapDataType offsets;
    for (std::size_t side = size; side > 1; side /= 2)
    {
        level = halved(level, side);
        offsets.push_back(static_cast<unsigned int>(all.size() * sizeof(glm::vec4)));
        all.insert(all.end(), level.begin(), level.end());
    }

    auto* data = new unsigned char[all.size() * sizeof(glm::vec4)];
    std::copy_n(reinterpret_cast<const unsigned char*>(all.data()), all.size() * sizeof(glm::vec4), data);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    // Must be the texture's format: otherwise OSG allocates a reused texture a second time, which GL rejects.
    image->setImage(static_cast<int>(size), static_cast<int>(size), 1, GL_RGBA16F_ARB, GL_RGBA, GL_FLOAT, data,
                    osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

} // namespace

osg::ref_ptr<osg::Image> createReliefMap(const osg::Image* heights)
{
    if (!heights)
    {
        static const osg::ref_ptr<osg::Image> OWN = createMap(ownHeight, OWN_SIZE);
        return OWN;
    }
    const std::size_t wanted = std::bit_ceil(static_cast<std::size_t>(std::max(heights->s(), heights->t())));
    return createMap([heights](const glm::dvec2& place) { return imageHeight(*heights, place); },
                     std::min(wanted, MAXIMUM_SIZE));
}

} // namespace osgLego
