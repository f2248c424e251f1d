#include <osgLego/LegoSettings.h>

#include <Settings.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

std::string errorOf(const std::string& text)
{
    LegoSettings settings;
    std::string error;
    EXPECT_FALSE(LegoSettings::parse(text, settings, error)) << text;
    EXPECT_EQ(settings, LegoSettings()) << "a failed parse changed the settings";
    return error;
}

TEST(LegoSettings, ANumberAloneIsTheResolution)
{
    EXPECT_EQ(test::parseSettings("128").grid.resolution, 128u);
}

TEST(LegoSettings, EveryKeyIsRead)
{
    const LegoSettings settings =
        test::parseSettings("resolution=32, proportions = plate,up=y,method=points,target=addressed,fbo=512,edge=0.5");
    EXPECT_EQ(settings.grid.resolution, 32u);
    EXPECT_EQ(settings.grid.proportions, Proportions::PLATE);
    EXPECT_EQ(settings.grid.upAxis, UpAxis::Y);
    EXPECT_EQ(settings.voxelization.method, VoxelizationMethod::POINTS);
    EXPECT_EQ(settings.getTarget(), VoxelizationTarget::ADDRESSED);
    EXPECT_EQ(settings.voxelization.fboSize, 512u);
    EXPECT_EQ(settings.getEdgeLimit(), 0.5);
    const LegoSettings parts =
        test::parseSettings("palette=a.csv,colors=6,dither=on,fill=shell,shell=3,parts=bricks,seed=7,effort=best,"
                            "connect=on,support=on,progress=0.25,show=load");
    EXPECT_EQ(parts.colors.palette, "a.csv");
    EXPECT_EQ(parts.colors.count, 6u);
    EXPECT_TRUE(parts.colors.dither);
    EXPECT_EQ(parts.parts.fill, Fill::SHELL);
    EXPECT_EQ(parts.parts.shell, 3u);
    EXPECT_EQ(parts.parts.set, PartSet::BRICKS);
    EXPECT_EQ(parts.parts.seed, 7u);
    EXPECT_EQ(parts.parts.effort, Effort::BEST);
    EXPECT_TRUE(parts.parts.connect);
    EXPECT_TRUE(parts.parts.support);
    EXPECT_EQ(parts.view.progress, 0.25);
    EXPECT_EQ(parts.view.show, Show::LOAD);
    const LegoSettings lattice = test::parseSettings("cell=0.25, origin = -1:2.5:1e-3 ,size=3:4:50");
    EXPECT_EQ(lattice.grid.cellPitch, 0.25);
    EXPECT_EQ(lattice.grid.origin, glm::dvec3(-1.0, 2.5, 1e-3));
    EXPECT_EQ(lattice.grid.size, glm::ivec3(3, 4, 50));
}

TEST(LegoSettings, PartsAreBricksInLdrawColorsUnlessTheTextSaysOtherwise)
{
    EXPECT_EQ(test::parseSettings("64,parts=bricks").grid.proportions, Proportions::BRICK);
    EXPECT_EQ(test::parseSettings("64,proportions=plate,parts=bricks").grid.proportions, Proportions::PLATE);
    EXPECT_EQ(test::parseSettings("64,parts=bricks,proportions=plate").grid.proportions, Proportions::PLATE);
    EXPECT_EQ(test::parseSettings("64,parts=none").grid.proportions, Proportions::CUBE);
    EXPECT_EQ(test::parseSettings("64,parts=bricks").getPalette(), "ldraw");
    EXPECT_EQ(test::parseSettings("64,parts=bricks,palette=none").getPalette(), "none");
    EXPECT_EQ(test::parseSettings("64").getPalette(), "none");
}

TEST(LegoSettings, PartsNeedTheCpuExactCellsAndRealProportions)
{
    EXPECT_EQ(errorOf("64,proportions=cube,parts=bricks"),
              "bad value 'cube' for proportions; expected brick or plate with parts");
    const std::string onlyOnCpu =
        "parts, and fill other than surface, are made on the CPU; expected method=exact, and device=auto or cpu";
    for (const char* text : {"64,parts=bricks,device=gpu", "64,parts=bricks,method=points", "64,fill=solid,device=gpu"})
        EXPECT_EQ(errorOf(text), onlyOnCpu) << text;
    EXPECT_EQ(test::parseSettings("64,fill=solid,device=cpu").needsCpu(), true);
    EXPECT_EQ(test::parseSettings("64,palette=ldraw,device=gpu").needsCpu(), false);
}

