#include <common/PartsList.h>

#include <PartModels.h>

#include <sstream>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

osg::ref_ptr<const BrickModel> createModel()
{
    const auto partOf = [](std::uint16_t y, const std::array<std::uint8_t, 3>& size, std::int32_t code) {
        return Part{{0, y, 0}, size, {1, 2, 3}, code};
    };
    // Two red bricks 2 x 4, in both directions, a dark turquoise 2 x 8, and a 1 x 1 in no colour of plastic.
    return BrickModel::createOfParts(createPartGrid({8, 20, 1}, 1.2),
                                     {partOf(0, {2, 4, 1}, 4), partOf(4, {4, 2, 1}, 4), partOf(6, {8, 2, 1}, 3),
                                      partOf(8, {1, 1, 1}, Part::NO_CODE)});
}

PartsList createList(const std::vector<PaletteColor>& palette = {})
{
    PartsList list;
    list.add(*createModel(), palette);
    return list;
}

std::string csvOf(const PartsList& list)
{
    std::ostringstream stream;
    list.writeCsv(stream);
    return stream.str();
}

TEST(PartsList, TheTableCountsAndWeighsEachTypeInEachColour)
{
    EXPECT_EQ(csvOf(createList()), "part,name,ldraw_color,color_name,bricklink_color,quantity,mass,total_mass\n"
                                   "3005,Brick 1 x 1,,#010203,,1,0.43,0.43\n"
                                   "3001,Brick 2 x 4,4,Red,5,2,2.16,4.32\n"
                                   "3007,Brick 2 x 8,3,Dark_Turquoise,39,1,4.40,4.40\n"
                                   "total,,,,,4,,9.15\n");
}

TEST(PartsList, WrittenListsEndWithPartsThatAreNotThoseOfTheModelAndCountThem)
{
    PartsList list = createList();
    list.addExtra({"3857", "Base plate 16 x 32", {2, "Green", {}, 6}, 2});
    EXPECT_NE(csvOf(list).find("\n3857,Base plate 16 x 32,2,Green,6,2,,\ntotal,,,,,6,,9.15\n"), std::string::npos)
        << csvOf(list);
    std::ostringstream wanted;
    list.writeWantedList(wanted);
    EXPECT_NE(wanted.str().find("<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>3857</ITEMID><COLOR>6</COLOR><MINQTY>2</MINQTY>"
                                "</ITEM>\n</INVENTORY>"),
              std::string::npos)
        << wanted.str();
    EXPECT_EQ(list.getRows().size(), 3u);
    list.addExtra({"3857", "Base plate 16 x 32", {2, "Green", {}, 6}, 1});
    EXPECT_NE(csvOf(list).find("\n3857,Base plate 16 x 32,2,Green,6,3,,\n"), std::string::npos) << csvOf(list);
}

TEST(PartsList, PartsOfSeveralModelsAreAddedUp)
{
    PartsList list = createList();
    list.add(*createModel(), {});
    EXPECT_NE(csvOf(list).find("3001,Brick 2 x 4,4,Red,5,4,2.16,8.64\n"), std::string::npos) << csvOf(list);
}

TEST(PartsList, ColoursOfThePaletteOverrideThoseOfTheLibraryAndAreQuoted)
{
    const std::string csv = csvOf(createList({{4, "my \"red\", bright", {255, 0, 0}, -1, 0x7ff, 0x7ff}}));
    EXPECT_NE(csv.find("3001,Brick 2 x 4,4,\"my \"\"red\"\", bright\",,2,"), std::string::npos) << csv;
}

TEST(PartsList, NamesOfColoursWithEndsOfLinesAreQuoted)
{
    const std::string csv = csvOf(createList({{4, "red\nbright", {255, 0, 0}, -1, 0x7ff, 0x7ff}}));
    EXPECT_NE(csv.find("3001,Brick 2 x 4,4,\"red\nbright\",,2,"), std::string::npos) << csv;
}

TEST(PartsList, TheWantedListHasNoDeclarationAndNoColourWithoutANumber)
{
    std::ostringstream stream;
    createList({{4, "red & <bright>", {255, 0, 0}, -1, 0x7ff, 0x7ff}}).writeWantedList(stream);
    EXPECT_EQ(stream.str(),
              "<INVENTORY>\n"
              "<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>3005</ITEMID><MINQTY>1</MINQTY><REMARKS>#010203</REMARKS></ITEM>\n"
              "<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>3001</ITEMID><MINQTY>2</MINQTY><REMARKS>red &amp; "
              "&lt;bright&gt;</REMARKS></ITEM>\n"
              "<ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>3007</ITEMID><COLOR>39</COLOR><MINQTY>1</MINQTY></ITEM>\n"
              "</INVENTORY>\n");
}

TEST(PartsList, NamesPartsThatWereNeverMadeOrHaveNoNumber)
{
    const PartsList list = createList();
    EXPECT_EQ(list.describeNeverMade(),
              "never made in this size and colour: 2 parts of 2 kinds (for example Brick 1 x 1 in #010203)");
    EXPECT_EQ(list.describeWithoutNumber(),
              "in a colour without a number of BrickLink: 1 part (Brick 1 x 1 in #010203)");
}

TEST(PartsList, NamesTheMostFrequentKindOfThoseThatWereNeverMade)
{
    // No brick of 2x3 or 2x8 was made in dark turquoise, and many of 2x4, which are not meant.
    const auto describe = [](std::size_t numSmall, std::size_t numLarge)
    {
        PartsList list;
        const auto add = [&list](std::size_t number, std::uint8_t length)
        {
            for (std::size_t part = 0; part < number; ++part)
                list.add(*BrickModel::createOfParts(createPartGrid({8, 2, 1}, 1.2),
                                                    {{{0, 0, 0}, {length, 2, 1}, {0, 0, 0}, 3}}),
                         {});
        };
        add(numSmall, 3);
        add(numLarge, 8);
        add(9, 4);
        return list.describeNeverMade();
    };
    EXPECT_EQ(describe(5, 2), "never made in this size and colour: 7 parts of 2 kinds (most of them Brick 2 x 3 in "
                              "Dark_Turquoise)");
    EXPECT_EQ(describe(2, 5), "never made in this size and colour: 7 parts of 2 kinds (most of them Brick 2 x 8 in "
                              "Dark_Turquoise)");
}

TEST(PartsList, PlatesAreCheckedForTheSizesOfPlates)
{
    const auto neverMade = [](double height)
    {
        PartsList list;
        list.add(*BrickModel::createOfParts(createPartGrid({8, 2, 1}, height), {{{0, 0, 0}, {8, 2, 1}, {0, 0, 0}, 3}}),
                 {});
        return list.describeNeverMade();
    };
    EXPECT_NE(neverMade(1.2), "");
    EXPECT_EQ(neverMade(0.4), "") << "the plate of 2 x 8 was made in dark turquoise";
}

TEST(PartsList, CellsGiveNoRows)
{
    PartsList list;
    list.add(*createCells(*createModel()), {});
    EXPECT_TRUE(list.getRows().empty());
}

} // namespace

} // namespace osgLego::test
