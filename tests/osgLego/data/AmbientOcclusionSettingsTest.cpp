#include <osgLego/AmbientOcclusionSettings.h>

#include <limits>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

AmbientOcclusionSettings parseOcclusion(const std::string& text)
{
    AmbientOcclusionSettings settings;
    std::string error;
    EXPECT_TRUE(AmbientOcclusionSettings::parse(text, settings, error)) << text << ": " << error;
    return settings;
}

std::string occlusionErrorOf(const std::string& text)
{
    AmbientOcclusionSettings settings;
    std::string error;
    EXPECT_FALSE(AmbientOcclusionSettings::parse(text, settings, error)) << text;
    EXPECT_EQ(settings, AmbientOcclusionSettings()) << "a failed parse changed the settings";
    return error;
}

TEST(AmbientOcclusionSettings, AQualityNeedsNoKey)
{
    EXPECT_EQ(parseOcclusion("high").quality, AmbientOcclusionQuality::HIGH);
    EXPECT_EQ(parseOcclusion("low").quality, AmbientOcclusionQuality::LOW);
    EXPECT_EQ(parseOcclusion("quality=medium").quality, AmbientOcclusionQuality::MEDIUM);
}

TEST(AmbientOcclusionSettings, EveryKeyIsRead)
{
    const AmbientOcclusionSettings settings = parseOcclusion("quality = low, radius=0.5,distant=off,show=bent-normals");
    EXPECT_EQ(settings.quality, AmbientOcclusionQuality::LOW);
    EXPECT_EQ(settings.radius, 0.5);
    EXPECT_FALSE(settings.distant);
    EXPECT_EQ(settings.output, AmbientOcclusionOutput::BENT_NORMALS);
}

TEST(AmbientOcclusionSettings, ARadiusLeavesOutDistantBricks)
{
    EXPECT_TRUE(parseOcclusion("medium").hasDistant());
    EXPECT_FALSE(parseOcclusion("medium,distant=off").hasDistant());
    EXPECT_FALSE(parseOcclusion("medium,radius=2").hasDistant());
    EXPECT_FALSE(parseOcclusion("medium,radius=2,distant=on").hasDistant());
}

TEST(AmbientOcclusionSettings, TheTextFormRoundTrips)
{
    for (const char* text : {"low", "medium", "high", "medium,radius=0.125", "low,distant=off", "low,show=occlusion",
                             "high,radius=1e-05,show=bent-normals", "medium,show=irradiance", "medium,show=normals"})
    {
        EXPECT_EQ(parseOcclusion(text).toString(), text);
        EXPECT_EQ(parseOcclusion(parseOcclusion(text).toString()), parseOcclusion(text));
    }
    EXPECT_EQ(AmbientOcclusionSettings().toString(), "medium");
    EXPECT_EQ(parseOcclusion("medium,show=picture").toString(), "medium");
}

TEST(AmbientOcclusionSettings, AbsentKeysKeepTheirValues)
{
    AmbientOcclusionSettings settings = parseOcclusion("high,radius=2");
    std::string error;
    ASSERT_TRUE(AmbientOcclusionSettings::parse("show=normals", settings, error));
    EXPECT_EQ(settings.toString(), "high,radius=2,show=normals");
}

TEST(AmbientOcclusionSettings, MistakesAreReportedWithTheExpectedValues)
{
    EXPECT_EQ(occlusionErrorOf("quality=best"), "bad value 'best' for quality; expected low, medium or high");
    EXPECT_EQ(occlusionErrorOf("best"), "bad value 'best' for quality; expected low, medium or high");
    EXPECT_EQ(occlusionErrorOf("show=depth"),
              "bad value 'depth' for show; expected picture, occlusion, bent-normals, irradiance or normals");
    EXPECT_EQ(occlusionErrorOf("colour=red"), "unknown key 'colour'; the keys are quality, radius, distant, show");
    EXPECT_EQ(occlusionErrorOf("low,high"), "'quality' is given twice");
    EXPECT_NE(occlusionErrorOf("").find("is neither a quality"), std::string::npos);
    EXPECT_NE(occlusionErrorOf("low,").find("is neither a quality"), std::string::npos);
    EXPECT_EQ(occlusionErrorOf("high radius=2"), "a comma is missing before 'radius=2' in 'high radius=2'; expected "
                                                 "'high,radius=2'");
    for (const char* radius : {"0", "-1", "nan", "inf", "-inf", "two", "", "1x"})
        EXPECT_EQ(occlusionErrorOf(std::string("radius=") + radius),
                  std::string("bad value '") + radius +
                      "' for radius; expected a number above 0, in units of "
                      "the world");
}

TEST(AmbientOcclusionSettings, InvalidRadiiAreRefused)
{
    AmbientOcclusionSettings settings;
    EXPECT_TRUE(settings.check().empty());
    for (const double radius :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        settings.radius = radius;
        EXPECT_FALSE(settings.check().empty()) << radius;
    }
    settings.radius = std::numeric_limits<double>::min();
    EXPECT_TRUE(settings.check().empty());
}

} // namespace

} // namespace osgLego
