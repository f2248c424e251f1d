#include <osgLego/data/OcclusionVolume.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A byte of an image, as a fraction. */
double readFraction(const osg::Image& image, const glm::ivec3& voxel, int channel)
{
    return image.data(static_cast<unsigned int>(voxel.x), static_cast<unsigned int>(voxel.y),
                      static_cast<unsigned int>(voxel.z))[channel] /
           255.0;
}

bool isAny(const glm::ivec3&)
{
    return true;
}

TEST(OcclusionVolume, StoresTheMeanAndTheBendOfAVoxel)
{
    OcclusionVolume volume({2, 3, 4});
    volume.set({1, 2, 3}, {{0.2f, 0.4f, 0.6f}, {-0.4f, 0.0f, 0.4f}, 0.8f}, OcclusionVolume::ALL);
    const auto images = volume.createImages();
    for (const osg::ref_ptr<osg::Image>& image : images)
    {
        ASSERT_EQ(image->s(), 2);
        ASSERT_EQ(image->t(), 3);
        ASSERT_EQ(image->r(), 4);
    }
    for (int channel = 0; channel < 4; ++channel)
    {
        EXPECT_NEAR(readFraction(*images[0], {1, 2, 3}, channel), 0.2 + 0.2 * channel, 0.002);
        EXPECT_EQ(readFraction(*images[0], {0, 2, 3}, channel), 0.0) << "another voxel";
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        EXPECT_NEAR(readFraction(*images[1], {1, 2, 3}, axis) - 128.0 / 255.0, 0.4 * (axis - 1), 0.002);
        EXPECT_EQ(readFraction(*images[1], {0, 2, 3}, axis), 128.0 / 255.0) << "another voxel";
    }
}

TEST(OcclusionVolume, FillsVoxelsFromTheirNeighbors)
{
    OcclusionVolume volume(glm::ivec3(5));
    volume.set({1, 2, 2}, {glm::vec3(0.2f), glm::vec3(0.0f), 0.2f}, OcclusionVolume::ALL);
    volume.set({3, 3, 3}, {glm::vec3(0.6f), glm::vec3(0.0f), 0.6f}, OcclusionVolume::ALL);
    volume.fillFromNeighbors(OcclusionVolume::Neighbors::ALL, isAny);
    const auto images = volume.createImages();
    EXPECT_NEAR(readFraction(*images[0], {2, 2, 2}, 0), 0.4, 0.003) << "beside both";
    EXPECT_NEAR(readFraction(*images[0], {0, 1, 1}, 3), 0.2, 0.003) << "beside the first";
    EXPECT_NEAR(readFraction(*images[0], {1, 2, 2}, 0), 0.2, 0.003) << "keeps its own";
    EXPECT_EQ(readFraction(*images[0], {0, 4, 4}, 0), 0.0) << "beside none";
}

TEST(OcclusionVolume, FillsSurfacesFromNeighborsInTheSamePlane)
{
    OcclusionVolume volume(glm::ivec3(5));
    volume.set({2, 2, 2}, {glm::vec3(0.4f), glm::vec3(0.0f), 0.0f}, OcclusionVolume::ALL);
    volume.fillFromNeighbors(OcclusionVolume::Neighbors::IN_PLANE,
                             [](const glm::ivec3& voxel) { return voxel.x > 0 && voxel.y < 3; });
    const auto images = volume.createImages();
    for (int axis = 0; axis < 3; ++axis)
    {
        EXPECT_NEAR(readFraction(*images[0], {1, 2, 2}, axis), axis == 0 ? 0.0 : 0.4, 0.003) << axis;
        EXPECT_NEAR(readFraction(*images[0], {2, 1, 2}, axis), axis == 1 ? 0.0 : 0.4, 0.003) << axis;
        EXPECT_NEAR(readFraction(*images[0], {2, 2, 3}, axis), axis == 2 ? 0.0 : 0.4, 0.003) << axis;
        EXPECT_EQ(readFraction(*images[0], {1, 1, 2}, axis), 0.0) << "at an edge";
        EXPECT_EQ(readFraction(*images[0], {2, 3, 2}, axis), 0.0) << "not to be filled";
    }
}

TEST(OcclusionVolume, BlocksHaveTheMeanOfTheirVoxelsThatHaveLight)
{
    OcclusionVolume volume({5, 4, 4});
    volume.set({0, 0, 0}, {glm::vec3(0.2f), glm::vec3(0.0f), 0.0f}, OcclusionVolume::ALL);
    volume.set({1, 1, 1}, {glm::vec3(0.4f), glm::vec3(0.0f), 0.0f}, OcclusionVolume::ALL);
    volume.set({2, 2, 2}, {glm::vec3(0.9f), glm::vec3(0.0f), 0.0f}, OcclusionVolume::ALL);
    volume.fillFromBlocks();
    const auto images = volume.createImages();
    EXPECT_NEAR(readFraction(*images[0], {1, 0, 1}, 0), 0.3, 0.005) << "the block of two voxels";
    EXPECT_NEAR(readFraction(*images[0], {3, 2, 3}, 0), 0.9, 0.005) << "the block of one";
    EXPECT_NEAR(readFraction(*images[0], {3, 0, 0}, 0), 0.6, 0.005) << "the block of both";
    EXPECT_NEAR(readFraction(*images[0], {4, 0, 0}, 0), 0.6, 0.005) << "the whole volume";
}

} // namespace

} // namespace osgLego::test
