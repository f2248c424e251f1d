#include <osgLego/LegoSettings.h>
#include <osgLego/Palette.h>
#include <osgLego/palette/KnownColors.h>

#include <TemporaryFolder.h>

#include <fstream>

#include <unistd.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

constexpr const char* HEADER = "code,name,rgb,edge,bricklink,bricks,plates\n";
constexpr const char* BLACK = "0,Black,#1B2A34,#808080,11,11111111111,11111111111\n";
constexpr const char* SALMON = "12,Salmon,#F06D61,#333333,,00000000100,10000000001\n";

class PaletteFile : public test::TemporaryFolderTest
{
protected:
    std::string write(const std::string& name, const std::string& text) const
    {
        std::ofstream(pathOf(name), std::ios::binary) << text;
        return pathOf(name);
    }

    osg::ref_ptr<const Palette> read(const std::string& name, const std::string& text) const
    {
        std::string error;
        const osg::ref_ptr<const Palette> palette = Palette::read(write(name, text), error);
        EXPECT_TRUE(palette) << error;
        EXPECT_EQ(error, "");
        return palette;
    }

    /** The error for a file, without the file's path at its beginning. */
    std::string errorOf(const std::string& name) const
    {
        std::string error;
        EXPECT_FALSE(Palette::read(pathOf(name), error));
        EXPECT_EQ(error.find(pathOf(name)), 0u) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        return error.substr(std::min(error.size(), pathOf(name).size()));
    }

    std::string errorOf(const std::string& name, const std::string& text) const
    {
        write(name, text);
        return errorOf(name);
    }

    std::string row(const std::string& code, const std::string& name, const std::string& color) const
    {
        return code + "," + name + "," + color + ",#333333,,11111111111,11111111111\n";
    }
};

TEST_F(PaletteFile, ReadsTheColumnsOfATable)
{
    const osg::ref_ptr<const Palette> palette = read("a.csv", std::string(HEADER) + BLACK + SALMON);
    ASSERT_TRUE(palette);
    ASSERT_EQ(palette->getColors().size(), 2u);
    const PaletteColor& black = palette->getColors()[0];
    EXPECT_EQ(black.code, 0);
    EXPECT_EQ(black.name, "Black");
    EXPECT_EQ(black.color, (Color{0x1b, 0x2a, 0x34}));
    EXPECT_EQ(black.brickLink, 11);
    EXPECT_EQ(black.bricks, PaletteColor::ALL_SIZES);
    const PaletteColor& salmon = palette->getColors()[1];
    EXPECT_EQ(salmon.brickLink, -1);
    EXPECT_EQ(salmon.bricks, 1u << 8); // 2x4
    EXPECT_EQ(salmon.plates, 1u | 1u << 10);
}

TEST_F(PaletteFile, AcceptsByteOrderMarkCarriageReturnsSpacesCommentsAndAMissingLastLineEnd)
{
    const osg::ref_ptr<const Palette> palette =
        read("a.CSV", "\xef\xbb\xbf# My colours\r\ncode,\tname, rgb,edge,bricklink,bricks,plates\r\n\r\n"
                      " 4 ,\tRed\t, #b40000,#333333, 5,11111111111,11111111111 \r\n#end\r\n"
                      "14,Yellow,#FAC80A,#333333,3,11111111111,11111111111");
    ASSERT_TRUE(palette);
    ASSERT_EQ(palette->getColors().size(), 2u);
    EXPECT_EQ(palette->getColors()[0].name, "Red");
    EXPECT_EQ(palette->getColors()[0].color, (Color{0xb4, 0, 0}));
    EXPECT_EQ(palette->getColors()[1].plates, PaletteColor::ALL_SIZES);
}

TEST_F(PaletteFile, ReadsItsOwnData)
{
    std::string error;
    const osg::ref_ptr<const Palette> palette =
        Palette::read(OSGLEGO_SOURCE_FOLDER "/data/ldraw-solid-colours.csv", error);
    ASSERT_TRUE(palette) << error;
    EXPECT_EQ(palette->getColors().size(), getKnownColors().size());
    EXPECT_EQ(palette->getColors().size(), 73u);
}

