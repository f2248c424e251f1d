#include "ForgedBytes.h"

#include <osgLego/BrickCodec.h>

#include <common/RacingCar.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/GridLimits.h>

#include <Meshes.h>
#include <Notices.h>
#include <PartModels.h>
#include <Settings.h>

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <zlib.h>

namespace osgLego::test
{

namespace
{

Brick createBrick(int x, int y, int z, std::array<std::uint8_t, 3> color = {10, 20, 30})
{
    Brick brick;
    brick.cell = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(z)};
    brick.color = color;
    return brick;
}

BrickGrid createGrid(const glm::ivec3& dimensions)
{
    BrickGrid grid;
    grid.dimensions = dimensions;
    grid.origin = {-1.1, 1e-300, 4e5};
    grid.cellSize = {0.1, 0.1, 0.04};
    return grid;
}

void expectEqualAfterDecoding(const BrickModel& model)
{
    std::string error;
    const osg::ref_ptr<const BrickModel> decoded = decodeBricks(encodeBricks(model), error);
    ASSERT_TRUE(decoded) << error;
    EXPECT_TRUE(error.empty());
    EXPECT_EQ(decoded->getGrid(), model.getGrid());
    EXPECT_TRUE(decoded->getBricks() == model.getBricks());
    EXPECT_TRUE(decoded->getParts() == model.getParts());
    EXPECT_TRUE(decoded->getPartIndices() == model.getPartIndices());
}

std::string errorOf(const std::string& bytes)
{
    std::string error;
    EXPECT_FALSE(decodeBricks(bytes, error));
    return error;
}

// Places in the bytes.
constexpr std::size_t DIMENSIONS = 8;
constexpr std::size_t UP_AXIS = 20;
constexpr std::size_t ORIGIN = 21;
constexpr std::size_t CELL_SIZE = 45;
constexpr std::size_t NUM_BRICKS = 69;
constexpr std::size_t DATA_SIZE = 77;

class BrickCodec : public ::testing::Test
{
protected:
    osg::ref_ptr<const BrickModel> _car = legolizeOnCpu(*createRacingCar(), parseSettings("20,proportions=plate"));
    std::string _bytes = encodeBricks(*_car);

    /** The bytes with other lengths of cells. */
    std::string withCells(double length) const
    {
        return forge(_bytes, CELL_SIZE, toBytes(length) + toBytes(length) + toBytes(length));
    }
};

TEST_F(BrickCodec, ModelsAreEqualAfterDecoding)
{
    for (const char* settings : {"1", "7,up=y", "64", "100,proportions=plate", "64,proportions=brick,up=y"})
    {
        SCOPED_TRACE(settings);
        for (const osg::ref_ptr<osg::Node>& mesh :
             {createRacingCar(), createSphere(), createTorus(), createThinPlate(), createSliverSoup()})
            expectEqualAfterDecoding(*legolizeOnCpu(*mesh, parseSettings(settings)));
    }
}

TEST_F(BrickCodec, TheBunnyIsEqualAfterDecodingAndTakesLessThanHalfAByteForEachBrick)
{
    const osg::ref_ptr<osg::Node> bunny = readBunny();
    if (!bunny) GTEST_SKIP() << "the bunny is missing";
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*bunny, parseSettings("64,up=y"));
    expectEqualAfterDecoding(*model);
    EXPECT_LT(2 * encodeBricks(*model).size(), model->getBricks().size());
}

TEST_F(BrickCodec, ModelsOfRandomBricksAreEqualAfterDecoding)
{
    std::mt19937 engine(5);
    for (const unsigned int density : {1u, 10u, 50u, 90u, 100u})
    {
        const glm::ivec3 size(13, 17, 11);
        std::vector<Brick> bricks;
        for (int number = 0; number < size.x * size.y * size.z; ++number)
            if (engine() % 100 < density)
                bricks.push_back(
                    createBrick(number % size.x, number / size.x % size.y, number / size.x / size.y,
                                {static_cast<std::uint8_t>(engine()), static_cast<std::uint8_t>(engine()), 255}));
        expectEqualAfterDecoding(*BrickModel::create(createGrid(size), bricks));
    }
}

