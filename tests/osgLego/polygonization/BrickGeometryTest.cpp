#include <osgLego/BrickGeometry.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/polygonization/BrickTriangles.h>

#include <Meshes.h>

#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <osg/TriangleFunctor>

namespace osgLego
{

namespace
{

/** Sums the enclosed volume and the area of a surface, triangle by triangle. */
struct Measure
{
    double volume = 0.0;
    double area = 0.0;
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        const osg::Vec3d first(a);
        const osg::Vec3d cross = (osg::Vec3d(b) - first) ^ (osg::Vec3d(c) - first);
        volume += first * cross / 6.0;
        area += 0.5 * cross.length();
    }
};

osg::ref_ptr<const BrickModel> createModel(Proportions proportions, UpAxis up)
{
    LegoSettings settings;
    settings.grid.resolution = 12;
    settings.grid.proportions = proportions;
    settings.grid.upAxis = up;
    return legolizeOnCpu(*test::createSphere(), settings);
}

/** The sum of the heights of all studs' feet along the up axis, and the number of studs. */
std::pair<double, int> sumOfStudFeet(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    const int up = grid.getUpIndex();
    double sum = 0.0;
    int count = 0;
    for (const Brick& brick : model.getBricks())
    {
        if (!(brick.openSides & (SIDE_RIGHT << (2 * up)))) continue;
        sum += grid.origin[up] + grid.cellSize[up] * (brick.cell[static_cast<std::size_t>(up)] + 1.0);
        ++count;
    }
    return {sum, count};
}

TEST(BrickGeometry, EnclosesTheVolumeOfBricksAndStudsWindingOutwards)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (const Proportions proportions : {Proportions::CUBE, Proportions::BRICK, Proportions::PLATE})
        {
            const osg::ref_ptr<const BrickModel> model = createModel(proportions, up);
            const BrickGrid& grid = model->getGrid();
            osg::TriangleFunctor<Measure> measure;
            createBrickGeometry(*model)->accept(measure);

            const double pitch = grid.getPitch();
            const double radius = BrickDimensions::STUD_RADIUS * pitch;
            // The area of a stud with sixteen sides.
            const double disk = 8.0 * radius * radius * std::sin(std::numbers::pi / 8.0);
            const double stud = disk * BrickDimensions::STUD_HEIGHT * pitch;
            const double cell = grid.cellSize.x * grid.cellSize.y * grid.cellSize.z;
            const auto [feet, numStuds] = sumOfStudFeet(*model);
            const double expected = cell * static_cast<double>(model->getBricks().size()) + stud * numStuds;
            // Studs have no bottom face, which would add this to the flux.
            measure.volume -= disk * feet / 3.0;
            EXPECT_NEAR(measure.volume, expected, 1e-4 * expected);
        }
}

/** Stores the triangles passed to it. */
struct Triangles
{
    std::vector<std::array<osg::Vec3, 3>> corners;
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        corners.push_back({a, b, c});
    }
};

TEST(BrickGeometry, AFunctorGetsTheTrianglesOfTheGeometryInTheirOrder)
{
    const osg::ref_ptr<const BrickModel> model = createModel(Proportions::BRICK, UpAxis::Z);
    osg::TriangleFunctor<Triangles> ofModel;
    acceptBrickTriangles(*model, ofModel);
    osg::TriangleFunctor<Triangles> ofGeometry;
    createBrickGeometry(*model)->accept(ofGeometry);
    EXPECT_GT(ofModel.corners.size(), 8192u) << "more than one portion";
    EXPECT_EQ(ofModel.corners, ofGeometry.corners);
}

TEST(BrickGeometry, TheModelOfNoBricksHasNoTriangles)
{
    osg::TriangleFunctor<Triangles> none;
    acceptBrickTriangles(*BrickModel::create(BrickGrid(), {}), none);
    EXPECT_TRUE(none.corners.empty());
    EXPECT_FALSE(findBrickTriangle(*BrickModel::create(BrickGrid(), {}), 0));
}

TEST(BrickGeometry, EveryTriangleIsFoundToLieOnItsBrickAndSide)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
    {
        const osg::ref_ptr<const BrickModel> model = createModel(Proportions::PLATE, up);
        const BrickGrid& grid = model->getGrid();
        osg::TriangleFunctor<Triangles> triangles;
        acceptBrickTriangles(*model, triangles);
        for (std::size_t index = 0; index < triangles.corners.size(); ++index)
        {
            const auto& [a, b, c] = triangles.corners[index];
            const std::optional<BrickTriangle> found = findBrickTriangle(*model, index);
            ASSERT_TRUE(found) << index;
            const int axis = std::countr_zero(static_cast<unsigned int>(found->side)) / 2;
            const bool isUpper = std::countr_zero(static_cast<unsigned int>(found->side)) % 2 == 1;
            // The middle of the triangle, from the lowest corner of the cell, in cells.
            const glm::dvec3 place = grid.toCells((a + b + c) / 3.0f) - glm::dvec3(found->brick.getCell());
            for (int other = 0; other < 3; ++other)
            {
                if (other == axis) continue;
                ASSERT_GT(place[other], 0.0) << index;
                ASSERT_LT(place[other], 1.0) << index;
            }
            if (found->isStud)
                ASSERT_GT(place[axis], 1.0 + 0.3 * grid.getStudHeight()) << index;
            else
                ASSERT_NEAR(place[axis], isUpper ? 1.0 : 0.0, 1e-4) << index;
            ASSERT_FALSE(found->isStud && axis != grid.getUpIndex()) << index;
        }
        EXPECT_FALSE(findBrickTriangle(*model, triangles.corners.size()));
    }
}

} // namespace

} // namespace osgLego