TEST(LegoSettings, AMethodHasItsOwnTargetAndEdgeLimit)
{
    EXPECT_EQ(test::parseSettings("64").getTarget(), VoxelizationTarget::ADDRESSED);
    EXPECT_EQ(test::parseSettings("64").getEdgeLimit(), 2.0);
    EXPECT_EQ(test::parseSettings("64,method=points,fbo=1024").getTarget(), VoxelizationTarget::PROJECTED);
    EXPECT_EQ(test::parseSettings("64,method=points").getEdgeLimit(), 1.0);
}

TEST(LegoSettings, TheTextFormRoundTrips)
{
    for (const char* text :
         {"64", "1", "1024,proportions=brick", "64,up=y,edge=0.0625", "64,look=plain", "64,device=cpu",
          "64,palette=ldraw,colors=12,dither=on",
          "32,proportions=plate,fill=shell,shell=4,parts=bricks,seed=9,effort=instant,connect=on,support=on",
          "32,drawing=splats,progress=0.5,show=load", "cell=0.1,origin=-1.5:0:1e+17,size=1:1024:2560,look=plain",
          "cell=2,up=y,anchor=world", "cell=1e-09,origin=0:0:0",
          "7,proportions=plate,up=y,method=points,target=addressed,fbo=16,edge=3.25,device=gpu,look=plain"})
    {
        EXPECT_EQ(test::parseSettings(text).toString(), text);
        EXPECT_EQ(test::parseSettings(test::parseSettings(text).toString()), test::parseSettings(text));
    }
}

TEST(LegoSettings, NamesOfPalettesRoundTripOrAreRefused)
{
    const auto withPalette = [](const std::string& name)
    {
        LegoSettings settings;
        settings.colors.palette = name;
        return settings;
    };
    for (const char* name : {"a b.csv", "/tmp/my  palette.csv", "a=b", "a\tb", "\"a\"", "up=y", "50%.csv", "a--b\\c"})
    {
        EXPECT_EQ(withPalette(name).check(), "") << name;
        EXPECT_EQ(test::parseSettings(withPalette(name).toString()), withPalette(name)) << name;
    }
    for (const char* name : {"", " a", "a ", "\ta", "a\r", "a\n", "a,b", "a(1).csv", "a)", "[a", "a]"})
        EXPECT_EQ(withPalette(name).check(),
                  "bad value '" + std::string(name) +
                      "' for palette; expected none, ldraw or the path of a file, without commas, brackets and "
                      "surrounding spaces");
}

TEST(LegoSettings, TheLookIsFullByDefault)
{
    EXPECT_EQ(test::parseSettings("64").view.look, Look::FULL);
    EXPECT_EQ(test::parseSettings("64,look=plain").view.look, Look::PLAIN);
    EXPECT_EQ(test::parseSettings("64,look=full").toString(), "64");
}

TEST(LegoSettings, BricksDependOnTheirSettingsButNotOnTheLook)
{
    const LegoSettings settings = test::parseSettings("32,method=points");
    EXPECT_TRUE(settings.givesSameBricks(settings));
    EXPECT_TRUE(settings.givesSameBricks(test::parseSettings("32,method=points,look=plain")));
    EXPECT_TRUE(settings.givesSameBricks(test::parseSettings("32,method=points,progress=0,show=load")));
    EXPECT_NE(settings, test::parseSettings("32,method=points,look=plain"));
    for (const char* other : {"33,method=points", "32", "32,method=points,up=y", "32,method=points,proportions=plate",
                              "32,method=points,target=addressed", "32,method=points,fbo=64", "32,method=points,edge=3",
                              "cell=1,method=points"})
    {
        EXPECT_FALSE(settings.givesSameBricks(test::parseSettings(other))) << other;
        EXPECT_FALSE(settings.givesSameBricks(test::parseSettings(std::string(other) + ",look=plain"))) << other;
    }
}

