#include "NewPartOutline.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr int WIDTH = 2;     // of the line, in places of the mask
constexpr int BESIDE = 3;    // the width of the surroundings beside the line
constexpr float EDGE = 0.9f; // the share of new parts in a place from which the place belongs to them

// From the most to the least noticeable among bricks and their black lines.
constexpr std::array<PixelColor, 5> CANDIDATES{
    {{0xc8, 0x10, 0x2e}, {0x00, 0x33, 0xa0}, {0x00, 0x00, 0x00}, {0xff, 0xe0, 0x30}, {0xff, 0xff, 0xff}}};

double toLinear(std::uint8_t channel)
{
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double getLuminance(const PixelColor& color)
{
    return 0.2126 * toLinear(color[0]) + 0.7152 * toLinear(color[1]) + 0.0722 * toLinear(color[2]);
}

PixelColor getPixel(const osg::Image& picture, int x, int y)
{
    const unsigned char* data = picture.data(static_cast<unsigned int>(x), static_cast<unsigned int>(y));
    return {data[0], data[1], data[2]};
}

/** The largest of the values around each pixel, in a square. */
std::vector<float> dilate(const std::vector<float>& values, int width, int height, int reach)
{
    const auto dilateRows = [reach](const std::vector<float>& from, int length, int count, int step, int next)
    {
        std::vector<float> to(from.size());
        for (int row = 0; row < count; ++row)
            for (int place = 0; place < length; ++place)
            {
                float most = 0.0f;
                for (int near = std::max(place - reach, 0); near <= std::min(place + reach, length - 1); ++near)
                    most = std::max(most, from[static_cast<std::size_t>(row * next + near * step)]);
                to[static_cast<std::size_t>(row * next + place * step)] = most;
            }
        return to;
    };
    return dilateRows(dilateRows(values, width, height, 1, width), height, width, width, 1);
}

} // namespace

double getContrast(const PixelColor& color, const PixelColor& other)
{
    constexpr double GLARE = 0.05;
    const auto [low, high] = std::minmax({getLuminance(color), getLuminance(other)});
    return (high + GLARE) / (low + GLARE);
}

NewPartOutline::NewPartOutline(const NewPartMask& mask) :
    _lowest(mask.lowest), _width(mask.size.x), _height(mask.size.y), _ring(dilate(mask.shares, _width, _height, WIDTH)),
    _outside(dilate(mask.shares, _width, _height, WIDTH + BESIDE))
{
    for (std::size_t place = 0; place < mask.shares.size(); ++place)
    {
        _outside[place] = std::max(_outside[place] - _ring[place], 0.0f);
        _ring[place] = mask.shares[place] > EDGE ? 0.0f : _ring[place];
    }
}

/** The value between the middles of places. */
float NewPartOutline::findShare(const std::vector<float>& shares, double x, double y) const
{
    const int left = std::clamp(static_cast<int>(std::floor(x - 0.5)), 0, _width - 1);
    const int low = std::clamp(static_cast<int>(std::floor(y - 0.5)), 0, _height - 1);
    const int right = std::min(left + 1, _width - 1);
    const int high = std::min(low + 1, _height - 1);
    const auto across = static_cast<float>(std::clamp(x - 0.5 - left, 0.0, 1.0));
    const auto up = static_cast<float>(std::clamp(y - 0.5 - low, 0.0, 1.0));
    const auto at = [&](int column, int row) { return shares[static_cast<std::size_t>(row * _width + column)]; };
    return (1.0f - up) * ((1.0f - across) * at(left, low) + across * at(right, low)) +
           up * ((1.0f - across) * at(left, high) + across * at(right, high));
}

void NewPartOutline::addSurroundings(const osg::Image& picture, std::vector<PixelColor>& colors) const
{
    for (int y = 0; y < _height; ++y)
        for (int x = 0; x < _width; ++x)
            if (_outside[static_cast<std::size_t>(y * _width + x)] > 0.5f)
                colors.push_back(
                    getPixel(picture, NewPartMask::PIXELS * (_lowest.x + x), NewPartMask::PIXELS * (_lowest.y + y)));
}

PixelColor NewPartOutline::chooseColor(const std::vector<NewPartOutline>& outlines, const osg::Image& picture)
{
    constexpr std::size_t FEW = 100; // a hundredth of the surroundings may have less contrast
    constexpr double RESERVE = 1.1;  // for antialiasing, and for the losses of JPEG
    std::vector<PixelColor> surroundings;
    for (const NewPartOutline& outline : outlines)
        outline.addSurroundings(picture, surroundings);
    if (surroundings.empty()) return CANDIDATES.front();
    PixelColor best{};
    double most = 0.0;
    for (const PixelColor& candidate : CANDIDATES)
    {
        std::vector<double> contrasts;
        contrasts.reserve(surroundings.size());
        for (const PixelColor& color : surroundings)
            contrasts.push_back(getContrast(candidate, color));
        const auto place = contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() / FEW);
        std::nth_element(contrasts.begin(), place, contrasts.end());
        if (*place >= RESERVE * LEAST_CONTRAST) return candidate;
        if (*place <= most) continue;
        most = *place;
        best = candidate;
    }
    return best;
}

void NewPartOutline::draw(osg::Image& picture, const PixelColor& color) const
{
    const glm::ivec2 first = NewPartMask::PIXELS * _lowest;
    const glm::ivec2 end =
        glm::min(first + NewPartMask::PIXELS * glm::ivec2(_width, _height), glm::ivec2(picture.s(), picture.t()));
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x)
        {
            const float share =
                findShare(_ring, (x - first.x + 0.5) / NewPartMask::PIXELS, (y - first.y + 0.5) / NewPartMask::PIXELS);
            if (share == 0.0f) continue;
            unsigned char* data = picture.data(static_cast<unsigned int>(x), static_cast<unsigned int>(y));
            for (std::size_t channel = 0; channel < 3; ++channel)
                data[channel] = static_cast<unsigned char>(
                    std::lround((1.0f - share) * data[channel] + share * static_cast<float>(color[channel])));
        }
}

} // namespace osgLego
