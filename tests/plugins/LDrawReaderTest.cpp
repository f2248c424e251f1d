#include <ldraw/LDrawReader.h>

#include <osgLego/LegoNode.h>
#include <osgLego/Palette.h>

#include <TemporaryFolder.h>

#include <fstream>

#include <osg/Geode>
#include <osg/Geometry>

namespace osgLego::test
{

namespace
{

const std::string ALONG_X = " 1 0 0 0 1 0 0 0 1 ";
const std::string ALONG_Z = " 0 0 1 0 1 0 -1 0 0 ";

/** Reads texts, with a library in the test's folder. */
class LDrawReaderTest : public TemporaryFolderTest
{
protected:
    osg::ref_ptr<const BrickModel> read(const std::string& text)
    {
        const osg::ref_ptr<osg::Node> node = readNode(text);
        if (!node) return nullptr;
        auto* lego = dynamic_cast<LegoNode*>(node->asGroup()->getChild(0));
        return lego ? lego->getStoredBricks() : nullptr;
    }

    osg::ref_ptr<osg::Node> readNode(const std::string& text)
    {
        LDrawLibrary library(pathOf("model"), _hasLibrary ? pathOf("library") : std::string());
        LDrawReader reader("test.ldr", library);
        _error.clear();
        osg::ref_ptr<osg::Node> node = reader.read(text, _error);
        EXPECT_EQ(node != nullptr, _error.empty());
        _warnings = reader.getWarnings();
        return node;
    }

    void write(const std::string& name, const std::string& text)
    {
        std::filesystem::create_directories((_folder / name).parent_path());
        std::ofstream(_folder / name) << text;
    }

