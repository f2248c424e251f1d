#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/data/DistantOcclusion.h>
#include <osgLego/data/OcclusionCurve.h>

#include <common/BrickRayCaster.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** @param height of a cell, in pitches. */
osg::ref_ptr<const BrickModel> createModel(const glm::ivec3& dimensions,
                                           const std::function<bool(glm::ivec3)>& isCovered, double height = 1.0)
{
    BrickGrid grid;
    grid.dimensions = dimensions;
    grid.cellSize.z = height;
    std::vector<Brick> bricks;
    for (int z = 0; z < dimensions.z; ++z)
        for (int y = 0; y < dimensions.y; ++y)
            for (int x = 0; x < dimensions.x; ++x)
            {
                if (!isCovered({x, y, z})) continue;
                bricks.emplace_back();
                bricks.back().cell = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                      static_cast<std::uint16_t>(z)};
            }
    return BrickModel::create(grid, bricks);
}

class DistantOcclusionOf
{
public:
    explicit DistantOcclusionOf(const BrickModel& model, NearOcclusion near = NearOcclusion::PICTURE) :
        _occlusion(DistantOcclusion::create(model.getGrid(), createBrickPoints(model).points, near))
    {
    }

    /** The hidden fraction in the voxel of a cell, for a surface that faces an end of an axis. */
    double getHidden(const glm::ivec3& cell, int axis, bool upper) const
    {
        const double bend = getByte(getBend(), cell, axis) - 128.0 / 255.0;
        return getMean(cell, axis) + (upper ? bend : -bend);
    }
    /** Likewise, without a difference between both directions. */
    double getMean(const glm::ivec3& cell, int axis) const { return getByte(getMean(), cell, axis); }
    double getHiddenFromTop(const glm::ivec3& cell) const { return getHidden(cell, 2, true); }
    double getDistant(const glm::ivec3& cell) const { return getByte(getMean(), cell, 3); }
    const osg::Image& getMean() const { return _occlusion->getMean(); }
    const osg::Image& getBend() const { return _occlusion->getBend(); }
    bool includesNear() const { return _occlusion->includesNear(); }
    const glm::ivec3& getCellsPerVoxel() const { return _occlusion->getCellsPerVoxel(); }

private:
    double getByte(const osg::Image& image, const glm::ivec3& cell, int channel) const
    {
        const glm::ivec3 place = cell / _occlusion->getCellsPerVoxel() + DistantOcclusion::BORDER;
        return image.data(static_cast<unsigned int>(place.x), static_cast<unsigned int>(place.y),
                          static_cast<unsigned int>(place.z))[channel] /
               255.0;
    }

    osg::ref_ptr<const DistantOcclusion> _occlusion;
};

const glm::dvec3 UP(0, 0, 1);

/** The fraction of light that bricks beyond the reach of near occlusion hide from the middle of a cell. */
double castRays(const BrickModel& model, const glm::ivec3& cell, const glm::dvec3& normal)
{
    const BrickRayCaster caster(model);
    const double reach = DistantOcclusion::getReach(model.getGrid());
    const auto visibilityWithin = [&](double radius)
    {
        return caster
            .sampleOcclusion(glm::dvec3(cell) + 0.5, normal, radius, AmbientOcclusionSettings::FALLOFF, 4096, 1)
            .visibility;
    };
    return visibilityWithin(AmbientOcclusionSettings::RADIUS_IN_BRICKS) - visibilityWithin(reach);
}

TEST(DistantOcclusion, AFloorHidesNothingFromItsTop)
{
    const DistantOcclusionOf occlusion(*createModel({32, 32, 8}, [](const glm::ivec3& cell) { return cell.z == 0; }));
    for (const int x : {2, 9, 16, 29})
        EXPECT_NEAR(occlusion.getHiddenFromTop({x, 16, 1}), 0.0, 0.005) << x;
}

TEST(DistantOcclusion, ARoofHidesAsMuchAsRaysCastAtIt)
{
    const osg::ref_ptr<const BrickModel> model =
        createModel({40, 40, 12}, [](const glm::ivec3& cell)
                    { return cell.z == 0 || (cell.z == 7 && cell.x >= 10 && cell.x < 30 && cell.y >= 10); });
    const DistantOcclusionOf occlusion(*model);
    for (const glm::ivec3& cell :
         {glm::ivec3(20, 20, 1), glm::ivec3(10, 20, 1), glm::ivec3(5, 20, 1), glm::ivec3(20, 4, 1)})
        EXPECT_NEAR(occlusion.getHiddenFromTop(cell), castRays(*model, cell, UP), 0.08) << cell.x << " " << cell.y;
    EXPECT_GT(castRays(*model, {20, 20, 1}, UP), 0.3) << "the roof hides nothing";
}

TEST(DistantOcclusion, SurfacesThatFaceAWallAreHidden)
{
    const DistantOcclusionOf occlusion(
        *createModel({32, 32, 16}, [](const glm::ivec3& cell) { return cell.z == 0 || cell.x == 20; }));
    EXPECT_GT(occlusion.getHidden({15, 16, 1}, 0, true), occlusion.getHidden({15, 16, 1}, 0, false) + 0.1)
        << "a wall towards +x";
    EXPECT_NEAR(occlusion.getHidden({15, 16, 1}, 1, true), occlusion.getHidden({15, 16, 1}, 1, false), 0.05);
    EXPECT_GT(occlusion.getHidden({25, 16, 1}, 0, false), occlusion.getHidden({25, 16, 1}, 0, true) + 0.1)
        << "the wall towards -x";
}

