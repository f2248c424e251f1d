#include <legolize/LegolizeOptions.h>

#include <gtest/gtest.h>

namespace
{

TEST(LegolizeOptions, SettingsAreTakenAndTheRestIsLeft)
{
    const LegolizeOptions options = LegolizeOptions::parse(
        "noRotation 64,proportions=plate  compressed edge=0.5 quality=3 occlusion=low probe=/a/b.c.exr");
    EXPECT_EQ(options.settings, "64,proportions=plate,edge=0.5,occlusion=low,probe=/a/b.c.exr");
    EXPECT_EQ(options.rest, "noRotation compressed quality=3");
    EXPECT_EQ(LegolizeOptions::parse("").settings, "");
    EXPECT_EQ(LegolizeOptions::parse("64up=y").settings, "64up=y") << "a missing comma is for the settings to refuse";
}

} // namespace
