#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace osgLego
{

/** The difference of a channel, 0 to 1, that a pixel may show without being off. */
constexpr double DEFAULT_THRESHOLD = 4.0 / 255.0;

/** Read a reference, of a size that the picture must have. Throws CaptureError. */
OIIO::ImageBuf readReference(const std::string& fileName, int width, int height);

/** How far a picture is from a reference, by OpenImageIO's compare. */
struct PictureDifference
{
    double mean = 0.0;
    double rootMeanSquare = 0.0;
    double largest = 0.0;
    int column = 0; //!< of the largest
    int row = 0;
    long long pixels = 0;      //!< off by more than the threshold
    double share = 0.0;        //!< of all pixels, likewise
    double glaringShare = 0.0; //!< off by more than 0.1

    /** Whether the difference is within the tolerance of compareWithReference(). */
    bool isTolerable() const;
};

/** Pictures are compared in their colours, multiplied by alpha, and in alpha where both have it.
 * @param threshold the largest difference of a channel, 0 to 1, with which a pixel is not off. */
PictureDifference measureDifference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference,
                                    double threshold = DEFAULT_THRESHOLD);

/** The difference, made five times as strong, as a picture of bytes. */
OIIO::ImageBuf createDifferencePicture(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference);

/** Compare a picture with a reference, print the figures, and write the difference, made five
 * times as strong, to `differenceName` if there is any. Throws CaptureError.
 *
 * The tolerance lets one software renderer's last bits differ from another's, and a few pixels at silhouettes, but not
 * one stud that has moved: 0.1 % of the pixels may be off by more than the threshold.
 * @return whether the difference is within the tolerance. */
bool compareWithReference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference, double threshold,
                          const std::string& differenceName);

} // namespace osgLego
