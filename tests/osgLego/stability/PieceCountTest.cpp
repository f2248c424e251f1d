#include <osgLego/PieceCount.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

Part createPart(std::uint16_t x, std::uint16_t z, std::uint8_t width)
{
    Part part;
    part.cell = {x, 0, z};
    part.size = {width, 1, 1};
    return part;
}

/** Two towers, a part on one of them, and two parts in the air. */
osg::ref_ptr<const BrickModel> createPieces()
{
    BrickGrid grid;
    grid.dimensions = {20, 1, 10};
    return BrickModel::createOfParts(grid, {createPart(0, 2, 2), createPart(4, 2, 2), createPart(5, 3, 2),
                                            createPart(12, 5, 1), createPart(16, 7, 1)});
}

} // namespace

TEST(PieceCount, OnATableIsThatOfPartsThatStudsHoldTogether)
{
    EXPECT_EQ(countPieces(*createPieces(), BuildingBase::TABLE), 4u);
}

TEST(PieceCount, OnABasePlateCountsThePiecesOnItOnce)
{
    EXPECT_EQ(countPieces(*createPieces(), BuildingBase::PLATE), 3u);
}

TEST(PieceCount, InAnOrderCountsThePiecesOfThePartsInPlace)
{
    // A bridge: its arch comes last, and joins both towers and the part on it.
    BrickGrid grid;
    grid.dimensions = {20, 1, 10};
    const osg::ref_ptr<const BrickModel> bridge = BrickModel::createOfParts(
        grid, {createPart(0, 0, 2), createPart(4, 0, 2), createPart(0, 1, 6), createPart(3, 2, 2)});
    const std::vector<std::uint32_t> order{1, 3, 0, 2};
    using Counts = std::vector<std::size_t>;
    EXPECT_EQ(countPiecesInOrder(*bridge, order, BuildingBase::TABLE), (Counts{1, 2, 3, 1}));
    EXPECT_EQ(countPiecesInOrder(*bridge, order, BuildingBase::PLATE), (Counts{1, 2, 2, 1}));
    EXPECT_EQ(countPiecesInOrder(*bridge, std::span(order).first(2), BuildingBase::TABLE), (Counts{1, 2}));
}

} // namespace osgLego::test
