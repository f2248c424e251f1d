#pragma once

#include <string>

#include <osg/Image>
#include <osg/ref_ptr>

/** Read the first part of an image file with OpenImageIO. The image has one to four channels, each of 8 or 16 bits
 * unsigned or 32 bits float; further channels are dropped, and other types are converted to the nearest of these. The
 * first row is the bottom row, as in OSG.
 *
 * The header is checked before any memory is allocated.
 * @return null, with the reason in `error`, on failure. */
osg::ref_ptr<osg::Image> readWithOiio(const std::string& fileName, std::string& error);

/** Write an image with OpenImageIO, atomically, in the format of the file name's extension.
 * @return the reason for a failure; empty if the file is written. */
std::string writeWithOiio(const osg::Image& image, const std::string& fileName);
