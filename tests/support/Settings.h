#pragma once

#include <osgLego/LegoSettings.h>

#include <string>

namespace osgLego::test
{

/** Parse settings, which changes `settings`. The test fails if the text is not valid. */
LegoSettings parseSettings(const std::string& text, LegoSettings settings = {});

} // namespace osgLego::test