const SettingDescription& describe(const std::string& key)
{
    const SettingDescriptions& all = LegoSettings::describe();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& setting) { return setting.key == key; });
    return found == all.end() ? all.front() : *found;
}

TEST(LegoSettings, DescribesEachKindOfValues)
{
    EXPECT_EQ(describe("resolution"), (SettingDescription{"resolution", "grid", "<number>", "1 to 1024", "64",
                                                          "widths of a cell along the longest side of the model",
                                                          SettingType::WHOLE_NUMBER, SettingRange{1.0, 1024.0}}));
    EXPECT_EQ(describe("proportions").form, "cube|brick|plate");
    EXPECT_EQ(describe("proportions").values, "cube, brick, plate");
    EXPECT_EQ(describe("proportions").defaultValue, "cube");
    EXPECT_EQ(describe("proportions").type, SettingType::CHOICE);
    EXPECT_EQ(describe("origin").type, SettingType::THREE_NUMBERS);
    EXPECT_EQ(describe("size").form, "<w>:<d>:<h>");
    EXPECT_EQ(describe("size").type, SettingType::THREE_WHOLE_NUMBERS);
    EXPECT_EQ(describe("palette").form, "none|ldraw|<file>");
    EXPECT_EQ(describe("palette").type, SettingType::FILE);
    EXPECT_EQ(describe("dither").group, "colors");
    EXPECT_EQ(describe("dither").defaultValue, "off");
    EXPECT_EQ(describe("dither").type, SettingType::SWITCH);
    EXPECT_EQ(describe("progress").values, "0 to 1");
}

/** A valid value other than the default. */
std::string otherValue(const SettingDescription& setting)
{
    const std::string& values = setting.values;
    if (values.find(':') != std::string::npos) return "1:2:3";
    const auto to = values.find(" to ");
    const std::string first = values.substr(0, values.find_first_of(", "));
    if (first != setting.defaultValue) return first;
    const auto second = to == std::string::npos ? first.size() + 2 : to + 4;
    return values.substr(second, values.find_first_of(", ", second) - second);
}

TEST(LegoSettings, EveryKeyIsReadAndWrittenAndOnlyThoseOfTheViewKeepTheBricks)
{
    for (const SettingDescription& setting : LegoSettings::describe())
    {
        const std::string item = setting.key + "=" + otherValue(setting);
        bool isRead = false;
        // Some keys need others.
        for (const char* base : {"", "parts=bricks", "method=points", "cell=1", "cell=1,origin=0:0:0"})
        {
            LegoSettings before;
            std::string error;
            ASSERT_TRUE(std::string(base).empty() || LegoSettings::parse(base, before, error)) << error;
            LegoSettings after = before;
            isRead = LegoSettings::parse(item, after, error);
            if (!isRead) continue;
            EXPECT_NE(after, before) << item;
            EXPECT_NE(after.toString().find(setting.key == "resolution" ? otherValue(setting) : item),
                      std::string::npos)
                << after.toString();
            EXPECT_EQ(test::parseSettings(after.toString()), after) << item;
            EXPECT_EQ(after.givesSameBricks(before), setting.group == "view") << item;
            break;
        }
        EXPECT_TRUE(isRead) << item;
    }
}

TEST(LegoSettings, AbsentKeysKeepTheirValues)
{
    LegoSettings settings = test::parseSettings("32,up=y");
    std::string error;
    ASSERT_TRUE(LegoSettings::parse("proportions=brick", settings, error));
    EXPECT_EQ(settings.toString(), "32,proportions=brick,up=y");
}

TEST(LegoSettings, AResolutionReplacesCellsAndCellsReplaceAResolution)
{
    LegoSettings settings = test::parseSettings("32,up=y");
    std::string error;
    ASSERT_TRUE(LegoSettings::parse("cell=2,origin=1:2:3", settings, error));
    EXPECT_EQ(settings.toString(), "cell=2,origin=1:2:3,up=y");
    ASSERT_TRUE(LegoSettings::parse("size=4:5:6", settings, error));
    EXPECT_EQ(settings.toString(), "cell=2,origin=1:2:3,size=4:5:6,up=y");
    ASSERT_TRUE(LegoSettings::parse("32", settings, error));
    EXPECT_EQ(settings.toString(), "32,up=y");
}

