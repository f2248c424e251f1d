#include <common/RacingCar.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/TriangleOverlap.h>

#include <Meshes.h>

#include <algorithm>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/Texture2D>

namespace osgLego
{

namespace
{

using test::createTriangle;

LegoSettings settingsOf(unsigned int resolution)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    return settings;
}

osg::ref_ptr<osg::Geometry> colored(const osg::ref_ptr<osg::Geometry>& geometry, const osg::Vec4& color)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(1);
    (*colors)[0] = color;
    geometry->setColorArray(colors, osg::Array::BIND_OVERALL);
    return geometry;
}

TEST(CpuLegolizer, MarksTheBricksThatTheMeshDoesNotCover)
{
    const osg::ref_ptr<osg::Node> sphere = test::createSphere(12);
    LegoSettings settings = settingsOf(11);
    settings.grid.proportions = Proportions::BRICK;
    const osg::ref_ptr<const BrickModel> surface = legolizeOnCpu(*sphere, settings);
    settings.parts.set = PartSet::BRICKS;
    for (const Fill fill : {Fill::SURFACE, Fill::SHELL, Fill::SOLID})
        for (const bool support : {false, true})
        {
            settings.parts.fill = fill;
            settings.parts.support = support;
            const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*sphere, settings);
            for (std::size_t brick = 0; brick < model->getBricks().size(); ++brick)
                ASSERT_EQ(model->isAdded(brick), !surface->find(model->getBricks()[brick].getCell()));
        }
}

TEST(CpuLegolizer, CoversExactlyTheCellsThatATriangleOverlaps)
{
    for (const osg::ref_ptr<osg::Node>& node :
         {test::createSphere(12), test::createSliverSoup(40), test::createThinPlate()})
    {
        const osg::ref_ptr<const GridTriangles> triangles =
            GridTriangles::create(*SceneTriangles::create(*node), settingsOf(20));
        const osg::ref_ptr<const BrickModel> model = voxelizeOnCpu(*triangles);
        const glm::ivec3 size = model->getGrid().dimensions;
        std::vector<TriangleOverlap> overlaps;
        for (const GridBatch& batch : triangles->getBatches())
            for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
                overlaps.emplace_back(batch.vertices[first].position, batch.vertices[first + 1].position,
                                      batch.vertices[first + 2].position);
        for (int number = 0; number < size.x * size.y * size.z; ++number)
        {
            const glm::ivec3 cell(number % size.x, number / size.x % size.y, number / size.x / size.y);
            const bool covered = std::any_of(overlaps.begin(), overlaps.end(),
                                             [&](const TriangleOverlap& overlap) { return overlap.overlaps(cell); });
            ASSERT_EQ(model->find(cell) != nullptr, covered);
        }
    }
}

TEST(CpuLegolizer, ASheetFarLongerThanTheGridHasNoGaps)
{
    LegoSettings settings;
    std::string error;
    ASSERT_TRUE(LegoSettings::parse("cell=0.25,origin=-1:-1:-1,size=8:8:8", settings, error)) << error;
    for (const float length : {1e3f, 1e4f, 1e6f, 1e9f})
        for (const float slope : {0.0f, 0.3f, 1.0f, 7.0f})
        {
            // Two triangles, whose common edge crosses the grid.
            const osg::Vec2 along = osg::Vec2(1.0f, slope) * length;
            const osg::Vec2 across(-0.1f * along.y(), 0.1f * along.x());
            const auto corner = [&](float a, float b)
            { return osg::Vec3(a * along.x() + b * across.x(), a * along.y() + b * across.y(), 0.1f); };
            const osg::ref_ptr<osg::Geode> sheet = new osg::Geode;
            sheet->addDrawable(createTriangle(corner(-1, -1), corner(1.1f, 1), corner(-1, 1)));
            sheet->addDrawable(createTriangle(corner(-1, -1), corner(1.1f, -1), corner(1.1f, 1)));
            const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*sheet, settings);
            ASSERT_TRUE(model);
            EXPECT_EQ(model->getBricks().size(), 64u) << length << ", " << slope;
        }
}

TEST(CpuLegolizer, ResolutionOneIsOneBrick)
{
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*test::createSphere(), settingsOf(1));
    ASSERT_EQ(model->getBricks().size(), 1u);
    EXPECT_EQ(model->getBricks()[0].openSides, 63);
}

TEST(CpuLegolizer, ColoursAreWeightedByTheAreaInTheCell)
{
    // Red has twice the area of blue in the same cell.
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(colored(createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {1, 0, 0, 1}));
    geode->addDrawable(colored(createTriangle({0, 0, 0.5}, {0.5, 0, 0.5}, {0, 1, 0.5}), {0, 0, 1, 1}));
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*geode, settingsOf(1));
    ASSERT_EQ(model->getBricks().size(), 1u);
    EXPECT_EQ(model->getBricks()[0].color, (std::array<std::uint8_t, 3>{170, 0, 85}));
}