TEST_F(BrickCodec, EmptyModelsAndTheCornersOfTheLargestGridAreEqualAfterDecoding)
{
    expectEqualAfterDecoding(*BrickModel::create(BrickGrid(), {}));
    expectEqualAfterDecoding(*BrickModel::create(createGrid({4, 5, 6}), {}));
    const BrickGrid largest = createGrid(GridLimits::getLargest(2));
    expectEqualAfterDecoding(*BrickModel::create(largest, {createBrick(0, 0, 0)}));
    expectEqualAfterDecoding(*BrickModel::create(largest, {createBrick(0, 0, 0), createBrick(1023, 0, 0),
                                                           createBrick(0, 1023, 1), createBrick(1023, 1023, 2559)}));
}

TEST_F(BrickCodec, TheCheckSumIsCrc32)
{
    EXPECT_EQ(forge(_bytes, 0, _bytes.substr(0, 1)), _bytes);
}

TEST_F(BrickCodec, ChangingAnyByteIsAnError)
{
    for (std::size_t place = 0; place < _bytes.size(); ++place)
        for (const char change : {'\x01', '\x80', '\xff'})
        {
            std::string damaged = _bytes;
            damaged[place] = static_cast<char>(damaged[place] ^ change);
            EXPECT_NE(errorOf(damaged).find("damaged or incomplete"), std::string::npos) << place;
        }
}

TEST_F(BrickCodec, TruncatingAndAppendingIsAnError)
{
    for (std::size_t size = 0; size < _bytes.size(); ++size)
        EXPECT_NE(errorOf(_bytes.substr(0, size)).find("damaged or incomplete"), std::string::npos) << size;
    EXPECT_NE(errorOf(_bytes + '\0').find("damaged or incomplete"), std::string::npos);
}

TEST_F(BrickCodec, ANewerVersionIsNamed)
{
    EXPECT_EQ(
        errorOf(forge(_bytes, 0, "\x03")),
        "the stored bricks have version 3 of their format; expected version 1 or 2, or a newer osgLego to read them");
}

TEST_F(BrickCodec, ImpossibleValuesAreErrorsEvenIfTheCheckSumIsRight)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const std::string huge(8, '\x7f');
    const std::vector<std::string> forged{forge(_bytes, DIMENSIONS, std::string(12, '\0')),
                                          forge(_bytes, DIMENSIONS, std::string(1, '\x01')),
                                          forge(_bytes, UP_AXIS, std::string(1, '\0')),
                                          forge(_bytes, UP_AXIS, "\x03"),
                                          forge(_bytes, ORIGIN, toBytes(-infinity)),
                                          forge(_bytes, ORIGIN + 16, toBytes(std::nan(""))),
                                          forge(_bytes, CELL_SIZE, toBytes(0.0)),
                                          forge(_bytes, CELL_SIZE + 8, toBytes(-1.0)),
                                          forge(_bytes, CELL_SIZE + 16, toBytes(infinity)),
                                          forge(_bytes, NUM_BRICKS, huge),
                                          forge(_bytes, NUM_BRICKS, std::string(1, _bytes[NUM_BRICKS] - 1)),
                                          forge(_bytes, DATA_SIZE, huge),
                                          forge(_bytes, DATA_SIZE, std::string(1, _bytes[DATA_SIZE] + 1)),
                                          forge(_bytes.substr(0, DATA_SIZE), 0, ""),
                                          forge(_bytes.substr(0, DATA_SIZE + 20), 0, ""),
                                          forge(_bytes, DATA_SIZE + 8, "no zlib data")};
    for (std::size_t index = 0; index < forged.size(); ++index)
        EXPECT_NE(errorOf(forged[index]).find("contradict"), std::string::npos) << index;
}

TEST_F(BrickCodec, GridsTooFarAwayToBeDrawnAreNotRead)
{
    for (const std::string& forged : {forge(_bytes, ORIGIN, toBytes(-1e300)), forge(_bytes, ORIGIN + 8, toBytes(5e18))})
        EXPECT_NE(errorOf(forged).find("model units; expected at most 4e+18"), std::string::npos) << errorOf(forged);
    const std::string large = withCells(1e300);
    EXPECT_NE(errorOf(large).find("model units; expected at most 4e+18"), std::string::npos) << errorOf(large);
    std::string error;
    EXPECT_TRUE(decodeBricks(forge(withCells(1e17), ORIGIN, toBytes(-1e18)), error)) << error;
}

