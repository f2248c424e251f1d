#include <ldraw/LDrawParser.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

LDrawDocument parse(const std::string& text)
{
    std::string error;
    std::optional<LDrawDocument> document = LDrawParser::parse(text, error);
    EXPECT_TRUE(document) << error;
    return document ? *document : LDrawDocument();
}

std::string errorOf(const std::string& text)
{
    std::string error;
    EXPECT_FALSE(LDrawParser::parse(text, error)) << text.substr(0, 100);
    return error;
}

const char* const BRICK = "1 4 10 -24 30 0 0 1 0 1 0 -1 0 0 3001.dat";

TEST(LDrawParser, ReadsPlaceAxesColourAndNameOfAPart)
{
    const LDrawDocument document = parse(BRICK);
    ASSERT_EQ(document.getMain().references.size(), 1u);
    const LDrawReference& reference = document.getMain().references.front();
    EXPECT_EQ(reference.color, 4);
    EXPECT_EQ(document.getName(reference), "3001.dat");
    // x' = z + 10, y' = y - 24, z' = -x + 30
    EXPECT_EQ(reference.transform * glm::dvec3(1, 2, 3), glm::dvec3(13, -22, 29));
}

TEST(LDrawParser, TheFirstLineOfTheMainModelIsItsTitle)
{
    for (const char* text : {"0 My Car\n0 Author: Ann Lee\n0 !LICENSE CC0\n",
                             "0 FILE car.ldr\n0 My Car\n0 Author: Ann Lee\n0 !LICENSE CC0\n",
                             "\n0  Model: My Car \r\n0 Name: car.ldr\r\n0 Author:  Ann Lee\r\n0 !LICENSE CC0\r\n"})
    {
        const ModelHeader header =
            parse(text + std::string(BRICK) + "\n0 FILE b.ldr\n0 Wheel\n0 Author: Bob\n").getHeader();
        EXPECT_EQ(header.title, "My Car") << text;
        EXPECT_EQ(header.author, "Ann Lee") << text;
        EXPECT_EQ(header.license, "CC0") << text;
    }
}

TEST(LDrawParser, TextsOfSubmodelsAreNotThoseOfTheMainModel)
{
    const std::string submodel = "0 FILE b.ldr\n0 Wheel\n0 Author: Bob\n0 !LICENSE CC BY 4.0\n";
    const ModelHeader alone = parse("0 FILE a.ldr\n0 My Car\n" + submodel).getHeader();
    EXPECT_EQ(alone.title, "My Car");
    EXPECT_EQ(alone.author + alone.license, "");
    EXPECT_EQ(parse("0 FILE a.ldr\n0 My Car\n0 !LICENSE CC0\n" + submodel).getHeader().license, "");
    EXPECT_EQ(parse("0 FILE a.ldr\n0 My Car\n0 !LICENSE CC BY 4.0\n" + submodel).getHeader().license, "CC BY 4.0");
}

TEST(LDrawParser, HeadersOfAnyTextAreRead)
{
    EXPECT_EQ(parse("0 Batman: The Tumbler\n").getHeader().title, "Batman: The Tumbler");
    EXPECT_EQ(parse("0 Model: Model: T\n").getHeader().title, "Model: T");
    const std::string license(250, 'x');
    EXPECT_EQ(parse("0 T\n0 !LICENSE " + license + "\n").getHeader().license, license);
    EXPECT_EQ(parse("0 T\n0 Author: J\xfcrgen\n").getHeader().author, "J\xc3\xbcrgen");
    EXPECT_EQ(parse("0 T\n0 Author: J\xc3\xbcrgen\n").getHeader().author, "J\xc3\xbcrgen");
    EXPECT_EQ(parse("0 a\x01z\n").getHeader().title, "a z");
}

TEST(LDrawParser, CommandsAndWhatProgramsWriteAreNoTitlesOrAuthors)
{
    for (const char* text :
         {"0 STEP\n0 My Car\n", "0 !LEOCAD MODEL NAME x\n", "0 // A car\n", "0 Name: car.ldr\n", "0 Untitled Model\n",
          "0 Author: osgLego\n", "0 Untitled\n0 Name: car.ldr\n0 Author: MLCad\n", "0\n", "0 \x01\n0 Author: \x02\n",
          "0 NOFILE\n0 Author: Ann Lee\n0 FILE a.ldr\n"})
    {
        const ModelHeader header = parse(text + std::string(BRICK)).getHeader();
        EXPECT_EQ(header.title + header.author + header.license, "") << text;
    }
    const ModelHeader late = parse(std::string(BRICK) + "\n0 My Car\n0 Author: Ann Lee\n0 !LICENSE CC0\n").getHeader();
    EXPECT_EQ(late.title + late.author + late.license, "");
}

TEST(LDrawParser, AcceptsByteOrderMarksCarriageReturnsTabsAndEmptyLines)
{
    const LDrawDocument document =
        parse("\xef\xbb\xbf\r\n0 title\r\n\r\n  1\t14\t0 0 0 1 0 0 0 1 0 0 0 1 \t3005.DAT  \r\n\t\r\n0 STEP");
    ASSERT_EQ(document.getMain().references.size(), 1u);
    EXPECT_EQ(document.getName(document.getMain().references.front()), "3005.dat");
}

TEST(LDrawParser, ReadsColoursInEveryForm)
{
    for (const auto& [text, color] : {std::pair("4", 4), std::pair("0x2FF8001", 0x2ff8001),
                                      std::pair("#2FF8001", 0x2ff8001), std::pair("50298881", 50298881)})
        EXPECT_EQ(
            parse("1 " + std::string(text) + " 0 0 0 1 0 0 0 1 0 0 0 1 3005.dat").getMain().references.at(0).color,
            color)
            << text;
}

