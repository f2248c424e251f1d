#pragma once

#include <string>

#include <osgDB/InputStream>

/** Read the text of settings, which contains no white space, from one of OSG's own formats.
 *
 * Unlike InputStream::readWrappedString(), it returns at the end of a truncated file. */
std::string readSettingsField(osgDB::InputStream& stream);
