#include <booklet/SheetArrangement.h>

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

SheetBlock createBlock(double head, const glm::dvec2& studs)
{
    SheetBlock block;
    block.heads = {head, head, 1.5 * head};
    block.studs = studs;
    return block;
}

/** Steps of a model of some width that grows upwards, with lists of parts of different lengths. */
std::vector<SheetBlock> createSteps(std::size_t number, double width, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> heads(11.0, 45.0);
    std::uniform_real_distribution<double> noise(-0.03, 0.03);
    std::vector<SheetBlock> blocks;
    for (std::size_t index = 0; index < number; ++index)
    {
        const double share = static_cast<double>(index) / static_cast<double>(number);
        blocks.push_back(createBlock(heads(random), {width, width * (0.35 + 0.5 * share + noise(random))}));
    }
    return blocks;
}

/** The height of a column down to its last picture. */
double measure(const SheetColumn& column)
{
    double height = 0.0;
    for (const PlacedBlock& place : column)
        height += place.height + place.space;
    return height;
}

} // namespace

TEST(SheetArrangementTest, EveryBlockIsOnOneSheetInItsOrderAndNoneIsCut)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        const std::vector<SheetBlock> blocks = createSteps(3 + 2 * seed, 10.0 + 2.0 * seed, seed);
        const double header = 5.0 * seed;
        const SheetArrangement arrangement(blocks, header);
        std::size_t next = 0;
        for (const Sheet& sheet : arrangement.getSheets())
        {
            const bool isFirst = &sheet == &arrangement.getSheets().front();
            if (isFirst && sheet.columns.empty()) continue; // below a high header
            ASSERT_EQ(sheet.columns.size(), sheet.numColumns);
            for (const SheetColumn& column : sheet.columns)
            {
                EXPECT_LE(measure(column), SheetArrangement::HEIGHT - (isFirst ? header : 0.0) + 1e-6);
                for (const PlacedBlock& place : column)
                {
                    EXPECT_EQ(place.block, next++);
                    const SheetBlock& block = blocks[place.block];
                    EXPECT_LE(block.studs.x * place.pitch, SheetArrangement::getColumnWidth(sheet.numColumns) + 1e-6);
                    EXPECT_GE(place.height + 1e-6, block.heads[sheet.numColumns - 1] + block.studs.y * place.pitch);
                }
            }
        }
        EXPECT_EQ(next, blocks.size());
    }
}

TEST(SheetArrangementTest, BelowHeadersOfAnyHeightNothingIsCut)
{
    for (int tenths = 0; tenths <= 10; ++tenths)
        for (const double head : {11.0, 60.0, SheetArrangement::MOST_HEAD})
        {
            std::vector<SheetBlock> blocks = createSteps(8, 30.0, 1);
            blocks.front().heads = {head, head, head};
            const double header = 0.1 * tenths * SheetArrangement::HEIGHT;
            const SheetArrangement arrangement(blocks, header);
            const std::vector<Sheet>& sheets = arrangement.getSheets();
            std::size_t number = 0;
            for (const Sheet& sheet : sheets)
                for (const SheetColumn& column : sheet.columns)
                {
                    const double space = SheetArrangement::HEIGHT - (&sheet == &sheets.front() ? header : 0.0);
                    EXPECT_LE(measure(column), space + 1e-6) << header << " " << head;
                    number += column.size();
                    for (const PlacedBlock& place : column)
                    {
                        const SheetBlock& block = blocks[place.block];
                        const double picture = place.height - block.heads[sheet.numColumns - 1];
                        EXPECT_GE(picture + 1e-6, block.studs.y * place.pitch) << header << " " << head;
                        EXPECT_GT(place.pitch, 1.0) << header << " " << head;
                    }
                }
            EXPECT_EQ(number, blocks.size()) << header << " " << head;
        }
}

TEST(SheetArrangementTest, PicturesAreSmallerToFillTheSheetOfAHeader)
{
    // Below the header, a list leaves less space than a picture needs at its scale.
    const std::vector<SheetBlock> blocks(2, createBlock(70.0, {30.0, 30.0}));
    const std::vector<Sheet> sheets = SheetArrangement(blocks, 0.35 * SheetArrangement::HEIGHT, 1).getSheets();
    ASSERT_EQ(sheets.size(), 2u);
    ASSERT_FALSE(sheets.front().columns.empty());
    const double pitch = sheets.front().columns[0][0].pitch;
    EXPECT_GE(30.0 * pitch, SheetArrangement::LEAST_PICTURE);
    EXPECT_LT(pitch, sheets.back().columns[0][0].pitch);
}

TEST(SheetArrangementTest, NoPictureIsMuchSmallerBelowAHeader)
{
    const std::vector<SheetBlock> blocks(5, createBlock(20.0, {42.0, 36.0}));
    // Lower headers are never alone if a picture fits below them, since their sheets would not be half full.
    for (int percent = 54; percent <= 100; ++percent)
    {
        const SheetArrangement arrangement(blocks, 0.01 * percent * SheetArrangement::HEIGHT, 1);
        const std::vector<Sheet>& sheets = arrangement.getSheets();
        if (sheets.front().columns.empty()) continue;
        EXPECT_GT(sheets.front().columns[0][0].pitch, 0.6 * sheets.back().columns[0][0].pitch) << percent;
    }
}