TEST_F(PaletteFile, NamesTheBadLineOfATableAndTheExpectedValue)
{
    const std::string head = std::string(HEADER) + BLACK + "# a comment\n";
    const std::string sizes = "11 digits 0 or 1 as ";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"1,Blue,#1E5AA8,#333333,7,11111111111", "the fields code,name,rgb,edge,bricklink,bricks,plates"},
        {row("1", "Blue", "#1E5AA8,7"), "the fields code,name,rgb,edge,bricklink,bricks,plates"},
        {row("nan", "Blue", "#1E5AA8"), "a code of LDraw from 0 to 2147483647 except 16 and 24, found 'nan'"},
        {row("-1", "Blue", "#1E5AA8"), "a code of LDraw from 0 to 2147483647 except 16 and 24, found '-1'"},
        {row("1e3", "Blue", "#1E5AA8"), "a code of LDraw from 0 to 2147483647 except 16 and 24, found '1e3'"},
        {row("2147483648", "Blue", "#1E5AA8"), "a code of LDraw from 0 to 2147483647 except 16 and 24"},
        {row("16", "Main", "#1E5AA8"), "a code of LDraw from 0 to 2147483647 except 16 and 24, found '16'"},
        {row("", "Blue", "#1E5AA8"), "a code of LDraw from 0 to 2147483647 except 16 and 24, found ''"},
        {row("0", "Blue", "#1E5AA8"), "a code that is not in a line above, found '0'"},
        {row("1", "", "#1E5AA8"), "a name of 1 to 100 bytes"},
        {row("1", "\"Blue\"", "#1E5AA8"), "a name of 1 to 100 bytes"},
        {row("1", "Bl\x1bue", "#1E5AA8"), "a name of 1 to 100 bytes without quotation marks, commas and control "
                                          "characters, found 'Bl?ue'"},
        {row("1", std::string(101, 'B'), "#1E5AA8"), "a name of 1 to 100 bytes"},
        {row("1", "Blue", "1E5AA8"), "#RRGGBB as rgb, found '1E5AA8'"},
        {row("1", "Blue", "11E5AA8"), "#RRGGBB as rgb, found '11E5AA8'"},
        {row("1", "Blue", "#1E5AA"), "#RRGGBB as rgb"},
        {row("1", "Blue", "#1E5AA8F"), "#RRGGBB as rgb"},
        {row("1", "Blue", "#1E5AG8"), "#RRGGBB as rgb"},
        {row("1", "Blue", "#-E5AA8"), "#RRGGBB as rgb"},
        {row("1", "Blue", ""), "#RRGGBB as rgb, found ''"},
        {"1,Blue,#1E5AA8,333333,7,11111111111,11111111111", "#RRGGBB as edge, found '333333'"},
        {"1,Blue,#1E5AA8,#333333,inf,11111111111,11111111111",
         "a number of BrickLink from 1 to 2147483647, or nothing"},
        {"1,Blue,#1E5AA8,#333333,0,11111111111,11111111111", "a number of BrickLink from 1 to 2147483647, or nothing"},
        {"1,Blue,#1E5AA8,#333333,7,1111111111,11111111111", sizes + "bricks, found '1111111111'"},
        {"1,Blue,#1E5AA8,#333333,7,11111111111,11111111112", sizes + "plates, found '11111111112'"},
        {std::string(1 << 20, 'x'), "at most 1000 bytes, found 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...'"},
        {"#" + std::string(1 << 20, 'x'), "at most 1000 bytes"}};
    for (const auto& [line, expected] : cases)
        EXPECT_EQ(errorOf("bad.csv", head + line).find(", line 4: expected " + expected), 0u)
            << errorOf("bad.csv") << "\nfor " << line.substr(0, 100);
}

TEST_F(PaletteFile, ATableNeedsItsHeaderAndAColour)
{
    EXPECT_EQ(errorOf("a.csv", BLACK).find(", line 1: expected code,name,rgb,edge,bricklink,bricks,plates, found "),
              0u);
    const std::string expected =
        ": expected code,name,rgb,edge,bricklink,bricks,plates and at least one line with a colour";
    for (const std::string& text :
         {std::string(), std::string(HEADER), std::string("\n\n#\n"), std::string("\xef\xbb\xbf")})
        EXPECT_EQ(errorOf("a.csv", text), expected) << text;
}

TEST_F(PaletteFile, ATableHasAtMost255Colours)
{
    std::string text = HEADER;
    for (int code = 100; code < 355; ++code)
        text += row(std::to_string(code), "Colour", "#1E5AA8");
    const osg::ref_ptr<const Palette> palette = read("a.csv", text);
    ASSERT_TRUE(palette);
    EXPECT_EQ(palette->getColors().size(), 255u);
    EXPECT_EQ(errorOf("a.csv", text + row("355", "Last", "#1E5AA8")),
              ", line 257: expected at most 255 colours, found 'Last'");
}

