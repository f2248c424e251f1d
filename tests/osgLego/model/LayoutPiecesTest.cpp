#include <osgLego/model/LayoutPieces.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(LayoutPieces, AreHeldTogetherByStudsAndNotByTouchingSides)
{
    // Two towers side by side, the second of a single part, and a part across two parts far away.
    const LaidParts parts{{{0, 0, 0}}, {{1, 0, 0}, {1, 1, 1}}, {{4, 0, 0}, {2, 1, 1}}, {{6, 0, 0}, {2, 1, 1}},
                          {{0, 0, 1}}, {{5, 0, 1}, {2, 1, 1}}};
    const LayoutPieces pieces(parts);
    ASSERT_EQ(pieces.getCount(), 3u);
    EXPECT_EQ(pieces.getCells(0).size(), 6u) << "the largest piece comes first";
    EXPECT_EQ(pieces.getCells(1).size(), 2u);
    EXPECT_EQ(pieces.getCells(2).size(), 1u);
    EXPECT_EQ(pieces.countParts(0), 3u);
    EXPECT_EQ(pieces.countParts(1), 2u);
    EXPECT_EQ(pieces.find({7, 0, 0}), 0u);
    EXPECT_EQ(pieces.find({0, 0, 1}), 1u);
    EXPECT_EQ(pieces.find({1, 0, 0}), 2u);
    EXPECT_EQ(pieces.find({1, 0, 1}), LayoutPieces::NONE);
}

TEST(LayoutPieces, OfNoPartsAreNone)
{
    EXPECT_EQ(LayoutPieces({}).getCount(), 0u);
}

} // namespace

} // namespace osgLego
