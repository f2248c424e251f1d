#include "Settings.h"

#include <gtest/gtest.h>

namespace osgLego::test
{

LegoSettings parseSettings(const std::string& text, LegoSettings settings)
{
    std::string error;
    EXPECT_TRUE(LegoSettings::parse(text, settings, error)) << error;
    return settings;
}

} // namespace osgLego::test
