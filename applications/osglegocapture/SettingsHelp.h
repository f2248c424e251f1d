#pragma once

#include <osgLego/SettingDescription.h>

#include <string>

namespace osgLego
{

/** The keys of settings for a help text: one paragraph for each, of lines with at most 100 letters. */
std::string describeKeys(const SettingDescriptions& keys);

} // namespace osgLego