TEST_F(BrickCodec, GridsTooSmallToBeDrawnWhereTheyAreAreNotRead)
{
    const std::string expected = " model units; expected at least ";
    for (const std::string& forged : {withCells(1e-15), withCells(1e-300), forge(_bytes, ORIGIN, toBytes(-1e12)),
                                      forge(_bytes, ORIGIN, toBytes(1e18))})
        EXPECT_NE(errorOf(forged).find(expected), std::string::npos) << errorOf(forged);
    std::string small = withCells(1e-21);
    for (std::size_t axis = 0; axis < 3; ++axis)
        small = forge(small, ORIGIN + 8 * axis, toBytes(0.0));
    EXPECT_NE(errorOf(small).find(expected + "1e-18"), std::string::npos) << errorOf(small);
    std::string error;
    EXPECT_TRUE(decodeBricks(withCells(0.1), error)) << error;
}

TEST_F(BrickCodec, GridsBeyondTheLimitsAreNeitherWrittenNorRead)
{
    for (const int up : {1, 2})
        for (int axis = 0; axis < 3; ++axis)
        {
            BrickGrid grid = createGrid(GridLimits::getLargest(up));
            grid.cellSize = {0.1, 0.1, 0.1};
            grid.upAxis = up == 1 ? UpAxis::Y : UpAxis::Z;
            const std::string largest = encodeBricks(*BrickModel::create(grid, {createBrick(0, 0, 0)}));
            std::string error;
            EXPECT_TRUE(decodeBricks(largest, error)) << error;
            ++grid.dimensions[axis];
            const std::string expected = "expected at most " + GridLimits::describe(up) + " in stored bricks";
            const auto number = static_cast<std::uint64_t>(grid.dimensions[axis]);
            const std::string larger =
                forge(largest, DIMENSIONS + 4 * static_cast<std::size_t>(axis), toBytes(number).substr(0, 4));
            EXPECT_NE(errorOf(larger).find(expected), std::string::npos) << errorOf(larger);
            const std::string notices =
                noticesOf([&] { EXPECT_EQ(encodeBricks(*BrickModel::create(grid, {createBrick(0, 0, 0)})), ""); });
            EXPECT_NE(notices.find(expected), std::string::npos) << notices;
        }
    EXPECT_EQ(errorOf(forge(_bytes, DIMENSIONS, std::string(12, '\x7f'))),
              "the bricks are in a grid of 2139062143 x 2139062143 x 2139062143 cells; expected at most " +
                  GridLimits::describe(2) + " in stored bricks");
}

TEST_F(BrickCodec, TooManyBricksAreAnErrorBeforeTheyNeedMemory)
{
    const std::uint64_t count = GridLimits::MOST_BRICKS + 1;
    EXPECT_EQ(errorOf(forge(_bytes, NUM_BRICKS, toBytes(count) + toBytes(3 * count))),
              "there are 67108865 bricks; expected at most 67108864 in stored bricks");
}

TEST_F(BrickCodec, CellsFarLongerThanWideAreNeitherWrittenNorRead)
{
    BrickGrid grid = createGrid({4, 4, 4});
    for (const double length : {0.1 / 5.0, 0.1 * 5.0, 1e9, 1e-9})
    {
        grid.cellSize = {0.1, 0.1, length};
        EXPECT_NE(errorOf(forge(_bytes, CELL_SIZE, toBytes(0.1) + toBytes(0.1) + toBytes(length)))
                      .find("times as long as wide; expected at most 4 times"),
                  std::string::npos);
        noticesOf([&] { EXPECT_EQ(encodeBricks(*BrickModel::create(grid, {createBrick(0, 0, 0)})), ""); });
    }
}

TEST_F(BrickCodec, BricksOutsideTheGridOrTwiceInACellAreErrors)
{
    const BrickGrid grid = createGrid({4, 4, 4});
    for (const std::vector<Brick>& bricks :
         {std::vector<Brick>{createBrick(0, 0, 4)}, std::vector<Brick>{createBrick(3, 3, 3), createBrick(0, 0, 4)},
          std::vector<Brick>{createBrick(1, 1, 1), createBrick(1, 1, 1)},
          std::vector<Brick>{createBrick(2, 1, 1), createBrick(1, 1, 1)}})
        EXPECT_NE(errorOf(encodeBricks(*BrickModel::createComplete(grid, bricks))).find("contradict"),
                  std::string::npos);
}

