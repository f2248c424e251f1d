#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace osgLego
{

/** The default threshold: a pixel is off if a channel, 0 to 1, differs by more than this. */
constexpr double DEFAULT_THRESHOLD = 4.0 / 255.0;

/** Read a reference, which must have the given size. Throws CaptureError. */
OIIO::ImageBuf readReference(const std::string& fileName, int width, int height);

/** The difference between a picture and a reference, from OpenImageIO's compare. */
struct PictureDifference
{
    double mean = 0.0;
    double rootMeanSquare = 0.0;
    double largest = 0.0;
    int column = 0; //!< position of the largest difference
    int row = 0;
    long long pixels = 0; //!< number of pixels off by more than the threshold
    double share = 0.0;   //!< fraction of pixels off by more than the threshold
};

/** Compare the colours of two pictures, multiplied by alpha, and alpha if both have it.
 * @param threshold a pixel is off if a channel, 0 to 1, differs by more than this. */
PictureDifference measureDifference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference, double threshold);

/** The difference of two pictures, amplified five times, as a picture of bytes. */
OIIO::ImageBuf createDifferencePicture(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference);

/** Compare a picture with a reference and print the figures. If they differ, write the difference, amplified five
 * times, to `differenceName`. Throws CaptureError.
 *
 * 0.1 % of the pixels may be off by more than the threshold, and the mean error may be a quarter of the threshold. This
 * tolerates rounding differences between software renderers and a few pixels at silhouettes, but neither a single moved
 * stud nor a picture that is brighter as a whole.
 * @return whether the difference is within the tolerance. */
bool compareWithReference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference, double threshold,
                          const std::string& differenceName);

} // namespace osgLego
