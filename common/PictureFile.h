#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace osgLego
{

/** Write a picture atomically, in the format of the name's extension, as writeCompleteFile(): it is encoded in memory,
 * since the writers of several formats ignore a full disk.
 *
 * May be called from any thread.
 * @return the reason for a failure, after which an older file is unchanged; empty if the file is written. */
std::string writePictureFile(const std::string& fileName, const OIIO::ImageBuf& picture);

} // namespace osgLego