TEST(SheetArrangementTest, ABlockThatIsTooHighForColumnsHasASheetWithoutThem)
{
    std::vector<SheetBlock> blocks(20, createBlock(20.0, {10.0, 6.0}));
    blocks[9].heads = {100.0, SheetFilling::IMPOSSIBLE, SheetFilling::IMPOSSIBLE};
    blocks[9].scales = {0.9, 0.7, 0.7};
    const SheetArrangement arrangement(blocks, 0.0);
    for (const Sheet& sheet : arrangement.getSheets())
        for (const SheetColumn& column : sheet.columns)
            for (const PlacedBlock& place : column)
            {
                EXPECT_TRUE(place.block != 9 || sheet.numColumns == 1);
                EXPECT_EQ(place.scale, place.block == 9 ? 0.9 : 1.0);
            }
}

TEST(SheetArrangementTest, BlocksThatAreHigherThanASheetAreRejected)
{
    std::vector<SheetBlock> blocks(3, createBlock(20.0, {30.0, 20.0}));
    blocks[1].heads[0] = SheetArrangement::HEIGHT + 1.0;
    EXPECT_THROW(SheetArrangement(blocks, 0.0, 1), std::invalid_argument);
}

TEST(SheetArrangementTest, SheetsAreHalfFull)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        const std::vector<SheetBlock> blocks = createSteps(12 + seed, 10.0 + 2.0 * seed, seed);
        const SheetArrangement arrangement(blocks, 40.0);
        for (const Sheet& sheet : arrangement.getSheets())
        {
            double highest = &sheet == &arrangement.getSheets().front() ? 40.0 : 0.0;
            const double header = highest;
            for (const SheetColumn& column : sheet.columns)
                highest = std::max(highest, header + measure(column));
            EXPECT_GE(highest, 0.5 * SheetArrangement::HEIGHT) << seed;
        }
    }
}

TEST(SheetArrangementTest, PicturesOfTheModelHaveOneScale)
{
    const std::vector<SheetBlock> blocks = createSteps(20, 30.0, 1);
    const SheetArrangement arrangement(blocks, 0.0);
    for (const Sheet& sheet : arrangement.getSheets())
        for (const SheetColumn& column : sheet.columns)
            for (const PlacedBlock& place : column)
                EXPECT_DOUBLE_EQ(place.pitch, arrangement.getSheets()[0].columns[0][0].pitch);
}

TEST(SheetArrangementTest, WideModelsHaveOneColumnAndNarrowOnesSeveral)
{
    const auto count = [](double width)
    {
        const std::vector<SheetBlock> blocks(20, createBlock(20.0, {width, 0.6 * width}));
        return SheetArrangement(blocks, 0.0).getSheets().front().numColumns;
    };
    EXPECT_EQ(count(80.0), 1u);
    EXPECT_EQ(count(30.0), 2u);
    EXPECT_EQ(count(10.0), 3u);
}

TEST(SheetArrangementTest, StudsInSeveralColumnsAreNotTooSmallToCount)
{
    // In three columns, studs would have 1.68 mm; three columns of lists this long would save sheets.
    const std::vector<SheetBlock> blocks(21, createBlock(60.0, {23.0, 23.0}));
    const std::vector<Sheet> sheets = SheetArrangement(blocks, 0.0).getSheets();
    EXPECT_EQ(sheets.front().numColumns, 2u);
    EXPECT_GE(sheets.front().columns[0][0].pitch, 1.75);
}

TEST(SheetArrangementTest, ASheetOfFewBlocksHasFewerColumnsThanTheOthers)
{
    // Two columns of two blocks on two sheets; two blocks would be less than half of the third sheet in columns.
    const std::vector<SheetBlock> blocks(10, createBlock(20.0, {30.0, 30.0}));
    const std::vector<Sheet> sheets = SheetArrangement(blocks, 0.0).getSheets();
    const auto count = [&sheets](std::size_t numColumns)
    {
        return std::count_if(sheets.begin(), sheets.end(),
                             [numColumns](const Sheet& sheet) { return sheet.numColumns == numColumns; });
    };
    EXPECT_EQ(sheets.size(), 3u);
    EXPECT_EQ(count(2), 2);
    EXPECT_EQ(count(1), 1);
}

TEST(SheetArrangementTest, AHighHeaderIsAloneIfNoBlockFitsBelowIt)
{
    const std::vector<SheetBlock> blocks(8, createBlock(30.0, {40.0, 30.0}));
    const std::vector<Sheet> alone = SheetArrangement(blocks, 140.0).getSheets();
    EXPECT_TRUE(alone.front().columns.empty());
    EXPECT_EQ(alone[1].columns.front().front().block, 0u);
    EXPECT_FALSE(SheetArrangement(blocks, 60.0).getSheets().front().columns.empty());
}

