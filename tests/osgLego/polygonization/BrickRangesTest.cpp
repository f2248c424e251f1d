#include <osgLego/BrickModel.h>
#include <osgLego/polygonization/BrickRanges.h>

#include <gtest/gtest.h>
#include <osg/Matrixd>

namespace osgLego::test
{

namespace
{

/** A block of one colour of bricks, from a cell to another. */
BrickBlock createBlock(int number, const glm::ivec3& minimum, const glm::ivec3& maximum, std::uint8_t openSides)
{
    return {100 * number, 10, minimum, maximum, openSides};
}

class Ranges : public ::testing::Test
{
protected:
    Ranges() { _grid.dimensions = glm::ivec3(64); }

    /** The numbers of the blocks found. */
    std::vector<int> find(const std::vector<BrickBlock>& blocks, const osg::Vec3d& eye, const osg::Vec3d& target,
                          Faces faces = Faces::FRONT,
                          std::uint32_t numPlaced = std::numeric_limits<std::uint32_t>::max())
    {
        const osg::Matrixd view = osg::Matrixd::lookAt(eye, target, osg::Vec3d(0.1, 0, 1));
        const CellView cellView(_grid, _grid.getCellsToModel() * view, osg::Matrixd::perspective(40, 1.5, 1, 1000));
        _ranges.find(blocks, _grid, cellView, faces, numPlaced);
        _ranges.sortFrontToBack();
        std::vector<int> numbers;
        for (std::size_t range = 0; range < _ranges.getAll().firsts.size(); ++range)
        {
            EXPECT_EQ(_ranges.getAll().counts[range], 10);
            numbers.push_back(_ranges.getAll().firsts[range] / 100);
        }
        return numbers;
    }

    BrickGrid _grid;
    BrickRanges _ranges;
};

using Numbers = std::vector<int>;

TEST_F(Ranges, AreThoseInThePictureTheNearestFirst)
{
    const std::vector<BrickBlock> blocks{createBlock(0, {0, 0, 0}, {7, 7, 7}, 63),
                                         createBlock(1, {32, 0, 0}, {39, 7, 7}, 63),
                                         createBlock(2, {56, 56, 56}, {63, 63, 63}, 63)};
    EXPECT_EQ(find(blocks, {32, -200, 32}, {32, 0, 32}), (Numbers{1, 0, 2}));
    EXPECT_EQ(find(blocks, {4, -20, 4}, {4, 0, 4}), (Numbers{0}));
    EXPECT_EQ(find(blocks, {4, -20, 4}, {4, -40, 4}), Numbers());
}

TEST_F(Ranges, LeaveOutWhatIsTurnedAway)
{
    const std::vector<BrickBlock> blocks{createBlock(0, {0, 8, 0}, {7, 15, 7}, SIDE_BACK),
                                         createBlock(1, {16, 8, 0}, {23, 15, 7}, SIDE_FRONT)};
    EXPECT_EQ(find(blocks, {8, -100, 4}, {8, 0, 4}), (Numbers{1}));
    EXPECT_EQ(find(blocks, {8, 100, 4}, {8, 0, 4}), (Numbers{0}));
    EXPECT_EQ(find(blocks, {-30, 12, 4}, {8, 12, 4}).size(), 2u) << "level with the bricks";
    EXPECT_EQ(find(blocks, {8, -100, 4}, {8, 0, 4}, Faces::ALL).size(), 2u);
}

TEST_F(Ranges, OfBackFacesLeaveOutWhatIsTurnedToTheEye)
{
    const std::vector<BrickBlock> blocks{createBlock(0, {0, 8, 0}, {7, 15, 7}, SIDE_BACK),
                                         createBlock(1, {16, 8, 0}, {23, 15, 7}, SIDE_FRONT),
                                         createBlock(2, {32, 8, 0}, {39, 15, 7}, SIDE_FRONT | SIDE_TOP)};
    EXPECT_EQ(find(blocks, {8, -100, 4}, {8, 0, 4}, Faces::BACK), (Numbers{0, 2})) << "studs have a back";
    EXPECT_EQ(find(blocks, {8, 100, 4}, {8, 0, 4}, Faces::BACK), (Numbers{1, 2}));
    EXPECT_EQ(find(blocks, {-30, 12, 4}, {8, 12, 4}, Faces::BACK).size(), 3u) << "level with the bricks";
}

TEST_F(Ranges, AreThoseWithCellsThatAreVisibleWithThePartsInPlace)
{
    std::vector<BrickBlock> blocks{createBlock(0, {0, 0, 0}, {7, 7, 7}, 63),
                                   createBlock(1, {32, 0, 0}, {39, 7, 7}, 63)};
    blocks[1].firstRank = 4;
    blocks[1].lastRank = 9;
    const auto findWith = [&](std::uint32_t numPlaced) {
        return find(blocks, {32, -200, 32}, {32, 0, 32}, Faces::FRONT, numPlaced);
    };
    EXPECT_EQ(findWith(0), Numbers());
    EXPECT_EQ(findWith(4), Numbers{0});
    EXPECT_EQ(findWith(5), (Numbers{1, 0}));
    EXPECT_EQ(findWith(9), (Numbers{1, 0}));
    EXPECT_EQ(findWith(10), Numbers{0});
}

TEST_F(Ranges, KeepStudsThatAreSeenFromBelow)
{
    const std::vector<BrickBlock> blocks{createBlock(0, {0, 0, 0}, {7, 7, 7}, SIDE_TOP)};
    EXPECT_EQ(find(blocks, {4, -50, 20}, {4, 4, 4}), (Numbers{0}));
    EXPECT_EQ(find(blocks, {4, -50, -10}, {4, 4, 4}), (Numbers{0}));
    EXPECT_EQ(find(blocks, {4, -2, -100}, {4, 4, 4}), Numbers());
}

TEST_F(Ranges, TellBricksWithStudsThatAreSeenFromOthers)
{
    const std::vector<BrickBlock> blocks{createBlock(0, {0, 0, 0}, {7, 7, 7}, SIDE_TOP | SIDE_FRONT),
                                         createBlock(1, {8, 0, 0}, {15, 7, 7}, SIDE_FRONT)};
    find(blocks, {8, -50, 20}, {8, 4, 4});
    EXPECT_EQ(_ranges.getStudded().firsts, Numbers{0});
    EXPECT_EQ(_ranges.getOthers().firsts, Numbers{100});
    find(blocks, {8, -12, -60}, {8, 4, 4});
    EXPECT_TRUE(_ranges.getStudded().firsts.empty());
    EXPECT_EQ(_ranges.getOthers().firsts, (Numbers{0, 100}));
}

} // namespace

} // namespace osgLego::test