Part createPart(const glm::ivec3& cell, const glm::ivec3& size, std::int32_t code = Part::NO_CODE)
{
    Part part;
    for (int axis = 0; axis < 3; ++axis)
    {
        part.cell[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(cell[axis]);
        part.size[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(size[axis]);
    }
    part.color = {10, 20, 30};
    part.colorCode = code;
    return part;
}

/** Whether the parts are within the grid and do not overlap. */
bool arePossible(const BrickModel& model)
{
    std::size_t numCells = 0;
    for (const Part& part : model.getParts())
    {
        for (int axis = 0; axis < 3; ++axis)
            if (part.getCell()[axis] + part.getSize()[axis] > model.getGrid().dimensions[axis]) return false;
        numCells += static_cast<std::size_t>(part.size[0] * part.size[1] * part.size[2]);
    }
    const std::vector<Brick>& bricks = model.getBricks();
    const auto isSame = [](const Brick& a, const Brick& b) { return a.cell == b.cell; };
    return model.getParts().empty() ||
           (numCells == bricks.size() && std::adjacent_find(bricks.begin(), bricks.end(), isSame) == bricks.end());
}

/** The bytes of a number of parts in a large grid, with these data and the right check sum. */
std::string storeParts(std::uint64_t count, const std::string& data)
{
    const std::string good = encodeBricks(
        *BrickModel::createOfParts(createGrid(GridLimits::getLargest(2)), {createPart({0, 0, 0}, {1, 1, 1})}));
    std::string compressed(compressBound(data.size()), '\0');
    uLongf size = compressed.size();
    compress(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
             data.size());
    return forge(good.substr(0, NUM_BRICKS) + toBytes(count) + toBytes(std::uint64_t(data.size())) +
                     compressed.substr(0, size),
                 0, "");
}

/** The data of parts of one size, each this number of cells, below 128, after the one before. */
std::string createPartData(std::size_t count, char step, const glm::ivec3& size)
{
    std::string data(count, step);
    for (int axis = 0; axis < 3; ++axis)
        data += std::string(count, static_cast<char>(size[axis]));
    return data + std::string(7 * count, '\0'); // their colours and codes
}

/** Models of parts, in version 2 of the format. */
class PartCodec : public ::testing::Test
{
protected:
    static osg::ref_ptr<const BrickModel> createModel(const glm::ivec3& size, UpAxis up = UpAxis::Z)
    {
        PartFilling filling;
        filling.heights = {1, 3};
        filling.colors = {{200, 30, 20}, {240, 240, 235}, {20, 80, 170}};
        filling.isCovered = [](const glm::ivec3& cell) { return (cell.x / 5 + cell.y / 4 + cell.z / 3) % 3 != 0; };
        return createParts(createPartGrid(size, 0.4, up), filling);
    }

    osg::ref_ptr<const BrickModel> _model = createModel({9, 7, 6});
    std::string _bytes = encodeBricks(*_model);
};

TEST_F(PartCodec, PartsAreEqualAfterDecoding)
{
    EXPECT_EQ(_bytes[0], 2);
    expectEqualAfterDecoding(*_model);
    expectEqualAfterDecoding(*createModel({40, 30, 20}, UpAxis::Y));
    constexpr std::int32_t LARGEST = std::numeric_limits<std::int32_t>::max();
    expectEqualAfterDecoding(*BrickModel::createOfParts(
        createGrid(GridLimits::getLargest(2)),
        {createPart({1016, 1022, 2557}, {8, 2, 3}, LARGEST), createPart({0, 0, 0}, {1, 1, 1}),
         createPart({0, 0, 1}, {3, 16, 1}, std::numeric_limits<std::int32_t>::min())}));
}

TEST_F(PartCodec, CellsAreStillInVersion1)
{
    const osg::ref_ptr<const BrickModel> cells = createCells(*_model);
    EXPECT_EQ(encodeBricks(*cells)[0], 1);
    expectEqualAfterDecoding(*cells);
    EXPECT_FALSE(cells->findPart(cells->getBricks().front().getCell()));
}

TEST_F(PartCodec, ALayoutTakesLessThanFourBytesForEachPart)
{
    const osg::ref_ptr<const BrickModel> model = createModel({60, 60, 30});
    EXPECT_LT(encodeBricks(*model).size(), 4 * model->getParts().size());
}

TEST_F(PartCodec, ChangingOrRemovingAnyByteIsAnError)
{
    for (std::size_t place = 0; place < _bytes.size(); ++place)
    {
        EXPECT_NE(errorOf(_bytes.substr(0, place)).find("damaged or incomplete"), std::string::npos) << place;
        std::string damaged = _bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ '\x10');
        EXPECT_NE(errorOf(damaged).find("damaged or incomplete"), std::string::npos) << place;
    }
}

TEST_F(PartCodec, ChangingAnyByteAndTheCheckSumIsAnErrorOrAPossibleModel)
{
    int numErrors = 0;
    for (std::size_t place = 0; place < _bytes.size(); ++place)
        for (int bit = 0; bit < 8; ++bit)
        {
            std::string error;
            const char changed = static_cast<char>(_bytes[place] ^ (1 << bit));
            const osg::ref_ptr<const BrickModel> model =
                decodeBricks(forge(_bytes, place, std::string(1, changed)), error);
            EXPECT_EQ(model == nullptr, !error.empty()) << place;
            EXPECT_TRUE(!model || arePossible(*model)) << place;
            numErrors += model ? 0 : 1;
        }
    EXPECT_GT(numErrors, static_cast<int>(_bytes.size()));
}

TEST_F(PartCodec, ImpossiblePartsAreErrorsEvenIfTheCheckSumIsRight)
{
    const BrickGrid grid = createGrid({40, 40, 40});
    for (const std::vector<Part>& parts :
         {std::vector<Part>{createPart({39, 0, 0}, {2, 1, 1})}, std::vector<Part>{createPart({0, 38, 0}, {1, 3, 1})},
          std::vector<Part>{createPart({0, 0, 38}, {1, 1, 3})}, std::vector<Part>{createPart({0, 0, 0}, {0, 1, 1})},
          std::vector<Part>{createPart({0, 0, 0}, {1, 1, 0})},
          std::vector<Part>{createPart({1, 1, 1}, {1, 1, 1}), createPart({1, 1, 1}, {1, 1, 1})},
          std::vector<Part>{createPart({0, 0, 0}, {4, 2, 3}), createPart({3, 1, 2}, {2, 2, 1})},
          std::vector<Part>{createPart({0, 0, 0}, {1, 1, 1}), createPart({0, 0, 40}, {1, 1, 1})}})
        EXPECT_EQ(errorOf(encodeBricks(*BrickModel::createOfParts(grid, parts))),
                  "the stored parts contradict their grid; expected parts within it that do not overlap");
    for (const std::string& forged :
         {forge(_bytes, DIMENSIONS, std::string(12, '\0')), forge(_bytes, DIMENSIONS, std::string(1, '\x01')),
          forge(_bytes, NUM_BRICKS, std::string(8, '\x7f')), forge(_bytes, DATA_SIZE, std::string(8, '\x7f')),
          forge(_bytes, NUM_BRICKS, std::string(1, _bytes[NUM_BRICKS] - 1)),
          forge(_bytes, NUM_BRICKS, std::string(1, _bytes[NUM_BRICKS] + 1)), forge(_bytes, 0, "\x01")})
        EXPECT_NE(errorOf(forged).find("contradict"), std::string::npos);
}

TEST_F(PartCodec, PartsOfMoreThan48CellsAreNeitherWrittenNorRead)
{
    const std::string expected = "a part has 49 cells; expected at most 48 in each part of stored bricks";
    const osg::ref_ptr<const BrickModel> model =
        BrickModel::createOfParts(createGrid({40, 40, 40}), {createPart({0, 0, 0}, {7, 7, 1})});
    const std::string notices = noticesOf([&] { EXPECT_EQ(encodeBricks(*model), ""); });
    EXPECT_NE(notices.find(expected), std::string::npos) << notices;
    EXPECT_EQ(errorOf(storeParts(1, createPartData(1, 0, {7, 7, 1}))), expected);
    std::string error;
    EXPECT_TRUE(decodeBricks(storeParts(1, createPartData(1, 0, {6, 8, 1})), error)) << error;
}

TEST_F(PartCodec, PartsOfMoreCellsThanAFilledModelAreAnErrorBeforeTheyNeedMemory)
{
    EXPECT_EQ(errorOf(storeParts(1398102, createPartData(1398102, 1, {1, 1, 48}))),
              "there are 67108896 cells of parts; expected at most 67108864 in stored bricks");
}

TEST_F(PartCodec, OverlappingPartsAreAnErrorAndPartsSideBySideAreNot)
{
    for (const std::string& stored :
         {storeParts(2, createPartData(2, 0, {1, 1, 1})), storeParts(100000, createPartData(100000, 0, {2, 8, 3})),
          storeParts(9, createPartData(9, 1, {2, 1, 1}))})
        EXPECT_EQ(errorOf(stored),
                  "the stored parts contradict their grid; expected parts within it that do not overlap");
    std::string error;
    const osg::ref_ptr<const BrickModel> model = decodeBricks(storeParts(9, createPartData(9, 2, {2, 8, 3})), error);
    ASSERT_TRUE(model) << error;
    EXPECT_EQ(model->getBricks().size(), 9u * 48u);
}

} // namespace

} // namespace osgLego::test