TEST(CpuLegolizer, ATriangleContributesItsColourNearestTheCentreOfTheCell)
{
    // A wall across four cells, from black on the left to white on the right: each cell has the shade at its centre.
    osg::ref_ptr<osg::Geometry> wall = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    for (const float x : {0.0f, 4.0f})
        for (const float z : {0.0f, 1.0f})
        {
            vertices->push_back(osg::Vec3(x, 0, z));
            colors->push_back(osg::Vec4(x / 4, x / 4, x / 4, 1));
        }
    wall->setVertexArray(vertices);
    wall->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    wall->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*wall, settingsOf(4));
    ASSERT_EQ(model->getBricks().size(), 4u);
    for (int x = 0; x < 4; ++x)
        EXPECT_NEAR(model->find({x, 0, 0})->color[0], 255.0 * (x + 0.5) / 4.0, 12.0);
}

TEST(CpuLegolizer, CoincidingCornersKeepTheColour)
{
    const osg::ref_ptr<osg::Node> node = test::createCoincidingCorners();
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*node, settingsOf(16));
    for (const Brick& brick : model->getBricks())
        EXPECT_EQ(brick.color[1], 255);
}

TEST(CpuLegolizer, ATextureIsFilteredToTheSizeOfACell)
{
    // A chessboard much finer than the cells averages to grey.
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(256, 256, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    for (unsigned int row = 0; row < 256; ++row)
        for (unsigned int column = 0; column < 256; ++column)
            *image->data(column, row) = (row + column) % 2 ? 255 : 0;
    osg::ref_ptr<osg::Geometry> square =
        osg::createTexturedQuadGeometry(osg::Vec3(), osg::Vec3(1, 0, 0), osg::Vec3(0, 1, 0));
    square->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(image));
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*square, settingsOf(8));
    ASSERT_EQ(model->getBricks().size(), 64u);
    for (const Brick& brick : model->getBricks())
        EXPECT_NEAR(brick.color[1], 128, 1);
}

TEST(CpuLegolizer, IsTheSameOnEveryRun)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    EXPECT_EQ(legolizeOnCpu(*car, settingsOf(40))->getBricks(), legolizeOnCpu(*car, settingsOf(40))->getBricks());
}

TEST(CpuLegolizer, IsTheSameWithAnyNumberOfThreads)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    const auto legolize = [&](int numThreads)
    { return oneapi::tbb::task_arena(numThreads).execute([&] { return legolizeOnCpu(*car, settingsOf(100)); }); };
    const osg::ref_ptr<const BrickModel> expected = legolize(1);
    for (const int numThreads : {2, 5})
        EXPECT_EQ(legolize(numThreads)->getBricks(), expected->getBricks()) << numThreads;
}

TEST(CpuLegolizer, FindsTheOpenSides)
{
    for (const unsigned int resolution : {7u, 63u, 64u, 65u, 130u})
    {
        const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*test::createSphere(), settingsOf(resolution));
        EXPECT_EQ(model->getBricks(), BrickModel::create(model->getGrid(), model->getBricks())->getBricks())
            << resolution;
    }
}

TEST(CpuLegolizer, ASymmetricMeshGetsSymmetricBricks)
{
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*createRacingCar(), settingsOf(61));
    const int width = model->getGrid().dimensions.y;
    std::size_t alone = 0;
    for (const Brick& brick : model->getBricks())
        if (!model->find({brick.cell[0], width - 1 - brick.cell[1], brick.cell[2]})) ++alone;
    // Where a surface just reaches a boundary, rounding decides.
    EXPECT_LT(alone, model->getBricks().size() / 50);
}

TEST(CpuLegolizer, FarFromTheOriginTheCellsAreTheSame)
{
    const osg::ref_ptr<osg::Node> sphere = test::createSphere();
    osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrixd::translate(4194304.0, -2097152.0, 65536.0));
    moved->addChild(sphere);
    const auto near = legolizeOnCpu(*sphere, settingsOf(64));
    const auto far = legolizeOnCpu(*moved, settingsOf(64));
    std::size_t different = 0;
    for (const Brick& brick : near->getBricks())
        if (!far->find({brick.cell[0], brick.cell[1], brick.cell[2]})) ++different;
    EXPECT_LE(different, near->getBricks().size() / 500);
}

TEST(CpuLegolizer, ReturnsNullWithoutTrianglesOrWithBadSettings)
{
    EXPECT_FALSE(legolizeOnCpu(*osg::ref_ptr<osg::Group>(new osg::Group), settingsOf(8)));
    EXPECT_FALSE(legolizeOnCpu(*createTriangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), settingsOf(8)));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(legolizeOnCpu(*createTriangle({0, nan, 0}, {1, 1, 1}, {2, 2, 2}), settingsOf(8)));
    EXPECT_FALSE(legolizeOnCpu(*test::createSphere(), settingsOf(0)));
    EXPECT_FALSE(legolizeOnCpu(*test::createSphere(), settingsOf(5000)));
}

TEST(CpuLegolizer, TheFinestGridNeedsNoMemoryForEmptyCells)
{
    const osg::ref_ptr<const BrickModel> model =
        legolizeOnCpu(*createTriangle({0, 0, 0}, {1, 1, 0.999f}, {0, 0.01f, 0}), settingsOf(1024));
    EXPECT_GT(model->getBricks().size(), 1024u);
    EXPECT_LT(model->getBricks().size(), 100000u);
}

} // namespace

} // namespace osgLego
