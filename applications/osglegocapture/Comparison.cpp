#include "Comparison.h"

#include "CaptureFiles.h"
#include "ExitCode.h"

#include <common/PictureBuffer.h>
#include <common/ReadableFile.h>

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

namespace osgLego
{

namespace
{

constexpr float SLACK = 1e-4f; // of 8-bit values: 4 steps pass, 5 do not
constexpr double SHARE_TOLERANCE = 0.001;
constexpr double MEAN_TOLERANCE = 0.25; // of the threshold
constexpr float STRENGTH = 5.0f;

bool hasAlpha(const OIIO::ImageBuf& picture)
{
    return picture.spec().alpha_channel == 3;
}

/** The channels to compare in two pictures. */
OIIO::ImageBuf comparedChannels(const OIIO::ImageBuf& picture, bool withAlpha)
{
    return OIIO::ImageBufAlgo::channels(toMultiplied(picture), withAlpha ? 4 : 3, {});
}

} // namespace

PictureDifference measureDifference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference, double threshold)
{
    const bool withAlpha = hasAlpha(picture) && hasAlpha(reference);
    const OIIO::ImageBuf channels = comparedChannels(picture, withAlpha);
    const OIIO::ImageBuf expected = comparedChannels(reference, withAlpha);
    const float tolerance = static_cast<float>(threshold) + SLACK;
    const auto result = OIIO::ImageBufAlgo::compare(channels, expected, tolerance, tolerance);
    const auto pixels = static_cast<double>(picture.spec().image_pixels());
    PictureDifference difference;
    difference.mean = result.meanerror;
    difference.rootMeanSquare = result.rms_error;
    difference.largest = result.maxerror;
    difference.column = result.maxx;
    difference.row = result.maxy;
    difference.pixels = static_cast<long long>(result.nfail);
    difference.share = static_cast<double>(result.nfail) / pixels;
    return difference;
}

OIIO::ImageBuf createDifferencePicture(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference)
{
    const bool withAlpha = hasAlpha(picture) && hasAlpha(reference);
    OIIO::ImageBuf difference =
        OIIO::ImageBufAlgo::absdiff(comparedChannels(picture, withAlpha), comparedChannels(reference, withAlpha));
    if (withAlpha)
    {
        // A difference in alpha only is shown as the difference of the pictures over white.
        const OIIO::ImageBuf alpha = OIIO::ImageBufAlgo::channels(difference, 3, {3, 3, 3});
        difference = OIIO::ImageBufAlgo::add(OIIO::ImageBufAlgo::channels(difference, 3, {}), alpha);
    }
    difference = OIIO::ImageBufAlgo::mul(difference, OIIO::cspan<float>{STRENGTH, STRENGTH, STRENGTH});
    difference.set_write_format(OIIO::TypeDesc::UINT8);
    return difference;
}

OIIO::ImageBuf readReference(const std::string& fileName, int width, int height)
{
    if (const std::string obstacle = findObstacleToReading(fileName); !obstacle.empty())
        throw CaptureError(EXIT_BAD_INPUT, "can't read '" + fileName + "': " + obstacle);
    // Multiplying 8-bit colours by alpha would lose the precision that the comparison needs.
    OIIO::ImageSpec asItIs;
    asItIs.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf reference(fileName, 0, 0, nullptr, &asItIs);
    if (!reference.read(0, 0, true, OIIO::TypeDesc::FLOAT))
        throw CaptureError(EXIT_BAD_INPUT, "can't read '" + fileName + "': " + reference.geterror());
    if (reference.spec().width != width || reference.spec().height != height)
        throw CaptureError(EXIT_BAD_INPUT,
                           fmt::format("'{}' has {} x {} pixels and the picture {} x {}; expected the "
                                       "same size, see --size",
                                       fileName, reference.spec().width, reference.spec().height, width, height));
    return reference;
}

bool compareWithReference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference, double threshold,
                          const std::string& differenceName)
{
    const PictureDifference difference = measureDifference(picture, reference, threshold);
    const double mostMean = MEAN_TOLERANCE * threshold + static_cast<double>(SLACK);
    const bool isAlike = difference.share <= SHARE_TOLERANCE && difference.mean <= mostMean;
    fmt::print("compared with {}: mean error {:.6f}, at most {:.6f} expected; RMS error {:.6f}, largest error {:.6f} "
               "at {}, {}; {} pixels "
               "({:.4f} %) off by more than {:.4g}, at most {:.1f} % expected: {}\n",
               reference.name(), difference.mean, mostMean, difference.rootMeanSquare, difference.largest,
               difference.column, difference.row, difference.pixels, 100.0 * difference.share, threshold,
               100.0 * SHARE_TOLERANCE, isAlike ? "alike" : "different");
    if (difference.largest > 0.0)
    {
        writePicture(differenceName, createDifferencePicture(picture, reference));
        fmt::print("the difference, {:.0f} times as strong: {}\n", static_cast<double>(STRENGTH), differenceName);
    }
    return isAlike;
}

} // namespace osgLego