TEST(DistantOcclusion, WithoutBricksThereIsNone)
{
    for (const NearOcclusion near : {NearOcclusion::PICTURE, NearOcclusion::GRID})
    {
        const DistantOcclusionOf occlusion(*createModel({4, 4, 4}, [](const glm::ivec3&) { return false; }), near);
        for (int cell = 0; cell < 4; ++cell)
            for (int axis = 0; axis < 3; ++axis)
                for (const bool upper : {false, true})
                    EXPECT_EQ(occlusion.getHidden(glm::ivec3(cell), axis, upper), 0.0);
    }
}

/** Cells of which about one in five is covered. */
osg::ref_ptr<const BrickModel> createScatteredModel(double height)
{
    auto random = std::make_shared<std::mt19937>(7);
    return createModel(
        {14, 14, 14}, [random](const glm::ivec3&) { return (*random)() % 5 == 0; }, height);
}

class FaceOcclusionOf : public testing::TestWithParam<double>
{
};

INSTANTIATE_TEST_SUITE_P(Heights, FaceOcclusionOf, testing::Values(0.4, 1.0, 1.2));

TEST_P(FaceOcclusionOf, CellsIsTheLightThatRaysFindInTheirMiddle)
{
    const osg::ref_ptr<const BrickModel> model = createScatteredModel(GetParam());
    const DistantOcclusionOf occlusion(*model, NearOcclusion::GRID);
    ASSERT_TRUE(occlusion.includesNear());
    const BrickRayCaster caster(*model);
    // The rays also meet studs, which are half as high as a plate.
    const double most = GetParam() < 1.0 ? 0.16 : 0.1;
    int numFaces = 0;
    double sum = 0.0;
    for (const Brick& brick : model->getBricks())
        for (int axis = 0; axis < 3; ++axis)
        {
            glm::ivec3 step(0);
            step[axis] = 1;
            const glm::ivec3 front = brick.getCell() - step;
            if (model->find(front) || model->find(front - step) || glm::any(glm::lessThan(front, glm::ivec3(0))))
                continue;
            glm::dvec3 place = glm::dvec3(front) + 0.5;
            place[axis] += 0.5;
            const double expected = 1.0 - caster
                                              .sampleOcclusion(place * model->getGrid().cellSize, -glm::dvec3(step),
                                                               DistantOcclusion::getReach(model->getGrid()),
                                                               AmbientOcclusionSettings::FALLOFF, 1024, 1)
                                              .visibility;
            const double found = OcclusionCurve::decode(occlusion.getMean(front, axis));
            sum += std::abs(found - expected);
            EXPECT_NEAR(found, expected, most) << front.x << ' ' << front.y << ' ' << front.z << ", axis " << axis;
            ++numFaces;
        }
    ASSERT_GT(numFaces, 500);
    EXPECT_LT(sum / numFaces, 0.2 * most);
}

TEST(DistantOcclusion, LargeGridsHaveLargeVoxels)
{
    BrickGrid grid;
    grid.dimensions = {1024, 1024, 2560};
    grid.cellSize = {1.0, 1.0, 0.4};
    const osg::ref_ptr<const DistantOcclusion> occlusion = DistantOcclusion::create(grid, {}, NearOcclusion::PICTURE);
    EXPECT_LE(occlusion->getMean().s(), DistantOcclusion::MAXIMUM_SIZE + 2 * DistantOcclusion::BORDER);
    EXPECT_LE(occlusion->getMean().r(), DistantOcclusion::MAXIMUM_SIZE + 2 * DistantOcclusion::BORDER);
    EXPECT_EQ(occlusion->getCellsPerVoxel(), glm::ivec3(16, 16, 40));
}

TEST(DistantOcclusion, VoxelsOfTheGridAreNoLargerThanTheLimitAsks)
{
    BrickGrid grid;
    grid.dimensions = {132, 132, 132};
    const auto createFor = [&](NearOcclusion near) { return DistantOcclusion::create(grid, {}, near); };
    EXPECT_EQ(createFor(NearOcclusion::GRID)->getCellsPerVoxel(), glm::ivec3(2));
    EXPECT_EQ(createFor(NearOcclusion::PICTURE)->getCellsPerVoxel(), glm::ivec3(3));
}

TEST(DistantOcclusion, VoxelsAreCellsInAllProportionsUnlessThereAreTooMany)
{
    const auto isOfCells = [](const glm::ivec3& dimensions, double height)
    {
        BrickGrid grid;
        grid.dimensions = dimensions;
        grid.cellSize.z = height;
        const osg::ref_ptr<const DistantOcclusion> occlusion = DistantOcclusion::create(grid, {}, NearOcclusion::GRID);
        EXPECT_EQ(occlusion->includesNear(), occlusion->getCellsPerVoxel() == glm::ivec3(1));
        return occlusion->includesNear();
    };
    EXPECT_TRUE(isOfCells({64, 64, 160}, 0.4));
    EXPECT_TRUE(isOfCells({100, 100, 84}, 1.2));
    EXPECT_TRUE(isOfCells({128, 128, 128}, 1.0));
    EXPECT_TRUE(isOfCells({200, 20, 20}, 1.0)) << "a long side alone costs little";
    EXPECT_FALSE(isOfCells({128, 128, 320}, 0.4)) << "more than 128 x 128 x 128 cells";
    EXPECT_FALSE(isOfCells({260, 4, 4}, 1.0)) << "the side of a texture";
    EXPECT_FALSE(isOfCells({240, 240, 34}, 1.0)) << "margins for rays of 60 cells";
}

} // namespace

} // namespace osgLego::test
