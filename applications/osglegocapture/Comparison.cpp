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
constexpr float STRENGTH = 5.0f;

} // namespace

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
    // A reference that was saved with alpha is compared in what both have.
    const OIIO::ImageBuf colors = OIIO::ImageBufAlgo::channels(reference, 3, {});
    const auto result = OIIO::ImageBufAlgo::compare(picture, colors, PIXEL_TOLERANCE, PIXEL_TOLERANCE);
    const double share = static_cast<double>(result.nfail) / static_cast<double>(picture.spec().image_pixels());
    const bool isAlike = share <= SHARE_TOLERANCE;
    fmt::print("compared with {}: mean error {:.6f}, RMS error {:.6f}, largest error {:.6f} at {}, {}; {} pixels "
               "({:.4f} %) off by more than 4/255, allowed {:.1f} %: {}\n",
               reference.name(), result.meanerror, result.rms_error, result.maxerror, result.maxx, result.maxy,
               result.nfail, 100.0 * share, 100.0 * SHARE_TOLERANCE, isAlike ? "alike" : "different");
    if (result.maxerror > 0.0)
    {
        const OIIO::ImageBuf difference = OIIO::ImageBufAlgo::mul(OIIO::ImageBufAlgo::absdiff(picture, colors),
                                                                  OIIO::cspan<float>{STRENGTH, STRENGTH, STRENGTH});
        OIIO::ImageBuf bytes = difference;
        bytes.set_write_format(OIIO::TypeDesc::UINT8);
        writePicture(differenceName, bytes);
        fmt::print("the difference, {:.0f} times as strong: {}\n", static_cast<double>(STRENGTH), differenceName);
    }
    return isAlike;
}

} // namespace osgLego
