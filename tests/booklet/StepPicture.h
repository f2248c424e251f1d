#pragma once

#include <booklet/BookletPictures.h>
#include <offscreen/OffscreenContext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace osgLego::test
{

inline constexpr double HEIGHT_OF_BRICK = 1.2; // pitches
inline constexpr double MARGIN = 0.15;         // pitches around the parts

struct Color
{
    double red = 0.0; // 0 to 1
    double green = 0.0;
    double blue = 0.0;

    bool isRed() const { return red > blue + 0.1; }
    /** The difference between the largest and the smallest channel, relative to the largest. */
    double getSaturation() const { return 1.0 - std::min({red, green, blue}) / std::max({red, green, blue}); }
};

/** The pixels of an encoded picture. */
class Pixels
{
public:
    explicit Pixels(const BookletPicture& picture)
    {
        OIIO::Filesystem::IOMemReader reader(const_cast<char*>(picture.bytes.data()), picture.bytes.size());
        const std::string name = picture.mediaType == "image/jpeg" ? "a.jpg" : "a.png";
        const auto input = OIIO::ImageInput::open(name, nullptr, &reader);
        if (!input) throw std::runtime_error(OIIO::geterror());
        _width = input->spec().width;
        _height = input->spec().height;
        _channels = input->spec().nchannels;
        _bytes.resize(static_cast<std::size_t>(_width * _height * _channels));
        input->read_image(0, 0, 0, _channels, OIIO::TypeDesc::UINT8, _bytes.data());
        EXPECT_EQ(_width, picture.width);
        EXPECT_EQ(_height, picture.height);
    }

    int getWidth() const { return _width; }
    int getHeight() const { return _height; }

    /** The mean colour of some pixels about a place, in pixels from the top left. */
    Color getColor(const glm::dvec2& place, int reach = 2) const
    {
        const double scale = 1.0 / (255.0 * (2 * reach + 1) * (2 * reach + 1));
        std::array<double, 3> sum{};
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                for (int channel = 0; channel < 3; ++channel)
                    sum[static_cast<std::size_t>(channel)] +=
                        scale *
                        _bytes.at(static_cast<std::size_t>(
                            ((static_cast<int>(place.y) + y) * _width + static_cast<int>(place.x) + x) * _channels +
                            channel));
        return {sum[0], sum[1], sum[2]};
    }

private:
    int _width = 0;
    int _height = 0;
    int _channels = 0;
    std::vector<std::uint8_t> _bytes;
};

/** The projection of booklets: parallel, from 33 degrees to the right of the front and 30 above the horizon, turned by
 * quarters counter-clockwise from above. Upside down, the eye is below, and the picture is turned by half. */
class Projection
{
public:
    Projection(int turns, bool isUpsideDown) :
        _azimuth((33.0 + 90.0 * turns) * std::numbers::pi / 180.0), _sign(isUpsideDown ? -1.0 : 1.0)
    {
    }

    /** @param place in pitches: x to the right, y away and z upwards. @return pitches, to the right and upwards. */
    glm::dvec2 project(const glm::dvec3& place) const
    {
        const double right = place.x * std::cos(_azimuth) + place.y * std::sin(_azimuth);
        const double near = place.x * std::sin(_azimuth) - place.y * std::cos(_azimuth);
        return {_sign * right, _sign * place.z * std::cos(std::numbers::pi / 6.0) - 0.5 * near};
    }

private:
    double _azimuth;
    double _sign;
};

/** Finds places in the pictures of a chapter's steps. */
class StepPicture
{
public:
    /** @param placed the parts in place, and then the others of the chapter.
     * @param width of the widest view of the chapter, in pitches; 0 for that of this view. */
    StepPicture(const Projection& projection, std::vector<Part> parts, std::size_t numPlaced, const glm::ivec2& pixels,
                double width = 0.0) :
        _projection(projection),
        _pixels(pixels)
    {
        double left = std::numeric_limits<double>::max();
        double right = std::numeric_limits<double>::lowest();
        for (std::size_t index = 0; index < parts.size(); ++index)
            for (int corner = 0; corner < 8; ++corner)
            {
                const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
                glm::dvec3 place = glm::dvec3(parts[index].getCell()) + share * glm::dvec3(parts[index].getSize());
                place.z = place.z * HEIGHT_OF_BRICK + (corner >> 2) * STUD;
                const glm::dvec2 point = projection.project(place);
                left = std::min(left, point.x);
                right = std::max(right, point.x);
                if (index < numPlaced) _bottom = std::min(_bottom, point.y - MARGIN);
            }
        if (width == 0.0) width = right - left + 2.0 * MARGIN;
        _left = 0.5 * (left + right) - 0.5 * width;
        _scale = pixels.x / width;
    }

    /** @param place in studs and layers. @return pixels from the top left. */
    glm::dvec2 find(glm::dvec3 place) const
    {
        place.z *= HEIGHT_OF_BRICK;
        const glm::dvec2 point = _projection.project(place);
        return {(point.x - _left) * _scale, _pixels.y - (point.y - _bottom) * _scale};
    }

    double getScale() const { return _scale; }

private:
    static constexpr double STUD = 0.2; // its height, in pitches

    Projection _projection;
    glm::ivec2 _pixels;
    double _left = 0.0;
    double _bottom = std::numeric_limits<double>::max();
    double _scale = 0.0; // pixels per pitch
};

/** Pictures that are drawn in one context. */
class BookletPicturesTest : public testing::Test
{
protected:
    BookletPicturesTest() : _renderer(*_context) {}

private:
    static osg::ref_ptr<osg::GraphicsContext> createContext()
    {
        std::string error;
        osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(16, 16, error);
        if (!context) throw std::runtime_error(error);
        return context;
    }

    osg::ref_ptr<osg::GraphicsContext> _context = createContext();

protected:
    BookletRenderer _renderer;
};

} // namespace osgLego::test
