#pragma once

#include <string>

#include <osgDB/InputStream>
#include <osgDB/OutputStream>

// Any number of bytes in a file of OSG's own formats: as they are in the binary format, otherwise in base64.
//
// Unlike OSG's arrays and strings, they can be read from a damaged file without allocating more memory than the file
// has bytes.

void writeBytesField(osgDB::OutputStream& stream, const std::string& bytes);

/** @return false if the bytes are incomplete or not base64. */
bool readBytesField(osgDB::InputStream& stream, std::string& bytes);
