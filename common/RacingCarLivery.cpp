#include <common/RacingCarLivery.h>

#include <osgLego/data/SharedObjects.h>

#include <array>
#include <cmath>
#include <string_view>

#include <osg/Vec2d>
#include <osg/Vec3ub>

namespace osgLego
{

namespace
{

const osg::Vec3ub RED(203, 24, 29);
const osg::Vec3ub WHITE(245, 245, 240);
const osg::Vec3ub BLUE(18, 62, 140);
const osg::Vec3ub BLACK(24, 24, 26);
const osg::Vec3ub YELLOW(250, 200, 20);

constexpr std::array<std::string_view, 7> SEVEN{"#####", "    #", "   # ", "   # ", "  #  ", "  #  ", "  #  "};

using ColorAt = osg::Vec3ub(double, double);

osg::ref_ptr<osg::Image> createImage(int width, int height, ColorAt* colorAt)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
        {
            const osg::Vec3ub color = colorAt((column + 0.5) / width, (row + 0.5) / height);
            unsigned char* pixel = image->data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            for (unsigned int channel = 0; channel < 3; ++channel)
                pixel[channel] = color[channel];
        }
    return image;
}

/** Whether a point of a roundel of radius 1 lies on its number, which is legible from the front of the car. */
bool isOnNumber(const osg::Vec2d& point)
{
    const int column = static_cast<int>(std::floor((0.5 - point.y() / 1.1) * 5.0));
    const int row = static_cast<int>(std::floor((0.5 - point.x() / 1.4) * 7.0));
    if (column < 0 || column > 4 || row < 0 || row > 6) return false;
    return SEVEN[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#';
}

osg::Vec3ub liveryAt(double along, double across)
{
    constexpr double LENGTH_OVER_WIDTH = 4.4; // of the body; makes the roundels round
    const double fromMiddle = std::abs(across - 0.5);
    for (const double center : {0.27, 0.82})
    {
        const double radius = center < 0.5 ? 0.30 : 0.34;
        const osg::Vec2d point((along - center) * LENGTH_OVER_WIDTH / radius, (across - 0.5) / radius);
        if (point.length() < 1.0) return isOnNumber(point) ? BLACK : WHITE;
    }
    if (along < 0.045) return YELLOW;
    if (fromMiddle < 0.07) return WHITE;
    if (fromMiddle < 0.11) return BLUE;
    return RED;
}

osg::Vec3ub flagAt(double s, double t)
{
    const int square = static_cast<int>(s * 8.0) + static_cast<int>(t * 2.0);
    return square % 2 == 0 ? WHITE : BLACK;
}

/** The image of a function, which exists once as long as it is used. */
osg::ref_ptr<osg::Image> shareImage(int width, int height, ColorAt* colorAt)
{
    static SharedObjects<ColorAt*, osg::Image> images;
    return images.findOrCreate(colorAt, [=] { return createImage(width, height, colorAt); });
}

} // namespace

osg::ref_ptr<osg::Image> getRacingCarLivery()
{
    return shareImage(512, 256, liveryAt);
}

osg::ref_ptr<osg::Image> getChequeredFlag()
{
    return shareImage(64, 16, flagAt);
}

} // namespace osgLego
