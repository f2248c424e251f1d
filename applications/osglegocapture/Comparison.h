#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace osgLego
{

/** Read a reference, of a size that the picture must have. Throws CaptureError. */
OIIO::ImageBuf readReference(const std::string& fileName, int width, int height);

/** Compare a picture with a reference by OpenImageIO's compare, print the figures, and write the difference, made five
 * times as strong, to `differenceName` if there is any. Throws CaptureError.
 *
 * The tolerance lets one software renderer's last bits differ from another's, and a few pixels at silhouettes, but not
 * one stud that has moved: 0.1 % of the pixels may be off by more than 4/255.
 * @return whether the difference is within the tolerance. */
bool compareWithReference(const OIIO::ImageBuf& picture, const OIIO::ImageBuf& reference,
                          const std::string& differenceName);

} // namespace osgLego
