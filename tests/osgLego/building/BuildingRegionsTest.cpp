#include <osgLego/building/BuildingRegions.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(BuildingRegions, RegionsCountAsOneIfMostCellsOfEachMirrorTheOther)
{
    // Two legs below a roof that mirrors itself. Of the one on the right, 1/1, 1/2 or 1/3 mirrors the one on the left.
    for (const int depth : {1, 2, 3})
    {
        const std::vector<BuildingBox> boxes{{{0, 0, 2}, {5, 8, 3}},
                                             {{0, 0, 0}, {1, 1, 1}},
                                             {{0, 0, 1}, {1, 1, 2}},
                                             {{4, 0, 0}, {5, depth, 1}},
                                             {{4, 0, 1}, {5, depth, 2}}};
        const Symmetry symmetry(boxes);
        ASSERT_TRUE(symmetry.hasPlane());
        const BuildingRegions regions(boxes, symmetry);
        EXPECT_EQ(regions.getRank(1), 0u);
        EXPECT_EQ(regions.getRank(2), 0u);
        const std::uint32_t rank = depth == 1 ? 0 : 1;
        EXPECT_EQ(regions.getRank(3), rank) << depth;
        EXPECT_EQ(regions.getRank(4), rank) << depth;
        EXPECT_EQ(regions.getRank(0), rank + 1) << depth;
    }
}

} // namespace

} // namespace osgLego::test
