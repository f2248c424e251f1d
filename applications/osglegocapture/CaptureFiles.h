#pragma once

#include <common/PartsList.h>
#include <osgLego/BrickModel.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

namespace osgLego
{

/** Throws CaptureError if a file can't be written. An empty name is ignored. */
void checkPlace(const std::string& fileName);

/** Likewise for a picture. Its extension must belong to a supported format, and a transparent picture needs a format in
 * which writePicture() can write alpha. */
void checkPicturePlace(const std::string& fileName, bool isTransparent);

/** Likewise for a parts list, which is .csv or .xml. */
void checkPartsListPlace(const std::string& fileName);

/** Throws CaptureError if two names refer to the same file. Empty names are ignored. */
void checkAreDistinct(const std::vector<std::string>& fileNames);

/** Write text. Throws CaptureError. */
void writeText(const std::string& fileName, const std::function<void(std::ostream&)>& write);

/** Write a picture in the format of its extension, rows from top to bottom. OpenEXR requires colours multiplied by
 * alpha, so straight alpha is converted for it. Throws CaptureError. */
void writePicture(const std::string& fileName, const OIIO::ImageBuf& picture);

/** Write a parts list in the format of its extension. Throws CaptureError. */
void writePartsList(const std::string& fileName, const PartsList& list);

/** Write a line `x,y,z,red,green,blue` for every brick. Throws CaptureError. */
void writeCells(const std::string& fileName, const BrickModel& model);

} // namespace osgLego
