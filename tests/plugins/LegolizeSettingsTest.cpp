#include <legolize/LegolizeSettings.h>

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
    EXPECT_EQ(settings.occlusion, LegolizeSettings::Occlusion::BY_LOOK);
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
        EXPECT_EQ(settings.getOcclusion()->quality, AmbientOcclusionQuality::LOW) << text;
        EXPECT_EQ(settings.probe, "a/my.park.exr") << text;
    }
}

TEST(LegolizeSettings, OcclusionAloneKeepsTheBricksSettings)
{
    const LegolizeSettings settings = parsed("occlusion=high", parsed("48,probe=sky.hdr"));
    EXPECT_EQ(settings.lego.toString(), "48");
    EXPECT_EQ(settings.probe, "sky.hdr");
    EXPECT_EQ(settings.getOcclusion()->quality, AmbientOcclusionQuality::HIGH);
}

TEST(LegolizeSettings, OcclusionIsMediumInTheFullLookAndOffInThePlainOneUnlessItIsAskedFor)
{
    EXPECT_EQ(parsed("64").getOcclusion()->quality, AmbientOcclusionQuality::MEDIUM);
    EXPECT_EQ(parsed("occlusion=medium").getOcclusion()->quality, AmbientOcclusionQuality::MEDIUM);
    EXPECT_FALSE(parsed("look=plain").getOcclusion());
    EXPECT_FALSE(parsed("occlusion=off").getOcclusion());
    EXPECT_EQ(parsed("look=plain,occlusion=low").getOcclusion()->quality, AmbientOcclusionQuality::LOW);
}

TEST(LegolizeSettings, SaysWhatWasExpected)
{
    EXPECT_EQ(errorOf("occlusion=best"), "bad value 'best' for occlusion; expected off, low, medium or high");
    EXPECT_EQ(errorOf("occlusion="), "bad value '' for occlusion; expected off, low, medium or high");
    EXPECT_NE(errorOf("64,probe=").find("expected the name of a high dynamic range picture"), std::string::npos);
    EXPECT_EQ(errorOf("occlusion=low,64,occlusion=low"), "'occlusion' is given twice");
    EXPECT_NE(errorOf("occlusion=low,2000").find("'2000' for resolution"), std::string::npos);
    for (const char* text : {"colour=red", "64,probe=a.exr,nonsense", "probe=my,park.exr", "occlusion=low,"})
        EXPECT_TRUE(errorOf(text).ends_with(", occlusion, distant, probe")) << errorOf(text);
    EXPECT_FALSE(errorOf("").empty());
}

} // namespace