TEST_F(PaletteFile, ReadsTheSolidColoursOfAConfiguration)
{
    const osg::ref_ptr<const Palette> palette =
        read("LDConfig.ldr",
             "\xef\xbb\xbf"
             "0 LDraw.org Configuration File\r\n\r\n0 // LDraw Solid Colours\r\n"
             "0 !COLOUR Red\tCODE   4   VALUE #b40000   EDGE #333333\r\n"
             "0 !COLOUR Main_Colour CODE 16 VALUE #FFFF80 EDGE #333333\r\n"
             "0 !COLOUR Edge_Colour CODE 24 VALUE #7F7F7F EDGE #333333\r\n"
             "  0 !COLOUR Dark_Tan CODE 28 VALUE #897D62 EDGE #333333  \r\n"
             "0 !COLOUR Trans_Red CODE 36 VALUE #C91A09 EDGE #880000 ALPHA 128\r\n"
             "0 !COLOUR Glow CODE 329 VALUE #F5F3D7 EDGE #E0DA85 LUMINANCE 15\r\n"
             "0 !COLOUR Chrome_Gold CODE 334 VALUE #DFC176 EDGE #C2982E CHROME\r\n"
             "0 !COLOUR Pearl CODE 297 VALUE #AA7F2E EDGE #805F22 PEARLESCENT\r\n"
             "0 !COLOUR Rubber_Red CODE 324 VALUE #B40000 EDGE #333333 RUBBER\r\n"
             "0 !COLOUR Matte CODE 83 VALUE #0A1327 EDGE #333333 MATTE_METALLIC\r\n"
             "0 !COLOUR Metallic CODE 80 VALUE #767676 EDGE #333333 METAL\r\n"
             "0 !COLOUR Speckle CODE 132 VALUE #000000 EDGE #898788 MATERIAL SPECKLE VALUE #898788 FRACTION 0.4\r\n"
             "0 !COLOUR New CODE 100001 VALUE #010203 EDGE #333333");
    ASSERT_TRUE(palette);
    ASSERT_EQ(palette->getColors().size(), 3u);
    const auto colors = palette->getColors();
    EXPECT_EQ(colors[0].name, "Red");
    EXPECT_EQ(colors[0].color, (Color{0xb4, 0, 0}));
    EXPECT_EQ(colors[0].brickLink, 5);
    // The sizes of known colours are those of the table; others are assumed to exist in all sizes.
    EXPECT_EQ(colors[1].bricks, PaletteColor::ALL_SIZES & ~(1u << 10));
    EXPECT_EQ(colors[2].code, 100001);
    EXPECT_EQ(colors[2].brickLink, -1);
    EXPECT_EQ(colors[2].bricks, PaletteColor::ALL_SIZES);
    EXPECT_EQ(colors[2].plates, PaletteColor::ALL_SIZES);
}

TEST_F(PaletteFile, BlackOfAConfigurationHasTheColourOfThePlastic)
{
    const osg::ref_ptr<const Palette> palette =
        read("LDConfig.ldr", "0 !COLOUR Black CODE 0 VALUE #1B2A34 EDGE #808080\n"
                             "0 !COLOUR Blue CODE 1 VALUE #1E5AA9 EDGE #333333\n");
    ASSERT_TRUE(palette);
    EXPECT_EQ(palette->getColors()[0].code, 0);
    EXPECT_EQ(palette->getColors()[0].color, (Color{0x21, 0x21, 0x21}));
    EXPECT_EQ(palette->getColors()[1].color, (Color{0x1e, 0x5a, 0xa9}));
}

TEST_F(PaletteFile, NamesTheBadLineOfAConfiguration)
{
    const std::string head = "0 LDraw.org Configuration File\n0 !COLOUR Red CODE 4 VALUE #B40000 EDGE #333333\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"0 !COLOUR", "a name of 1 to 100 bytes"},
        {"0 !COLOUR Blue", "a code of LDraw from 0 to 2147483647 except 16 and 24, found ''"},
        {"0 !COLOUR Blue CODE", "a code of LDraw from 0 to 2147483647 except 16 and 24, found ''"},
        {"0 !COLOUR Blue CODE nan VALUE #1E5AA8", "a code of LDraw from 0 to 2147483647 except 16 and 24, found 'nan'"},
        {"0 !COLOUR Blue CODE 1 VALUE", "#RRGGBB as VALUE, found ''"},
        {"0 !COLOUR Blue CODE 1 VALUE #1E5A", "#RRGGBB as VALUE, found '#1E5A'"},
        {"0 !COLOUR Blue CODE 4 VALUE #1E5AA8", "a code that is not in a line above, found '4'"},
        {"0 " + std::string(1 << 20, 'x'), "at most 1000 bytes"}};
    for (const auto& [line, expected] : cases)
        EXPECT_EQ(errorOf("bad.ldr", head + line).find(", line 3: expected " + expected), 0u) << errorOf("bad.ldr");
    for (const char* text : {"", "1 4 0 0 0 1 0 0 0 1 0 0 0 1 3005.dat\n", "0 !COLOUR Main CODE 16 VALUE #FFFF80\n"})
        EXPECT_EQ(errorOf("a.ldr", text),
                  ": expected at least one line with a solid colour, such as '0 !COLOUR Black CODE 0 "
                  "VALUE #1B2A34 EDGE #808080'");
}

