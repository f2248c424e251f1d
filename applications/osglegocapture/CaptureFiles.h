#pragma once

#include <osgLego/BrickModel.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <osg/Image>

namespace osgLego
{

/** Throws CaptureError when a file can't be written where it should be. An empty name is fine. */
void checkPlace(const std::string& fileName);

/** Likewise of a picture, whose extension must be that of a format too, and of one that writePicture() can write alpha
 * in when the picture is transparent. */
void checkPicturePlace(const std::string& fileName, bool isTransparent);

/** Throws CaptureError when two of some files are one and the same. Empty names are fine. */
void checkAreDistinct(const std::vector<std::string>& fileNames);

/** Write text. Throws CaptureError. */
void writeText(const std::string& fileName, const std::function<void(std::ostream&)>& write);

/** Write a picture in the format of its extension, its rows from the top down. Colours that are not multiplied by alpha
 * are multiplied by it for OpenEXR, which wants them so. Throws CaptureError. */
void writePicture(const std::string& fileName, const OIIO::ImageBuf& picture);

/** A picture drawn by OSG, RGB or RGBA of 8 bits, as OpenImageIO holds it: first row on top, and colours that are not
 * multiplied by alpha marked as such. */
OIIO::ImageBuf toImageBuf(const osg::Image& image);

/** Whether the colours of a picture wait to be multiplied by its alpha. */
bool hasStraightAlpha(const OIIO::ImageBuf& picture);

/** A picture with colours multiplied by alpha, in floats if they were not. */
OIIO::ImageBuf toMultiplied(const OIIO::ImageBuf& picture);

/** Write `x,y,z,red,green,blue`, a line for every brick. Throws CaptureError. */
void writeCells(const std::string& fileName, const BrickModel& model);

} // namespace osgLego
