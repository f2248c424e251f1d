#include <osgLego/occlusion/OcclusionNoise.h>

#include <cmath>
#include <utility>

#include <osg/Image>

namespace osgLego
{

namespace
{

constexpr int SIZE = 64;

/** The position of a pixel along the Hilbert curve through the square. */
int hilbertIndex(int x, int y)
{
    int index = 0;
    for (int side = SIZE / 2; side > 0; side /= 2)
    {
        const bool isRight = (x & side) != 0;
        const bool isUpper = (y & side) != 0;
        index += side * side * ((3 * static_cast<int>(isRight)) ^ static_cast<int>(isUpper));
        if (isUpper) continue;
        if (isRight)
        {
            x = SIZE - 1 - x;
            y = SIZE - 1 - y;
        }
        std::swap(x, y);
    }
    return index;
}

double fraction(double value)
{
    return value - std::floor(value);
}

} // namespace

osg::ref_ptr<osg::Texture2D> createOcclusionNoise()
{
    // The plastic number, on which the sequence is based (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom
    // Sequences").
    constexpr double PLASTIC_NUMBER = 1.32471795724474602596;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(SIZE, SIZE, 1, GL_RG, GL_FLOAT);
    for (int y = 0; y < SIZE; ++y)
        for (int x = 0; x < SIZE; ++x)
        {
            const int index = hilbertIndex(x, y);
            auto* numbers =
                reinterpret_cast<float*>(image->data(static_cast<unsigned int>(x), static_cast<unsigned int>(y)));
            numbers[0] = static_cast<float>(fraction(0.5 + index / PLASTIC_NUMBER));
            numbers[1] = static_cast<float>(fraction(0.5 + index / (PLASTIC_NUMBER * PLASTIC_NUMBER)));
        }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setInternalFormat(GL_RG16F);
    // Must be the texture's format: otherwise OSG allocates a reused texture a second time, which GL rejects.
    image->setInternalTextureFormat(GL_RG16F);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    // OSG's default does not exist in the core profile.
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

} // namespace osgLego