TEST(SheetArrangementTest, NoPictureIsLargerThanTheModel)
{
    const std::vector<SheetBlock> blocks{createBlock(11.0, {4.0, 3.0})};
    EXPECT_DOUBLE_EQ(SheetArrangement(blocks, 0.0).getSheets()[0].columns[0][0].pitch, 8.0);
}

TEST(SheetArrangementTest, ABlockThatIsHigherThanASheetHasASmallerPicture)
{
    std::vector<SheetBlock> blocks(4, createBlock(11.0, {30.0, 20.0}));
    blocks[1].heads.fill(SheetArrangement::HEIGHT - SheetArrangement::PICTURE_SPACE - SheetArrangement::LEAST_PICTURE);
    const SheetArrangement arrangement(blocks, 0.0);
    for (const Sheet& sheet : arrangement.getSheets())
        for (const SheetColumn& column : sheet.columns)
            for (const PlacedBlock& place : column)
                EXPECT_LE(place.height, SheetArrangement::HEIGHT + 1e-6);
}

TEST(SheetArrangementTest, FeetTakeTheirHeightFromTheColumnsOfTheirSheets)
{
    const auto getFoot = [](std::size_t first, std::size_t end)
    {
        return std::min(SheetArrangement::MOST_FOOT,
                        4.0 * static_cast<double>(end - first) + (first % 3 == 0 ? 9.0 : 0.0));
    };
    for (unsigned seed = 0; seed < 20; ++seed)
    {
        const std::vector<SheetBlock> blocks = createSteps(5 + 2 * seed, 10.0 + 2.0 * seed, seed);
        const double header = 6.0 * seed;
        const SheetArrangement arrangement(blocks, header, SheetBlock::MOST_COLUMNS, getFoot);
        std::size_t next = 0;
        for (const Sheet& sheet : arrangement.getSheets())
        {
            if (sheet.columns.empty()) continue; // below a high header
            const std::size_t first = sheet.columns.front().front().block;
            EXPECT_EQ(first, next) << seed;
            next = sheet.columns.back().back().block + 1;
            const double space = SheetArrangement::HEIGHT - (&sheet == &arrangement.getSheets().front() ? header : 0.0);
            for (const SheetColumn& column : sheet.columns)
                EXPECT_LE(measure(column), space - getFoot(first, next) + 1e-6) << seed;
        }
        EXPECT_EQ(next, blocks.size()) << seed;
    }
}

TEST(SheetArrangementTest, TheHighestBlockAndTheHighestFootFitOnASheet)
{
    std::vector<SheetBlock> blocks(3, createBlock(SheetArrangement::MOST_HEAD, {30.0, 30.0}));
    const auto getFoot = [](std::size_t, std::size_t) { return SheetArrangement::MOST_FOOT; };
    const std::vector<Sheet> sheets = SheetArrangement(blocks, 0.0, 1, getFoot).getSheets();
    ASSERT_EQ(sheets.size(), 3u);
    for (const Sheet& sheet : sheets)
    {
        EXPECT_LE(measure(sheet.columns[0]), SheetArrangement::HEIGHT - SheetArrangement::MOST_FOOT + 1e-6);
        EXPECT_GE(30.0 * sheet.columns[0][0].pitch, SheetArrangement::LEAST_PICTURE - 1e-6);
    }
}

TEST(SheetArrangementTest, AHeadingIsOnTheSheetOfItsBlock)
{
    // Two sheets either way: of four and three blocks, or of three and four, if the fourth one is a heading.
    std::vector<SheetBlock> blocks(7, createBlock(36.0, {}));
    const auto findSizeOfFirst = [&blocks]
    { return SheetArrangement(blocks, 0.0, 1).getSheets().front().columns[0].size(); };
    const std::size_t usual = findSizeOfFirst();
    blocks[usual - 1].isHeading = true;
    EXPECT_EQ(findSizeOfFirst(), usual == 4 ? 3u : 4u);
}

TEST(SheetArrangementTest, AHeadingIsOnTheSheetOfItsBlockEvenIfThatNeedsAnotherSheet)
{
    // Two sheets of three blocks, or three of two with larger pictures, if the third one is a heading.
    std::vector<SheetBlock> blocks(6, createBlock(20.0, {60.0, 18.0}));
    EXPECT_EQ(SheetArrangement(blocks, 0.0, 1).getSheets().size(), 2u);
    blocks[2].isHeading = true;
    EXPECT_EQ(SheetArrangement(blocks, 0.0, 1).getSheets().size(), 3u);
}

TEST(SheetArrangementTest, AHeadingIsInTheColumnOfItsBlock)
{
    // Two columns of three blocks, or of two and four, if the third one is a heading.
    std::vector<SheetBlock> blocks(6, createBlock(36.0, {}));
    for (SheetBlock& block : blocks)
        block.heads[0] = SheetFilling::IMPOSSIBLE;
    ASSERT_EQ(SheetArrangement(blocks, 0.0, 2).getSheets().front().columns.front().size(), 3u);
    blocks[2].isHeading = true;
    const std::size_t size = SheetArrangement(blocks, 0.0, 2).getSheets().front().columns.front().size();
    EXPECT_TRUE(size == 2 || size == 4) << size;
}

} // namespace osgLego