TEST(LegoSettings, MistakesInTheGridAreReportedWithTheExpectedValues)
{
    const std::string expectedCell = " for cell; expected a number of model units, 1e-09 to 1e+12";
    for (const char* value : {"0", "nan", "inf", "-inf", "-1", "1e-19", "1e+19", "", "1 m", "0x10"})
        EXPECT_EQ(errorOf(std::string("cell=") + value), "bad value '" + std::string(value) + "'" + expectedCell);
    const std::string expectedOrigin = " for origin; expected x:y:z in model units, each -1e+18 to 1e+18";
    for (const char* value : {"nan:0:0", "0:inf:0", "0:0:-2e+18", "1:2", "1:2:3:4", "1::3", "", "a:b:c", "1:2:3m"})
        EXPECT_EQ(errorOf(std::string("cell=1,origin=") + value),
                  "bad value '" + std::string(value) + "'" + expectedOrigin);
    const std::string expectedSize =
        " for size; expected w:d:h in cells, each 1 to 1024, and up to 2560 along the up axis";
    for (const char* value :
         {"0:4:4", "4:-1:4", "1025:4:4", "4:1025:4", "4:4:2561", "4:4", "4", "1.5:4:4", "4:4:99999999999"})
        EXPECT_EQ(errorOf(std::string("cell=1,origin=0:0:0,size=") + value),
                  "bad value '" + std::string(value) + "'" + expectedSize);
    EXPECT_NE(errorOf("cell=1,origin=0:0:0,size=4:4:1025,up=y").find(expectedSize), std::string::npos);
    EXPECT_EQ(errorOf("origin=0:0:0"), "origin is given without cell; expected both");
    EXPECT_EQ(errorOf("cell=1,anchor=first"), "bad value 'first' for anchor; expected fit, model or world with cell");
    EXPECT_EQ(errorOf("cell=1,size=4:4:4"), "size is given without origin; expected both, and cell");
    for (const char* text : {"64,cell=1", "cell=1,64", "origin=0:0:0,64", "resolution=64,size=4:4:4"})
        EXPECT_EQ(errorOf(text), "a resolution can't be combined with cell, origin or size; expected either") << text;
    LegoSettings settings;
    settings.grid.resolution = 32;
    settings.grid.cellPitch = 1.0;
    EXPECT_EQ(settings.check(), "a resolution can't be combined with cell; expected either");
}

