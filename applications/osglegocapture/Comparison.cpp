#include "Comparison.h"

#include "CaptureFiles.h"
#include "ExitCode.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

namespace osgLego
{

namespace
{

constexpr float PIXEL_TOLERANCE = 4.0f / 255.0f + 1e-4f; // of 8-bit values: 4 steps pass, 5 do not
constexpr double SHARE_TOLERANCE = 0.001;
constexpr float GLARING = 0.1f;
constexpr float STRENGTH = 5.0f;

// A picture that was saved with alpha is compared in what both have.
OIIO::ImageBuf colorsOf(const OIIO::ImageBuf& picture)
{
    return OIIO::ImageBufAlgo::channels(picture, 3, {});
}

} // namespace

bool PictureDifference::isTolerable() const
{
    return share <= SHARE_TOLERANCE;
}

PictureDifference measureDifference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference)
{
    const OIIO::ImageBuf colors = colorsOf(reference);
    const auto result = OIIO::ImageBufAlgo::compare(picture, colors, PIXEL_TOLERANCE, PIXEL_TOLERANCE);
    const auto glaring = OIIO::ImageBufAlgo::compare(picture, colors, GLARING, GLARING);
    const auto pixels = static_cast<double>(picture.spec().image_pixels());
    PictureDifference difference;
    difference.mean = result.meanerror;
    difference.rootMeanSquare = result.rms_error;
    difference.largest = result.maxerror;
    difference.column = result.maxx;
    difference.row = result.maxy;
    difference.pixels = static_cast<long long>(result.nfail);
    difference.share = static_cast<double>(result.nfail) / pixels;
    difference.glaringShare = static_cast<double>(glaring.nfail) / pixels;
    return difference;
}

OIIO::ImageBuf createDifferencePicture(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference)
{
    OIIO::ImageBuf difference = OIIO::ImageBufAlgo::mul(OIIO::ImageBufAlgo::absdiff(picture, colorsOf(reference)),
                                                        OIIO::cspan<float>{STRENGTH, STRENGTH, STRENGTH});
    difference.set_write_format(OIIO::TypeDesc::UINT8);
    return difference;
}

OIIO::ImageBuf readReference(const std::string& fileName, int width, int height)
{
    OIIO::ImageBuf reference(fileName);
    if (!reference.read(0, 0, true, OIIO::TypeDesc::FLOAT))
        throw CaptureError(EXIT_BAD_INPUT, "can't read '" + fileName + "': " + reference.geterror());
    if (reference.spec().width != width || reference.spec().height != height)
        throw CaptureError(EXIT_BAD_INPUT,
                           fmt::format("'{}' has {} x {} pixels and the picture {} x {}; allowed: the "
                                       "same size, see --size",
                                       fileName, reference.spec().width, reference.spec().height, width, height));
    return reference;
}

bool compareWithReference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference,
                          const std::string& differenceName)
{
    const PictureDifference difference = measureDifference(picture, reference);
    const bool isAlike = difference.isTolerable();
    fmt::print("compared with {}: mean error {:.6f}, RMS error {:.6f}, largest error {:.6f} at {}, {}; {} pixels "
               "({:.4f} %) off by more than 4/255, allowed {:.1f} %: {}\n",
               reference.name(), difference.mean, difference.rootMeanSquare, difference.largest, difference.column,
               difference.row, difference.pixels, 100.0 * difference.share, 100.0 * SHARE_TOLERANCE,
               isAlike ? "alike" : "different");
    if (difference.largest > 0.0)
    {
        writePicture(differenceName, createDifferencePicture(picture, reference));
        fmt::print("the difference, {:.0f} times as strong: {}\n", static_cast<double>(STRENGTH), differenceName);
    }
    return isAlike;
}

} // namespace osgLego
