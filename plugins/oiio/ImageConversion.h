#pragma once

#include <string>

#include <osg/Image>
#include <osg/ref_ptr>

/** Read an image by OpenImageIO: its first part, one to four channels, 8 or 16 bits unsigned or 32 bits float a
 * channel, whatever more the file has being brought to the nearest of these. The first row is the bottom one, as in
 * OSG.
 *
 * What a header claims is checked before any memory is taken.
 * @return null, with the reason in `error`. */
osg::ref_ptr<osg::Image> readWithOiio(const std::string& fileName, std::string& error);

/** Write an image by OpenImageIO, in the format of the name's extension, complete or not at all.
 * @return the reason why not; empty when it is written. */
std::string writeWithOiio(const osg::Image& image, const std::string& fileName);