TEST(LegoSettings, MistakesAreReportedWithTheExpectedValues)
{
    std::string keys;
    for (const SettingDescription& setting : LegoSettings::describe())
        keys += (keys.empty() ? "" : ", ") + setting.key;
    EXPECT_EQ(errorOf("64,colour=red"), "unknown key 'colour'; the keys are " + keys);
    EXPECT_EQ(errorOf("0"), "bad value '0' for resolution; expected a whole number, 1 to 1024");
    EXPECT_EQ(errorOf("1025"), "bad value '1025' for resolution; expected a whole number, 1 to 1024");
    EXPECT_EQ(errorOf("99999999999"), "bad value '99999999999' for resolution; expected a whole number, 1 to 1024");
    EXPECT_EQ(errorOf("resolution=-5"), "bad value '-5' for resolution; expected a whole number, 1 to 1024");
    EXPECT_EQ(errorOf("proportions=tile"), "bad value 'tile' for proportions; expected cube, brick or plate");
    EXPECT_EQ(errorOf("up=x"), "bad value 'x' for up; expected y or z");
    EXPECT_EQ(errorOf("look=shiny"), "bad value 'shiny' for look; expected plain or full");
    EXPECT_EQ(errorOf("fbo=8"), "bad value '8' for fbo; expected a whole number of pixels, 16 to 8192");
    EXPECT_EQ(errorOf("edge=nan"), "bad value 'nan' for edge; expected a number of cells, 0.0625 to 4");
    EXPECT_EQ(errorOf("edge=5"), "bad value '5' for edge; expected a number of cells, 0.0625 to 4");
    EXPECT_EQ(errorOf("palette="),
              "bad value '' for palette; expected none, ldraw or the path of a file, without commas, brackets and "
              "surrounding spaces");
    EXPECT_EQ(errorOf("palette=ldraw,colors=0"), "bad value '0' for colors; expected a whole number, 1 to 255");
    EXPECT_EQ(errorOf("colors=256"), "bad value '256' for colors; expected a whole number, 1 to 255");
    EXPECT_EQ(errorOf("colors=6"), "colors is given without a palette; expected palette=ldraw or a file");
    EXPECT_EQ(errorOf("dither=on"), "dither is on without a palette; expected palette=ldraw or a file");
    EXPECT_EQ(errorOf("dither=yes"), "bad value 'yes' for dither; expected off or on");
    EXPECT_EQ(errorOf("fill=full"), "bad value 'full' for fill; expected surface, shell or solid");
    EXPECT_EQ(errorOf("shell=0"), "bad value '0' for shell; expected a whole number of cells, 1 to 1024");
    EXPECT_EQ(errorOf("parts=plates"), "bad value 'plates' for parts; expected none or bricks");
    EXPECT_EQ(errorOf("seed=-1"), "bad value '-1' for seed; expected a whole number, 0 to 4294967295");
    EXPECT_EQ(errorOf("connect=on"), "connect is on without parts; expected parts=bricks");
    EXPECT_EQ(errorOf("support=1"), "bad value '1' for support; expected off or on");
    EXPECT_EQ(errorOf("support=on"), "support is on without parts; expected parts=bricks");
    EXPECT_EQ(errorOf("progress=1.5"), "bad value '1.5' for progress; expected a number, 0 to 1");
    EXPECT_EQ(errorOf("progress=nan"), "bad value 'nan' for progress; expected a number, 0 to 1");
    EXPECT_EQ(errorOf("show=stress"), "bad value 'stress' for show; expected color or load");
    EXPECT_EQ(errorOf("effort=low"), "bad value 'low' for effort; expected instant, normal or best");
    EXPECT_EQ(errorOf("64,32"), "'resolution' is given twice");
    EXPECT_EQ(errorOf("target=projected"), "bad value 'projected' for target; expected addressed with method=exact");
    EXPECT_EQ(errorOf("method=points,device=cpu"),
              "bad value 'cpu' for device; expected auto or gpu with method=points");
    EXPECT_NE(errorOf("").find("is neither a resolution"), std::string::npos);
    EXPECT_NE(errorOf("64,").find("is neither a resolution"), std::string::npos);
    EXPECT_NE(errorOf("bunny").find("'bunny' is neither a resolution"), std::string::npos);
}

TEST(LegoSettings, AMissingCommaIsReportedWithTheTextAroundIt)
{
    EXPECT_EQ(errorOf("64up=y"), "a comma is missing before 'up=y' in '64up=y'; expected '64,up=y'");
    EXPECT_EQ(errorOf("64 up=y"), "a comma is missing before 'up=y' in '64 up=y'; expected '64,up=y'");
    EXPECT_EQ(errorOf("8,up=ymethod=points"),
              "a comma is missing before 'method=points' in 'up=ymethod=points'; expected 'up=y,method=points'");
    EXPECT_EQ(errorOf("backup=y").find("unknown key 'backup'"), 0u) << "no item ends before 'up'";
    EXPECT_EQ(errorOf("64up").find("'64up' is neither a resolution"), 0u) << "no item begins at 'up'";
}

TEST(LegoSettings, AStrayBracketIsReportedWithItsPosition)
{
    EXPECT_EQ(errorOf("(64,up=y"), "unexpected '(' as character 1 of '(64,up=y'; expected settings without brackets, "
                                   "such as 64,up=y");
    EXPECT_EQ(errorOf("64,up=y]").find("unexpected ']' as character 8 of '64,up=y]'"), 0u);
}

} // namespace

} // namespace osgLego
