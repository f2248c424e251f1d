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

} // namespace osgLego::test
