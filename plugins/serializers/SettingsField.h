#pragma once

#include <string>

#include <osgDB/InputStream>
#include <osgDB/OutputStream>

// The text of settings in a file of OSG's own formats, without white space: bytes other than letters, digits and
// ,=.:_/+- are stored as % and two hexadecimal digits, such as %20 for a space in the path of a palette.
//
// OSG's own text formats read white space only by InputStream::readWrappedString(), which doesn't return at the end of
// a truncated file.

void writeSettingsField(osgDB::OutputStream& stream, const std::string& text);

std::string readSettingsField(osgDB::InputStream& stream);
