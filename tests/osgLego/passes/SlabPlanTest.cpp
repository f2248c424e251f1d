#include <osgLego/passes/SlabPlan.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

class SlabPlanOfTexels : public ::testing::TestWithParam<int>
{
};

TEST_P(SlabPlanOfTexels, CoversEveryLayerOnceAndIncludesItsNeighboursWithin128MiB)
{
    const int texelBytes = GetParam();
    for (const glm::ivec3& size : {glm::ivec3(1), glm::ivec3(64, 50, 30), glm::ivec3(256), glm::ivec3(257, 256, 256),
                                   glm::ivec3(1024), glm::ivec3(1024, 2560, 1024), glm::ivec3(1024, 1024, 2560)})
    {
        BrickGrid grid;
        grid.dimensions = size;
        const SlabPlan plan = SlabPlan::create(grid, texelBytes);
        const std::size_t texels =
            static_cast<std::size_t>(plan.imageSize.x) * static_cast<std::size_t>(plan.imageSize.y);
        EXPECT_LE(texels, std::size_t(1) << 24);
        EXPECT_LE(texels * static_cast<std::size_t>(texelBytes), std::size_t(128) << 20);
        int next = 0;
        for (const Slab& slab : plan.slabs)
        {
            EXPECT_EQ(slab.begin, next);
            EXPECT_GT(slab.end, slab.begin);
            EXPECT_EQ(slab.imageBegin, std::max(slab.begin - 1, 0));
            EXPECT_EQ(slab.imageEnd, std::min(slab.end + 1, size.z));
            const auto cells = static_cast<std::size_t>(slab.imageEnd - slab.imageBegin) *
                               static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
            EXPECT_LE(cells, texels);
            next = slab.end;
        }
        EXPECT_EQ(next, size.z);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SlabPlanOfTexels, ::testing::Values(4, 8, 16));

TEST(SlabPlan, ASmallGridIsOneSlab)
{
    BrickGrid grid;
    grid.dimensions = glm::ivec3(256);
    EXPECT_EQ(SlabPlan::create(grid, 8).slabs.size(), 1u);
}

TEST(SlabPlan, AnEmptyGridHasNoSlabs)
{
    EXPECT_TRUE(SlabPlan::create(BrickGrid(), 8).slabs.empty());
}

} // namespace

} // namespace osgLego