TEST(LDrawParser, KeepsSpacesInNamesAndIgnoresFoldersOfTheLibraryAndCase)
{
    EXPECT_EQ(LDrawDocument::normalizeName("My Car - Wheels.LDR"), "my car - wheels.ldr");
    EXPECT_EQ(LDrawDocument::normalizeName("PARTS\\3001.DAT"), "3001.dat");
    EXPECT_EQ(LDrawDocument::normalizeName("C:\\LDraw\\parts\\3001.dat"), "3001.dat");
    EXPECT_EQ(LDrawDocument::normalizeName("s\\3001s01.dat"), "s/3001s01.dat");
    EXPECT_EQ(LDrawDocument::normalizeName("p/48/1-4edge.dat"), "48/1-4edge.dat");
    EXPECT_EQ(LDrawDocument::normalizeName("spareparts/3001.dat"), "spareparts/3001.dat");
}

TEST(LDrawParser, FilesBeginWithFileAndEndWithNofile)
{
    const std::string brick = std::string(BRICK) + "\n";
    const LDrawDocument document = parse("0 FILE Main Model.ldr\n" + brick + "0 NOFILE\n" + brick + brick +
                                         "0 FILE sub.ldr\n" + brick + brick + "0 FILE sub.ldr\n");
    EXPECT_EQ(document.getMain().name, "main model.ldr");
    EXPECT_EQ(document.getMain().references.size(), 1u);
    ASSERT_TRUE(document.find("sub.ldr"));
    EXPECT_EQ(document.find("sub.ldr")->references.size(), 2u) << "the first of two files with one name is used";
    EXPECT_FALSE(document.find("other.ldr"));
}

TEST(LDrawParser, ReadsTrianglesAndHalvesOfQuadrilaterals)
{
    const LDrawDocument document =
        parse("3 16 0 0 0 1 0 0 0 0 1\n4 4 0 0 0 2 0 0 2 0 2 0 0 2\n2 24 0 0 0 1 1 1\n5 24 0 0 0 1 1 1 2 2 2 3 3 3\n");
    const std::vector<LDrawTriangle>& triangles = document.getMain().triangles;
    ASSERT_EQ(triangles.size(), 3u);
    EXPECT_EQ(triangles[0].color, 16);
    EXPECT_EQ(triangles[1].corners[2], glm::dvec3(2, 0, 2));
    EXPECT_EQ(triangles[2].corners, (std::array{glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 2), glm::dvec3(0, 0, 2)}));
}

TEST(LDrawParser, ReadsDefinitionsOfColoursAndIgnoresOtherCommands)
{
    const LDrawDocument document =
        parse("0 !COLOUR Gold CODE 82 VALUE #DBAC34 EDGE #2B5A92 METAL\n"
              "0 !COLOUR Broken CODE x VALUE #DBAC34\n0 !COLOUR Half CODE 7\n"
              "0 BUFEXCHG A STORE\n0 GHOST 1 4 0 0 0\n0 ROTSTEP 10 20 30 ABS\n0\n0 // comment\n");
    ASSERT_EQ(document.getColors().size(), 1u);
    EXPECT_EQ(document.getColors()[0].code, 82);
    EXPECT_EQ(document.getColors()[0].color, (std::array<std::uint8_t, 3>{0xdb, 0xac, 0x34}));
    EXPECT_TRUE(document.getMain().references.empty());
}

TEST(LDrawParser, NamesTheLineAndTheValueThatAreWrong)
{
    EXPECT_EQ(errorOf("0 x\nsolid cube"),
              "line 2: it begins with 'solid'; expected a type of line, 0 to 5, as in files of LDraw");
    EXPECT_EQ(errorOf("1 4 10 -24"), "line 1: it ends too early; expected more numbers");
    EXPECT_EQ(errorOf("1 4 0 0 0 1 0 0 0 1 0 0 0 1"),
              "line 1: it ends too early; expected the name of a part or a submodel");
    for (const char* number : {"nan", "inf", "1e8", "-1e300", "0x10", "1,5", "--1"})
        EXPECT_EQ(errorOf("1 4 0 " + std::string(number) + " 0 1 0 0 0 1 0 0 0 1 3001.dat"),
                  "line 1: '" + std::string(number) + "' is not a coordinate; expected a number from -1e+07 to 1e+07");
    for (const char* color : {"red", "-4", "99999999999", "0x", "1.5"})
        EXPECT_EQ(errorOf("1 " + std::string(color) + " 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat"),
                  "line 1: '" + std::string(color) +
                      "' is not a colour; expected a code, or 0x2 and six hexadecimal digits");
    EXPECT_EQ(errorOf("3 4 0 0 0 1 1 1 2 2"), "line 1: it ends too early; expected more numbers");
}

TEST(LDrawParser, RefusesForeignFilesAndEndlessLinesWithShortMessages)
{
    EXPECT_EQ(errorOf("0 " + std::string(1 << 20, 'x')), "line 1: it has 1048578 characters; expected at most 65536");
    const std::string bytes("\x7f"
                            "ELF\x02\x01\x01\x00\x00",
                            9);
    EXPECT_NE(errorOf(bytes).find("expected a type of line"), std::string::npos);
    EXPECT_LT(errorOf(std::string(60000, 'x')).size(), 200u);
    EXPECT_NE(errorOf("0,1,2\n").find("'0,1,2'"), std::string::npos);
}

} // namespace

} // namespace osgLego
