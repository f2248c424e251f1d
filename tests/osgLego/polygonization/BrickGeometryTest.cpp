#include <osgLego/BrickGeometry.h>
#include <osgLego/CpuLegolizer.h>

#include <Meshes.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <osg/TriangleFunctor>

namespace osgLego
{

namespace
{

/** Sums up, triangle by triangle, the volume that a surface encloses and its area. */
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
    settings.resolution = 12;
    settings.proportions = proportions;
    settings.upAxis = up;
    return legolizeOnCpu(*test::createSphere(), settings);
}

/** The sum over all studs of how high their feet lie, along the up axis, and how many there are. */
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
            // Of a stud with sixteen sides.
            const double disk = 8.0 * radius * radius * std::sin(std::numbers::pi / 8.0);
            const double stud = disk * BrickDimensions::STUD_HEIGHT * pitch;
            const double cell = grid.cellSize.x * grid.cellSize.y * grid.cellSize.z;
            const auto [feet, numStuds] = sumOfStudFeet(*model);
            const double expected = cell * static_cast<double>(model->getBricks().size()) + stud * numStuds;
            // A stud stands on its brick and has no foot of its own, which would add this to the flux.
            measure.volume -= disk * feet / 3.0;
            EXPECT_NEAR(measure.volume, expected, 1e-4 * expected);
        }
}

TEST(BrickGeometry, FacesForPickingAreThoseOfTheOpenSides)
{
    const osg::ref_ptr<const BrickModel> model = createModel(Proportions::CUBE, UpAxis::Z);
    osg::TriangleFunctor<Measure> measure;
    acceptBrickFaces(*model, measure);
    double sides = 0.0;
    for (const Brick& brick : model->getBricks())
        sides += __builtin_popcount(brick.openSides);
    const double pitch = model->getGrid().getPitch();
    EXPECT_NEAR(measure.area, sides * pitch * pitch, 1e-3);
    EXPECT_NEAR(measure.volume, pitch * pitch * pitch * static_cast<double>(model->getBricks().size()), 1e-3);
}

} // namespace

} // namespace osgLego
