#include <legolize/LegolizeSettings.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace
{

using osgLego::AmbientOcclusionQuality;

LegolizeSettings parsed(const std::string& text, LegolizeSettings settings = {})
{
    std::string error;
    EXPECT_TRUE(LegolizeSettings::parse(text, settings, error)) << text << ": " << error;
    return settings;
}

/** The error message for a text, which must not change any setting. */
std::string errorOf(const std::string& text)
{
    LegolizeSettings settings;
    settings.probe = "before";
    std::string error;
    EXPECT_FALSE(LegolizeSettings::parse(text, settings, error)) << text;
    EXPECT_EQ(settings.probe, "before");
    EXPECT_FALSE(settings.occlusion);
    EXPECT_EQ(settings.lego, osgLego::LegoSettings());
    return error;
}

TEST(LegolizeSettings, OcclusionAndProbeMayStandAnywhereAmongTheBricksSettings)
{
    for (const char* text : {"32,occlusion=low,probe=a/my.park.exr,up=y", "occlusion=low,32,up=y,probe=a/my.park.exr",
                             " probe = a/my.park.exr , 32, up=y, occlusion = low "})
    {
        const LegolizeSettings settings = parsed(text);
        EXPECT_EQ(settings.lego.toString(), "32,up=y") << text;
        EXPECT_EQ(settings.getScene()->quality, AmbientOcclusionQuality::LOW) << text;
        EXPECT_EQ(settings.probe, "a/my.park.exr") << text;
    }
}

TEST(LegolizeSettings, OcclusionAloneKeepsTheBricksSettings)
{
    const LegolizeSettings settings = parsed("occlusion=high", parsed("48,probe=sky.hdr"));
    EXPECT_EQ(settings.lego.toString(), "48");
    EXPECT_EQ(settings.probe, "sky.hdr");
    EXPECT_EQ(settings.getScene()->quality, AmbientOcclusionQuality::HIGH);
}

TEST(LegolizeSettings, OcclusionIsOneOfFourKinds)
{
    using osgLego::BrickOcclusion;
    EXPECT_EQ(parsed("64").getOcclusion(), BrickOcclusion::GRID);
    EXPECT_EQ(parsed("occlusion=grid").getOcclusion(), BrickOcclusion::GRID);
    EXPECT_EQ(parsed("occlusion=both").getOcclusion(), BrickOcclusion::BOTH);
    EXPECT_EQ(parsed("occlusion=off").getOcclusion(), BrickOcclusion::OFF);
    for (const char* quality : {"screen", "low", "medium", "high"})
        EXPECT_EQ(parsed(std::string("occlusion=") + quality).getOcclusion(), BrickOcclusion::SCREEN) << quality;
}

TEST(LegolizeSettings, OnlyOcclusionInThePictureTakesAScene)
{
    for (const char* without : {"64", "look=plain", "occlusion=grid", "occlusion=off"})
        EXPECT_FALSE(parsed(without).getScene()) << without;
    for (const char* medium : {"occlusion=screen", "occlusion=both", "occlusion=medium"})
        EXPECT_EQ(parsed(medium).getScene()->quality, AmbientOcclusionQuality::MEDIUM) << medium;
    EXPECT_EQ(parsed("look=plain,occlusion=low").getScene()->quality, AmbientOcclusionQuality::LOW);
}

TEST(LegolizeSettings, DescribesTheKeysOfBricksAndThenItsOwn)
{
    const osgLego::SettingDescriptions& all = LegolizeSettings::describe();
    const osgLego::SettingDescriptions& ofBricks = osgLego::LegoSettings::describe();
    ASSERT_EQ(all.size(), ofBricks.size() + 3);
    EXPECT_TRUE(std::equal(ofBricks.begin(), ofBricks.end(), all.begin()));
    EXPECT_EQ(all.back().key, "probe");
}

TEST(LegolizeSettings, SaysWhatWasExpected)
{
    EXPECT_EQ(errorOf("occlusion=best"),
              "bad value 'best' for occlusion; expected off, grid, screen, both, low, medium or high");
    EXPECT_EQ(errorOf("occlusion="),
              "bad value '' for occlusion; expected off, grid, screen, both, low, medium or high");
    EXPECT_EQ(errorOf("64,probe="),
              "bad value '' for probe; expected the name of a high dynamic range picture, without commas");
    EXPECT_EQ(errorOf("distant=yes"), "bad value 'yes' for distant; expected off or on");
    EXPECT_EQ(errorOf("64up=y,occlusion=low"), "a comma is missing before 'up=y' in '64up=y'; expected '64,up=y'");
    EXPECT_EQ(errorOf("occlusion=low,8,up=ymethod=points"),
              "a comma is missing before 'method=points' in 'up=ymethod=points'; expected 'up=y,method=points'");
    EXPECT_EQ(errorOf("64occlusion=low"),
              "a comma is missing before 'occlusion=low' in '64occlusion=low'; expected '64,occlusion=low'");
    EXPECT_EQ(errorOf("occlusion=low,64,occlusion=low"), "'occlusion' is given twice");
    EXPECT_NE(errorOf("occlusion=low,2000").find("'2000' for resolution"), std::string::npos);
    for (const char* text : {"colour=red", "64,probe=a.exr,nonsense", "probe=my,park.exr", "occlusion=low,"})
        EXPECT_TRUE(errorOf(text).ends_with(", occlusion, distant, probe")) << errorOf(text);
    EXPECT_FALSE(errorOf("").empty());
}

} // namespace
