#include <osgLego/passes/PassPlan.h>

#include <Meshes.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** The size of a texel of the voxel image, for a sphere of 4 * rings * (rings - 1) triangles. */
int texelBytesOf(const char* settings, int rings)
{
    const osg::ref_ptr<LegoSource> source = new LegoSource;
    std::string error;
    EXPECT_TRUE(LegoSettings::parse(settings, source->settings, error)) << error;
    source->triangles = GridTriangles::create(*SceneTriangles::create(*createSphere(rings)), source->settings);
    return bytesOf(PassPlan::create(*source).format);
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

} // namespace

} // namespace osgLego::test
