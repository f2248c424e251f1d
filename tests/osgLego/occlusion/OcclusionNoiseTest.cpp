#include <osgLego/occlusion/OcclusionNoise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <osg/Image>

namespace osgLego
{

namespace
{

constexpr int SIDE = 64;
constexpr int BINS = 64;

std::array<float, 2> numbersAt(const osg::Image& image, int column, int row)
{
    const auto* numbers = reinterpret_cast<const float*>(
        image.data(static_cast<unsigned int>(column % SIDE), static_cast<unsigned int>(row % SIDE)));
    return {numbers[0], numbers[1]};
}

TEST(OcclusionNoise, AllNumbersAreFromZeroToOneAndEvenlySpread)
{
    const osg::ref_ptr<osg::Texture2D> noise = createOcclusionNoise();
    const osg::Image& image = *noise->getImage();
    ASSERT_EQ(image.s(), SIDE);
    ASSERT_EQ(image.t(), SIDE);
    std::array<std::array<int, BINS>, 2> hits{};
    for (int row = 0; row < SIDE; ++row)
        for (int column = 0; column < SIDE; ++column)
            for (std::size_t index = 0; index < 2; ++index)
            {
                const float number = numbersAt(image, column, row)[index];
                ASSERT_GE(number, 0.0f);
                ASSERT_LT(number, 1.0f);
                ++hits[index][static_cast<std::size_t>(number * BINS)];
            }
    for (const auto& bins : hits)
    {
        const auto [fewest, most] = std::minmax_element(bins.begin(), bins.end());
        EXPECT_GT(*fewest, SIDE * SIDE / BINS / 1.5);
        EXPECT_LT(*most, SIDE * SIDE / BINS * 1.5);
    }
}

TEST(OcclusionNoise, SquaresOfFourPixelsHaveNumbersFarApart)
{
    const osg::ref_ptr<osg::Texture2D> noise = createOcclusionNoise();
    // The mean over 4 x 4 pixels, about the range of denoising, is near the mean of all pixels, 0.5; with independent
    // numbers its root mean square error would be 0.072.
    double squares = 0.0;
    for (int row = 0; row < SIDE; row += 4)
        for (int column = 0; column < SIDE; column += 4)
        {
            double sum = 0.0;
            for (int y = 0; y < 4; ++y)
                for (int x = 0; x < 4; ++x)
                    sum += static_cast<double>(numbersAt(*noise->getImage(), column + x, row + y)[0]);
            squares += (sum / 16.0 - 0.5) * (sum / 16.0 - 0.5);
        }
    EXPECT_LT(std::sqrt(squares / (SIDE / 4 * SIDE / 4)), 0.06);
}

TEST(OcclusionNoise, IsTheSameOnEveryRun)
{
    const osg::ref_ptr<osg::Texture2D> a = createOcclusionNoise();
    const osg::ref_ptr<osg::Texture2D> b = createOcclusionNoise();
    EXPECT_EQ(std::memcmp(a->getImage()->data(), b->getImage()->data(), a->getImage()->getTotalSizeInBytes()), 0);
}

} // namespace

} // namespace osgLego