TEST_F(PaletteFile, RefusesFoldersMissingAndHugeFiles)
{
    std::filesystem::create_directory(pathOf("folder.csv"));
    EXPECT_EQ(errorOf("folder.csv"), " is not a file; expected a palette in a .csv or .ldr file");
    EXPECT_EQ(errorOf("missing.csv"), ": the palette can't be read: No such file or directory");
    write("huge.csv", HEADER);
    std::filesystem::resize_file(pathOf("huge.csv"), std::uintmax_t(1) << 40);
    EXPECT_EQ(errorOf("huge.csv"), ": the palette has 1099511627776 bytes; expected at most 4194304");
}

TEST_F(PaletteFile, RefusesFilesThatMayNotBeRead)
{
    if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
    write("secret.csv", std::string(HEADER) + BLACK);
    std::filesystem::permissions(pathOf("secret.csv"), std::filesystem::perms::none);
    EXPECT_EQ(errorOf("secret.csv"), ": the palette can't be read: Permission denied");
}

TEST_F(PaletteFile, RefusesOtherNames)
{
    for (const std::string name : {"none", "LDRAW", "", "colours.txt", "a.csv.gz"})
    {
        std::string error;
        EXPECT_FALSE(Palette::read(name, error));
        EXPECT_EQ(error, "unknown palette '" + name + "'; expected none, ldraw, or a .csv or .ldr file");
    }
}

TEST_F(PaletteFile, FilesOfTheSameColoursShareAPaletteAndAChangedFileIsReadAgain)
{
    const osg::ref_ptr<const Palette> first = read("a.csv", std::string(HEADER) + BLACK);
    std::string error;
    EXPECT_EQ(Palette::read(pathOf("a.csv"), error), first);
    EXPECT_EQ(read("same.csv", std::string(HEADER) + "# the same\n" + BLACK), first);
    write("a.csv", std::string(HEADER) + BLACK + SALMON);
    EXPECT_EQ(Palette::read(pathOf("a.csv"), error)->getColors().size(), 2u);
    // An error is not remembered in place of the palette.
    write("a.csv", "");
    EXPECT_FALSE(Palette::read(pathOf("a.csv"), error));
}

TEST_F(PaletteFile, AFileMovedOverAnotherOfTheSameSizeAndTimeIsRead)
{
    const osg::ref_ptr<const Palette> first = read("a.csv", std::string(HEADER) + BLACK);
    const auto time = std::filesystem::last_write_time(pathOf("a.csv"));
    write("b.csv", std::string(HEADER) + "0,Blank,#1B2A34,#808080,11,11111111111,11111111111\n");
    std::filesystem::last_write_time(pathOf("b.csv"), time);
    std::filesystem::rename(pathOf("b.csv"), pathOf("a.csv"));
    std::string error;
    const osg::ref_ptr<const Palette> second = Palette::read(pathOf("a.csv"), error);
    ASSERT_TRUE(second) << error;
    EXPECT_EQ(second->getColors()[0].name, "Blank");
}

TEST_F(PaletteFile, SettingsNameTheirPalette)
{
    LegoSettings settings;
    const auto findPaletteError = [](const LegoSettings& named)
    {
        std::string error;
        Palette::read(named, error);
        return error;
    };
    EXPECT_EQ(findPaletteError(settings), "");
    std::string error;
    EXPECT_FALSE(Palette::read(settings, error));
    EXPECT_EQ(error, "");
    settings.colors.palette = "ldraw";
    EXPECT_EQ(findPaletteError(settings), "");
    EXPECT_EQ(Palette::read(settings, error)->getColors().size(), 30u);
    settings.colors.palette = write("bad.csv", "x");
    EXPECT_EQ(findPaletteError(settings),
              pathOf("bad.csv") + ", line 1: expected code,name,rgb,edge,bricklink,bricks,plates, found 'x'");
    settings.colors.palette.reset();
    settings.parts.set = PartSet::BRICKS;
    EXPECT_EQ(findPaletteError(settings), "");
}

} // namespace

} // namespace osgLego
