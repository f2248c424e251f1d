#include <osgLego/passes/PassPlan.h>

#include <Meshes.h>
#include <Settings.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** The plan for a sphere of 4 * rings * (rings - 1) triangles. */
PassPlan planOf(const char* text, int rings)
{
    std::string error;
    const osg::ref_ptr<const LegoSource> source =
        LegoSource::create(*SceneTriangles::create(*createSphere(rings)), parseSettings(text), error);
    EXPECT_TRUE(source) << error;
    return PassPlan::create(*source);
}

/** The size of a texel of the voxel image. */
int texelBytesOf(const char* settings, int rings)
{
    return bytesOf(planOf(settings, rings).format);
}

TEST(PassPlan, PointsNeedAColourPerCell)
{
    EXPECT_EQ(texelBytesOf("64,method=points", 24), 4);
    EXPECT_EQ(texelBytesOf("64,method=points,target=addressed", 24), 4);
    EXPECT_EQ(texelBytesOf("16,method=points", 100), 4);
}

TEST(PassPlan, ExactVoxelizationSumsUpHalfFloats)
{
    EXPECT_EQ(texelBytesOf("64", 24), 8); // 119 cells per triangle
    EXPECT_EQ(texelBytesOf("1024", 24), 8);
}

TEST(PassPlan, ExactVoxelizationOfManyTrianglesPerCellSumsUpFloatsUnlessTheyTakeTooMuchMemory)
{
    EXPECT_EQ(texelBytesOf("64,edge=1", 24), 16);
    EXPECT_EQ(texelBytesOf("32", 24), 16);   // 15 cells per triangle
    EXPECT_EQ(texelBytesOf("200", 400), 16); // 8,000,000 cells
    EXPECT_EQ(texelBytesOf("210", 400), 8);  // 9,261,000 cells, 15 per triangle, would take more than 128 MiB
}

TEST(PassPlan, APaletteNeedsAPassForDominantColoursUnlessThereIsOnlyOneColourPerCell)
{
    EXPECT_FALSE(planOf("64", 24).findsDominantColors());
    EXPECT_TRUE(planOf("64,palette=ldraw", 24).findsDominantColors());
    EXPECT_EQ(planOf("64,palette=ldraw", 24).getExtractedFormat(), VoxelFormat::COLOR);
    EXPECT_EQ(planOf("64", 24).getExtractedFormat(), VoxelFormat::HALF_SUMS);
    EXPECT_FALSE(planOf("64,palette=ldraw,method=points", 24).findsDominantColors());
}

TEST(PassPlan, TheImagesOfAPaletteTakeNoMoreThan128MiBTogether)
{
    EXPECT_EQ(texelBytesOf("170,palette=ldraw", 400), 16); // 4,913,000 cells of 24 bytes
    EXPECT_EQ(texelBytesOf("180,palette=ldraw", 400), 8);  // 5,832,000 cells would take more than 128 MiB
    for (const char* settings : {"180,palette=ldraw", "300,palette=ldraw", "1024,palette=ldraw"})
    {
        const PassPlan plan = planOf(settings, 24);
        const std::size_t texels =
            static_cast<std::size_t>(plan.imageSize.x) * static_cast<std::size_t>(plan.imageSize.y);
        EXPECT_LE(texels * 16, std::size_t(128) << 20) << settings;
    }
    EXPECT_EQ(planOf("180,palette=ldraw", 24).numSlabs, 1u);
    EXPECT_GT(planOf("240,palette=ldraw", 24).numSlabs, 1u); // 13,824,000 cells of 16 bytes
    EXPECT_EQ(planOf("240", 24).numSlabs, 1u);
}

} // namespace

} // namespace osgLego::test