    bool _hasLibrary = false;
    std::string _error;
    std::vector<std::string> _warnings;
};

Part expectedPart(const std::array<std::uint16_t, 3>& cell, const std::array<std::uint8_t, 3>& size, std::int32_t code)
{
    Part part{cell, size, {}, code};
    for (const PaletteColor& color : Palette::getKnownColors())
        if (color.code == code) part.color = color.color;
    return part;
}

TEST_F(LDrawReaderTest, BricksInBothDirectionsCoverTheirCellsInAGridInMillimetres)
{
    // 2 x 4 along x: x 0 to 80, z 0 to 40. 2 x 3 along z above it: x 20 to 60, z -20 to 40.
    const auto model = read("1 4 40 -24 20" + ALONG_X + "3001.dat\n1 1 40 -48 10" + ALONG_Z + "3002.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_TRUE(_warnings.empty());
    EXPECT_EQ(model->getGrid().upAxis, UpAxis::Z);
    EXPECT_EQ(model->getGrid().cellSize, glm::dvec3(8.0, 8.0, 0.4 * 24.0));
    EXPECT_EQ(model->getGrid().dimensions, glm::ivec3(4, 3, 2));
    EXPECT_EQ(model->getGrid().origin, glm::dvec3(0.0, -8.0, 0.0));
    EXPECT_EQ(model->getParts(),
              (std::vector{expectedPart({0, 1, 0}, {4, 2, 1}, 4), expectedPart({1, 0, 1}, {2, 3, 1}, 1)}));
}

TEST_F(LDrawReaderTest, TheBricksHaveTheTextsOfTheHeader)
{
    const osg::ref_ptr<osg::Node> node =
        readNode("0 My Car\n0 Author: Ann Lee\n0 !LICENSE CC0\n1 4 0 0 0" + ALONG_X + "3001.dat\n");
    ASSERT_TRUE(node);
    const ModelHeader header = ModelHeader::find(*node->asGroup()->getChild(0));
    EXPECT_EQ(header.title, "My Car");
    EXPECT_EQ(header.author, "Ann Lee");
    EXPECT_EQ(header.license, "CC0");
}

TEST_F(LDrawReaderTest, OnePlateMakesAGridOfPlates)
{
    const auto model = read("1 4 0 -24 0" + ALONG_X + "3005.dat\n1 14 0 -32 0" + ALONG_X + "3024.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getGrid().cellSize, glm::dvec3(8.0, 8.0, 0.4 * 8.0));
    EXPECT_EQ(model->getParts(),
              (std::vector{expectedPart({0, 0, 0}, {1, 1, 3}, 4), expectedPart({0, 0, 3}, {1, 1, 1}, 14)}));
}

TEST_F(LDrawReaderTest, BricksAThirdApartMakeAGridOfPlates)
{
    const auto model = read("1 4 0 -24 0" + ALONG_X + "3005.dat\n1 4 20 -32 0" + ALONG_X + "3005.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getGrid().dimensions, glm::ivec3(2, 1, 4));
}

TEST_F(LDrawReaderTest, EveryPartIsKnownInBothDirections)
{
    for (const PartType& type : getPartTypes())
        for (const std::string& axes : {ALONG_X, ALONG_Z})
        {
            const auto model = read("1 4 0 0 0" + axes + std::string(type.number) + ".dat\n");
            ASSERT_TRUE(model) << type.getName();
            const glm::ivec3 size = model->getParts().at(0).getSize();
            EXPECT_EQ(size, axes == ALONG_X ? glm::ivec3(type.length, type.width, 1)
                                            : glm::ivec3(type.width, type.length, 1));
            EXPECT_EQ(findPartType(model->getParts()[0], model->getGrid()), &type);
        }
}

TEST_F(LDrawReaderTest, SubmodelsPassOnTheirTransformAndColour)
{
    // The tower, turned by 90 degrees and moved by (100, -24, 0): x' = z + 100, z' = -x.
    const auto model = read("0 FILE main.ldr\n1 4 100 -24 0 0 0 1 0 1 0 -1 0 0 The Tower.ldr\n"
                            "0 NOFILE\n0 FILE the tower.LDR\n1 16 20 -24 0" +
                            ALONG_X + "3004.dat\n1 1 50 -48 20" + ALONG_X + "PARTS\\3005.DAT\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_TRUE(_warnings.empty());
    // 3004 lies along z: x 90 to 110, z -40 to 0. 3005 stands above: x 110 to 130, z -60 to -40.
    EXPECT_EQ(model->getGrid().origin, 0.4 * glm::dvec3(90.0, -60.0, 24.0));
    EXPECT_EQ(model->getParts(),
              (std::vector{expectedPart({0, 1, 0}, {1, 2, 1}, 4), expectedPart({1, 0, 1}, {1, 1, 1}, 1)}));
}

TEST_F(LDrawReaderTest, PartsInTheColourOfEdgesHaveThatOfTheReferenceToTheirSubmodel)
{
    const auto model =
        read("0 FILE main.ldr\n1 4 0 0 0" + ALONG_X + "sub.ldr\n0 FILE sub.ldr\n1 24 0 0 0" + ALONG_X + "3005.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().at(0).colorCode, 4);
}

TEST_F(LDrawReaderTest, InclinedScaledAndShiftedPartsAreNamedOnceAndLeftOut)
{
    const std::string good = "1 4 0 -24 0" + ALONG_X + "3001.dat\n1 4 0 -48 0" + ALONG_X + "3001.dat\n";
    const auto model = read(good + "1 4 0 -72 0 0 1 0 1 0 0 0 0 1 3003.dat\n"      // on its side
                                   "1 4 100 -24 0 2 0 0 0 1 0 0 0 1 3003.dat\n"    // stretched
                                   "1 4 110 -24 5 1 0 0 0 1 0 0 0 1 3004.dat\n"    // a quarter of a stud away
                                   "1 4 200 -24 0 1 0 0 0 -1 0 0 0 1 3003.dat\n"); // upside down
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 2u);
    EXPECT_EQ(_warnings,
              (std::vector<std::string>{"these parts are inclined or between the studs of the others and are "
                                        "left out: 3003.dat (3 times), 3004.dat"}));
}

TEST_F(LDrawReaderTest, MostPartsDetermineTheLatticeNotTheFirst)
{
    const auto model = read("1 4 5 -24 0" + ALONG_X + "3005.dat\n1 4 100 -24 0" + ALONG_X + "3003.dat\n1 4 200 -24 0" +
                            ALONG_X + "3003.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 2u);
    EXPECT_EQ(_warnings.size(), 1u);
}

TEST_F(LDrawReaderTest, OfTwoLatticesWithEquallyManyPartsTheFirstPartDeterminesIt)
{
    for (const int first : {3, 0})
        EXPECT_EQ(read("1 4 " + std::to_string(first) + " 0 0" + ALONG_X + "3005.dat\n1 1 " +
                       std::to_string(100 + 3 - first) + " 0 0" + ALONG_X + "3005.dat\n")
                      ->getParts()
                      .at(0)
                      .colorCode,
                  4)
            << first;
}

TEST_F(LDrawReaderTest, RoundingDoesNotSplitALattice)
{
    std::string text;
    for (const char* x : {"10.01", "49.99", "90.01", "129.99", "180", "220", "260"})
        text += "1 4 " + std::string(x) + " -24 0" + ALONG_X + "3005.dat\n";
    const auto model = read(text);
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 4u) << "the first four parts, not the three half a stud beside them";
}

TEST_F(LDrawReaderTest, RoundedNumbersAndMirroredPartsAreAccepted)
{
    const auto model = read("1 4 0.01 -23.99 0 1 0 0.0001 0 1 0 -0.0001 0 1 3001.dat\n"
                            "1 4 79.99 -24 -0.04 -1 0 0 0 1 0 0 0 1 3001.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 2u);
    EXPECT_TRUE(_warnings.empty());
}

TEST_F(LDrawReaderTest, OverlappingPartsAreLeftOut)
{
    const auto model = read("1 4 0 -24 0" + ALONG_X + "3001.dat\n1 1 40 -24 0" + ALONG_X + "3001.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 1u);
    EXPECT_EQ(_warnings, (std::vector<std::string>{"these parts overlap others and are left out: 3001.dat"}));
}

TEST_F(LDrawReaderTest, TheGridFitsThePartsWithoutThoseThatAreLeftOut)
{
    // The second part is a plate higher and two studs farther to the right than the first.
    const auto model = read("1 4 0 -24 0" + ALONG_X + "3001.dat\n1 1 40 -32 0" + ALONG_X + "3001.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getGrid().dimensions, glm::ivec3(4, 2, 1)) << "of bricks, not of plates";
    EXPECT_EQ(_warnings.size(), 1u);
}

TEST_F(LDrawReaderTest, DirectColoursHaveNoCodeAndUnknownCodesAreGrey)
{
    const auto model =
        read("1 0x2102030 0 0 0" + ALONG_X + "3005.dat\n1 9999 20 0 0" + ALONG_X + "3005.dat\n1 82 40 0 0" + ALONG_X +
             "3005.dat\n1 16 60 0 0" + ALONG_X + "3005.dat\n0 !COLOUR Gold CODE 82 VALUE #DBAC34 EDGE #2B5A92\n");
    ASSERT_TRUE(model) << _error;
    const auto colorOf = [&](std::size_t index)
    { return std::pair(model->getParts().at(index).colorCode, model->getParts()[index].color); };
    using Color = std::array<std::uint8_t, 3>;
    EXPECT_EQ(colorOf(0), std::pair(Part::NO_CODE, Color{0x10, 0x20, 0x30}));
    EXPECT_EQ(colorOf(1), std::pair(9999, Color{127, 127, 127}));
    EXPECT_EQ(colorOf(2), std::pair(82, Color{0xdb, 0xac, 0x34}));
    EXPECT_EQ(colorOf(3), std::pair(Part::NO_CODE, Color{127, 127, 127}));
    EXPECT_EQ(_warnings, (std::vector<std::string>{"these colours are not known and are shown in grey: 9999"}));
}

TEST_F(LDrawReaderTest, BasePlatesAreNoPartsOfModels)
{
    const auto model = read("1 2 0 0 0" + ALONG_X + "3811.dat\n1 4 0 0 0" + ALONG_X + "3005.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 1u);
    EXPECT_EQ(_warnings, (std::vector<std::string>{"base plates are left out, since models stand on them without "
                                                   "containing them"}));
}

TEST_F(LDrawReaderTest, UnknownPartsAreNamedOnceAndLeftOut)
{
    const auto model = read("1 4 0 0 0" + ALONG_X + "3005.dat\n1 4 0 0 0" + ALONG_X + "4070.dat\n1 4 0 0 0" + ALONG_X +
                            "4070.DAT\n1 4 0 0 0" + ALONG_X + "wheel.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(_warnings,
              (std::vector<std::string>{"these parts are not known and are left out: 4070.dat (2 times), wheel.dat; "
                                        "LDRAWDIR may name the folder of a part library"}));
}

TEST_F(LDrawReaderTest, WarningsStayShortForManyAndLongNames)
{
    std::string text;
    for (int index = 0; index < 25; ++index)
        text += "1 " + std::to_string(9000 + index) + " " + std::to_string(20 * index) + " 0 0" + ALONG_X +
                "3005.dat\n1 4 0 0 0" + ALONG_X + std::to_string(100 + index) + std::string(1000, 'x') + ".dat\n";
    ASSERT_TRUE(read(text)) << _error;
    ASSERT_EQ(_warnings.size(), 2u);
    EXPECT_LT(_warnings[0].size(), 2000u);
    EXPECT_NE(_warnings[0].find("xxx..., 101x"), std::string::npos) << _warnings[0];
    EXPECT_NE(_warnings[0].find("xxx... and 5 more; LDRAWDIR"), std::string::npos) << _warnings[0];
    EXPECT_EQ(_warnings[1], "these colours are not known and are shown in grey: 9000, 9001, 9002, 9003, 9004, 9005, "
                            "9006, 9007, 9008, 9009, 9010, 9011, 9012, 9013, 9014, 9015, 9016, 9017, 9018, 9019 and 5 "
                            "more");
}

TEST_F(LDrawReaderTest, AColourThatIsNotKnownIsNamedOnce)
{
    ASSERT_TRUE(read("1 9999 0 0 0" + ALONG_X + "3005.dat\n1 9999 20 0 0" + ALONG_X + "3005.dat\n"));
    EXPECT_EQ(_warnings, (std::vector<std::string>{"these colours are not known and are shown in grey: 9999"}));
}

TEST_F(LDrawReaderTest, BlackHasTheColourOfThePlasticWhateverTheLibrarySays)
{
    write("library/parts/4070.dat", "3 16 0 0 0 20 0 0 0 0 20\n");
    write("library/LDConfig.ldr", "0 !COLOUR Black CODE 0 VALUE #1B2A34 EDGE #808080\n");
    _hasLibrary = true;
    const auto model = read("1 0 0 -24 0" + ALONG_X + "3005.dat\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().at(0).colorCode, 0);
    EXPECT_EQ(model->getParts().at(0).color, (std::array<std::uint8_t, 3>{0x21, 0x21, 0x21}));
}

TEST_F(LDrawReaderTest, UnknownPartsAreDrawnFromTheLibrary)
{
    // A part of two triangles, one of them in a separate file in the folder s. Names ignore case.
    write("library/PARTS/4070.DAT",
          "0 Part\r\n3 16 0 0 0 20 0 0 0 0 20\r\n1 14 0 0 0 1 0 0 0 1 0 0 0 1 s\\4070s01.dat\r\n");
    write("library/PARTS/S/4070s01.dat", "1 16 0 10 0 1 0 0 0 1 0 0 0 1 tri.dat\n");
    write("library/p/tri.dat", "3 16 0 0 0 20 0 0 0 0 20\n");
    write("library/LDConfig.ldr", "0 !COLOUR Ruby CODE 700 VALUE #C00010 EDGE #000000\n");
    _hasLibrary = true;
    const osg::ref_ptr<osg::Node> node =
        readNode("1 4 10 0 10" + ALONG_X + "3005.dat\n1 700 100 -24 0" + ALONG_X + "4070.dat\n");
    ASSERT_TRUE(node) << _error;
    EXPECT_TRUE(_warnings.empty());
    ASSERT_EQ(node->asGroup()->getNumChildren(), 2u);
    osg::Geometry* geometry = node->asGroup()->getChild(1)->asGeode()->getDrawable(0)->asGeometry();
    const auto& vertices = dynamic_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
    const auto& colors = dynamic_cast<const osg::Vec4ubArray&>(*geometry->getColorArray());
    ASSERT_EQ(vertices.size(), 6u);
    // (100, -24, 0) LDU, and 10 lower: z is up, in millimetres.
    EXPECT_LT((vertices[0] - osg::Vec3(40.0f, 0.0f, 9.6f)).length(), 1e-4f);
    EXPECT_LT((vertices[2] - osg::Vec3(40.0f, 8.0f, 9.6f)).length(), 1e-4f);
    EXPECT_LT((vertices[3] - osg::Vec3(40.0f, 0.0f, 5.6f)).length(), 1e-4f);
    EXPECT_EQ(colors[0], osg::Vec4ub(0xc0, 0x00, 0x10, 255));
    EXPECT_EQ(colors[3], osg::Vec4ub(0xfa, 0xc8, 0x0a, 255)) << "the colour of the inner reference";
}

TEST_F(LDrawReaderTest, KnownPartsOffTheLatticeAreDrawnFromTheLibrary)
{
    write("library/parts/3005.dat", "3 16 0 0 0 20 0 0 0 0 20\n");
    _hasLibrary = true;
    const osg::ref_ptr<osg::Node> node =
        readNode("1 4 0 0 0" + ALONG_X + "3003.dat\n1 4 0 -24 0 1 0 0 0 0 1 0 -1 0 3005.dat\n");
    ASSERT_TRUE(node) << _error;
    EXPECT_EQ(node->asGroup()->getNumChildren(), 2u);
    EXPECT_EQ(_warnings,
              (std::vector<std::string>{"these parts are inclined or between the studs of the others and are "
                                        "drawn as surfaces: 3005.dat"}));
}

TEST_F(LDrawReaderTest, SubmodelsAreFoundBesideTheFileButNotOutsideItsFolder)
{
    write("model/My Tower.LDR", "1 16 0 -24 0" + ALONG_X + "3005.dat\n");
    write("secret.ldr", "1 16 0 -24 0" + ALONG_X + "3005.dat\n");
    const auto model = read("1 4 0 0 0" + ALONG_X + "my tower.ldr\n1 4 40 0 0" + ALONG_X +
                            "..\\secret.ldr\n1 4 40 0 0" + ALONG_X + pathOf("secret.ldr") + "\n");
    ASSERT_TRUE(model) << _error;
    EXPECT_EQ(model->getParts().size(), 1u);
    ASSERT_EQ(_warnings.size(), 1u);
    EXPECT_NE(_warnings[0].find("../secret.ldr"), std::string::npos);
}

TEST_F(LDrawReaderTest, AFileThatIncludesItselfIsAnError)
{
    EXPECT_FALSE(read("0 FILE a.ldr\n1 4 0 0 0" + ALONG_X + "b.ldr\n0 FILE b.ldr\n1 4 0 0 0" + ALONG_X + "A.ldr\n"));
    EXPECT_EQ(_error, "'a.ldr' includes itself");
    write("model/loop.ldr", "1 4 0 0 0" + ALONG_X + "loop.ldr\n");
    EXPECT_FALSE(read("1 4 0 0 0" + ALONG_X + "loop.ldr\n"));
    EXPECT_EQ(_error, "'loop.ldr' includes itself");
}

TEST_F(LDrawReaderTest, SubmodelsThatMultiplyOrNestWithoutEndAreAnError)
{
    std::string doubling = "0 FILE 0.ldr\n";
    std::string nested = doubling;
    for (int level = 1; level < 60; ++level)
    {
        const std::string line = "1 4 0 0 0" + ALONG_X + std::to_string(level) + ".ldr\n";
        const std::string file = "0 FILE " + std::to_string(level) + ".ldr\n";
        doubling += line + line + file;
        nested += line + file;
    }
    EXPECT_FALSE(read(doubling));
    EXPECT_EQ(_error, "its submodels add up to more than 10000000 lines; expected fewer");
    for (int level = 60; level < 100; ++level)
        nested += "1 4 0 0 0" + ALONG_X + std::to_string(level) + ".ldr\n0 FILE " + std::to_string(level) + ".ldr\n";
    EXPECT_FALSE(read(nested));
    EXPECT_EQ(_error, "files include each other more than 64 deep; expected fewer levels");
}

TEST_F(LDrawReaderTest, TransformsThatMultiplyToHugeNumbersAreAnError)
{
    std::string nested = "0 FILE 0.ldr\n";
    for (int level = 1; level < 60; ++level)
        nested += "1 4 1e6 0 0 1e6 0 0 0 1e6 0 0 0 1e6 " + std::to_string(level) + ".ldr\n0 FILE " +
                  std::to_string(level) + ".ldr\n";
    EXPECT_FALSE(read(nested + "1 4 0 0 0" + ALONG_X + "3005.dat\n"));
    EXPECT_EQ(_error, "'2.ldr' is too far away or too large; expected at most 1e+09 LDU");
}

TEST_F(LDrawReaderTest, ALibraryWithoutPartsIsNamed)
{
    _hasLibrary = true;
    EXPECT_TRUE(read("1 4 0 0 0" + ALONG_X + "3005.dat\n"));
    EXPECT_EQ(_warnings, (std::vector<std::string>{"there is no folder 'parts' in '" + pathOf("library") +
                                                   "'; expected LDRAWDIR as the folder of a part library"}));
}

TEST_F(LDrawReaderTest, FilesOfTheLibraryThatCannotBeReadAreNamed)
{
    write("library/parts/4070.dat", "solid cube\n");
    _hasLibrary = true;
    EXPECT_TRUE(read("1 4 0 0 0" + ALONG_X + "3005.dat\n1 4 0 0 0" + ALONG_X + "4070.dat\n"));
    ASSERT_EQ(_warnings.size(), 2u);
    EXPECT_NE(_warnings[0].find("4070.dat': line 1: it begins with 'solid'"), std::string::npos) << _warnings[0];
    EXPECT_EQ(_warnings[1], "these parts are not known and are left out: 4070.dat");
}

TEST_F(LDrawReaderTest, AModelThatIsTooLargeForAGridIsAnError)
{
    EXPECT_FALSE(read("1 4 0 0 0" + ALONG_X + "3005.dat\n1 4 20480 0 0" + ALONG_X + "3005.dat\n"));
    EXPECT_EQ(_error, "its parts reach over 1025 x 1 x 1 cells; expected at most 1024 x 1024 x 2560");
    EXPECT_TRUE(read("1 4 0 0 0" + ALONG_X + "3005.dat\n1 4 20460 0 0" + ALONG_X + "3005.dat\n"));
    EXPECT_FALSE(read("1 4 -1e7 0 0" + ALONG_X + "3005.dat\n1 4 1e7 0 0" + ALONG_X + "3005.dat\n"));
}

TEST_F(LDrawReaderTest, FilesWithoutBricksAreAnError)
{
    for (const char* text : {"", "\r\n\r\n", "0 an empty model\n0 STEP\n"})
    {
        EXPECT_FALSE(read(text));
        EXPECT_EQ(_error, "it has no bricks or plates that can be shown; expected upright parts such as 3001.dat");
    }
    EXPECT_FALSE(read("1 4 0 0 0" + ALONG_X + "4070.dat\n"));
    EXPECT_EQ(_error.rfind("it has no bricks or plates that can be shown; expected upright parts such as 3001.dat, or "
                           "LDRAWDIR as the folder of a part library; ",
                           0),
              0u)
        << _error;
    EXPECT_NE(_error.find("4070.dat"), std::string::npos) << _error;
}

} // namespace

} // namespace osgLego::test
