#include "CellDifferences.h"

#include <common/RacingCar.h>
#include <osgLego/cpu/CpuVoxelizer.h>

#include <CellClipping.h>
#include <GlTest.h>
#include <Meshes.h>

#include <array>
#include <cstdio>
#include <functional>
#include <random>

#include <osg/Geometry>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

struct Model
{
    const char* name;
    std::function<osg::ref_ptr<osg::Node>()> create;
    int largestColorError = 1; //!< of half floats, in levels of 255
};

class ExactVoxelization : public GlTest, public ::testing::WithParamInterface<Model>
{
};

/** Legolize on the CPU; print and check the differences from the GPU's result. */
void expectSame(const char* name, osg::Node& node, const LegoSettings& settings, const BrickModel& gpu,
                const LegoStatistics& statistics)
{
    const osg::ref_ptr<const GridTriangles> triangles = GridTriangles::create(*SceneTriangles::create(node), settings);
    const osg::ref_ptr<const BrickModel> cpu = voxelizeOnCpu(*triangles);
    const CellDifferences differences = compare(*triangles, *cpu, gpu);
    const double share =
        100.0 * static_cast<double>(differences.offColor) / static_cast<double>(cpu->getBricks().size());
    std::printf(
        "%-10s %-28s %8zu triangles %8zu fine %8zu cells %8zu drawn %3zu differ within the margin, %.3f %% off by "
        "more than 2/255 in colour\n",
        name, settings.toString().c_str(), triangles->getNumTriangles(), statistics.numFineTriangles,
        cpu->getBricks().size(), statistics.numDrawnBricks, differences.within, share);
    EXPECT_EQ(differences.beyond, 0u);
    EXPECT_LT(share, 1.0);
    EXPECT_EQ(statistics.numDrawnBricks, gpu.getNumVisible());
}

TEST_P(ExactVoxelization, FindsTheCellsAndColoursOfTheCpu)
{
    const osg::ref_ptr<osg::Node> node = GetParam().create();
    if (!node) GTEST_SKIP() << "the model could not be fetched";
    for (const char* text : {"16", "32", "64", "128", "50,proportions=brick", "50,proportions=plate,up=y",
                             "64,edge=0.5", "64,edge=1", "64,edge=4"})
    {
        const LegoSettings settings = parseSettings(text);
        LegoStatistics statistics;
        const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings, &statistics);
        ASSERT_TRUE(gpu);
        expectSame(GetParam().name, *node, settings, *gpu, statistics);
    }
}

/** Coincident triangles of the same colour. */
osg::ref_ptr<osg::Geometry> createLayers(std::size_t count, const osg::Vec3d& corner, double reach,
                                         const osg::Vec4& color)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (std::size_t layer = 0; layer < count; ++layer)
    {
        vertices->push_back(corner);
        vertices->push_back(corner + osg::Vec3d(reach, 0, 0));
        vertices->push_back(corner + osg::Vec3d(0, reach, 0));
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    const osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    colors->insert(colors->end(), vertices->size(), color);
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    return geometry;
}

/** The largest difference in colour of common cells, except one; and the number of cells that differ. */
std::pair<int, std::size_t> compareColors(const BrickModel& expected, const BrickModel& found,
                                          const glm::ivec3& ignored)
{
    int largest = 0;
    std::size_t count = 0;
    for (const Brick& brick : expected.getBricks())
    {
        const Brick* other = brick.getCell() == ignored ? nullptr : found.find(brick.getCell());
        if (!other || other->color == brick.color) continue;
        ++count;
        for (std::size_t channel = 0; channel < 3; ++channel)
            largest = std::max(largest, std::abs(brick.color[channel] - other->color[channel]));
    }
    return {largest, count};
}

TEST_P(ExactVoxelization, HalfFloatsGiveTheColoursOfSinglePrecision)
{
    const osg::ref_ptr<osg::Node> node = GetParam().create();
    if (!node) GTEST_SKIP() << "the model could not be fetched";
    for (const char* text : {"32", "64", "200"})
    {
        const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*node, parseSettings(text));
        ASSERT_TRUE(found);
        // With so many triangles in the cell in the middle, the passes choose single precision.
        const BrickGrid& grid = found->getGrid();
        const osg::Vec3d middle = SceneTriangles::create(*node)->getBounds().center();
        osg::ref_ptr<osg::Group> dense = new osg::Group;
        dense->addChild(node);
        dense->addChild(createLayers(grid.getNumCells() / 16, middle, 0.1 * grid.getPitch(), osg::Vec4(1, 1, 1, 1)));
        const osg::ref_ptr<const BrickModel> expected = legolizeOnGpu(*dense, parseSettings(text));
        ASSERT_TRUE(expected);
        ASSERT_EQ(expected->getGrid().dimensions, grid.dimensions);
        const auto [largest, count] = compareColors(*expected, *found, glm::floor(grid.toCells(middle)));
        std::printf("%-8s %3s: half floats change %zu of %zu cells, by at most %d of 255\n", GetParam().name, text,
                    count, found->getBricks().size(), largest);
        EXPECT_LE(largest, GetParam().largestColorError);
    }
}

INSTANTIATE_TEST_SUITE_P(Models, ExactVoxelization,
                         ::testing::Values(Model{"car", createRacingCar},
                                           Model{"sphere", [] { return createSphere(); }}, Model{"torus", createTorus},
                                           Model{"plate", createThinPlate, 2},
                                           Model{"slivers", [] { return createSliverSoup(); }, 3},
                                           Model{"bunny", readBunny}),
                         [](const auto& instance) { return std::string(instance.param.name); });

class ExactVoxelizationLimits : public GlTest
{
};

TEST_F(ExactVoxelizationLimits, AGridBeyondOneSlabIsTheSame)
{
    const osg::ref_ptr<osg::Node> node = createSphere();
    const LegoSettings settings = parseSettings("300");
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings, &statistics);
    ASSERT_TRUE(gpu);
    expectSame("sphere", *node, settings, *gpu, statistics);
}

TEST_F(ExactVoxelizationLimits, ResolutionOneIsOneBrick)
{
    const osg::ref_ptr<osg::Node> node = createSphere();
    const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, parseSettings("1"));
    ASSERT_TRUE(gpu);
    EXPECT_EQ(gpu->getBricks().size(), 1u);
}

TEST_F(ExactVoxelizationLimits, IsTheSameOnEveryRun)
{
    const osg::ref_ptr<osg::Node> node = createRacingCar();
    for (const char* text : {"48", "48,method=points", "48,method=points,target=addressed"})
    {
        const osg::ref_ptr<const BrickModel> first = legolizeOnGpu(*node, parseSettings(text));
        const osg::ref_ptr<const BrickModel> second = legolizeOnGpu(*node, parseSettings(text));
        ASSERT_TRUE(first && second);
        EXPECT_EQ(first->getBricks(), second->getBricks()) << text;
    }
}

/** Two faces of a cube of 64 cells, each of so many layers. */
osg::ref_ptr<osg::Node> createLayeredFaces(std::size_t numLayers)
{
    osg::ref_ptr<osg::Group> node = new osg::Group;
    for (const double height : {0.0, 64.0})
        node->addChild(createLayers(numLayers, osg::Vec3d(0.0, 0.0, height), 64.0, osg::Vec4(1.0f, 0.8f, 0.4f, 1.0f)));
    return node;
}

TEST_F(ExactVoxelizationLimits, ManyLayersInACellKeepTheirColour)
{
    const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*createLayeredFaces(40), parseSettings("64"));
    ASSERT_TRUE(found);
    EXPECT_GT(found->getBricks().size(), 4000u);
    for (const Brick& brick : found->getBricks())
    {
        EXPECT_NEAR(brick.color[0], 255, 3);
        EXPECT_NEAR(brick.color[1], 204, 3);
        EXPECT_NEAR(brick.color[2], 102, 3);
    }
}

TEST_F(ExactVoxelizationLimits, MoreLayersThanHalfFloatsCanSumKeepTheOrderOfTheChannels)
{
    const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*createLayeredFaces(300), parseSettings("64"));
    ASSERT_TRUE(found);
    EXPECT_GT(found->getBricks().size(), 4000u);
    for (const Brick& brick : found->getBricks())
    {
        ASSERT_GE(brick.color[0], brick.color[1]);
        ASSERT_GT(brick.color[1], brick.color[2]);
    }
}

TEST_F(ExactVoxelizationLimits, FarFromTheOriginTheCellsAreTheSame)
{
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(osg::Matrixd::translate(5e6, -3e6, 1e5));
    node->addChild(createSphere());
    const LegoSettings settings = parseSettings("64");
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings, &statistics);
    ASSERT_TRUE(gpu);
    expectSame("far", *node, settings, *gpu, statistics);
}

TEST_F(ExactVoxelizationLimits, CoincidingCornersKeepTheColour)
{
    const osg::ref_ptr<osg::Node> node = createCoincidingCorners();
    const LegoSettings settings = parseSettings("16");
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings, &statistics);
    ASSERT_TRUE(gpu);
    expectSame("coinciding", *node, settings, *gpu, statistics);
    for (const Brick& brick : gpu->getBricks())
        EXPECT_EQ(brick.color[1], 255);
}

/** Triangles of one colour each, whose corners are corners and centres of cells, so that most of their chords with the
 * faces of cells run along edges of cells or through their corners. */
osg::ref_ptr<osg::Node> createLatticeTriangles(int count)
{
    constexpr int SIZE = 16;
    std::mt19937 engine(3);
    const auto below = [&engine](unsigned int end) { return static_cast<int>(engine() % end); };
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> colors = new osg::Vec4ubArray;
    const auto add = [&](const std::array<glm::ivec3, 3>& halves)
    {
        const osg::Vec4ub color(static_cast<unsigned char>(below(256)), static_cast<unsigned char>(below(256)),
                                static_cast<unsigned char>(below(256)), 255);
        for (const glm::ivec3& corner : halves)
        {
            vertices->push_back(osg::Vec3(osg::Vec3d(corner.x, corner.y, corner.z) * 0.5));
            colors->push_back(color);
        }
    };
    add({glm::ivec3(0), glm::ivec3(2 * SIZE, 0, 0), glm::ivec3(2 * SIZE)}); // fixes the size of the grid
    for (int triangle = 0; triangle < count; ++triangle)
    {
        const glm::ivec3 first(below(2 * SIZE - 8), below(2 * SIZE - 8), below(2 * SIZE - 8));
        add({first, first + glm::ivec3(below(9), below(9), below(9)),
             first + glm::ivec3(below(9), below(9), below(9))});
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    return geometry;
}

/** The total area of all triangles in a cell.
 * @param scale of the triangles about the centre of the cell; a little more than 1 leaves out those in its faces. */
double areaIn(const GridTriangles& triangles, const glm::ivec3& cell, double scale = 1.0)
{
    const glm::dvec3 center = glm::dvec3(cell) + 0.5;
    const auto scaled = [&](const GridVertex& vertex)
    { return glm::vec3(center + scale * (glm::dvec3(vertex.position) - center)); };
    double area = 0.0;
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
            area += areaOf(clipByCell(
                {scaled(batch.vertices[first]), scaled(batch.vertices[first + 1]), scaled(batch.vertices[first + 2])},
                cell));
    return area;
}

/** Whether triangles touch a cell from outside, or lie in its faces, so that rounding decides whether it is found. */
bool isTouched(const GridTriangles& triangles, const Brick& brick)
{
    const glm::ivec3 cell(brick.cell[0], brick.cell[1], brick.cell[2]);
    return areaIn(triangles, cell, 1.001) < 1e-3 && areaIn(triangles, cell, 0.999) > 0.0;
}

TEST_F(ExactVoxelizationLimits, ChordsAlongEdgesOfCellsGiveTheWeightsOfTheCpu)
{
    const osg::ref_ptr<osg::Node> node = createLatticeTriangles(400);
    const bool isExact = isSoftware(*createContext());
    for (const char* text : {"16", "16,edge=0.5", "16,edge=4"})
    {
        const LegoSettings settings = parseSettings(text);
        const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings);
        ASSERT_TRUE(gpu);
        const osg::ref_ptr<const GridTriangles> triangles =
            GridTriangles::create(*SceneTriangles::create(*node), settings);
        const osg::ref_ptr<const BrickModel> cpu = voxelizeOnCpu(*triangles);
        if (isExact)
        {
            ASSERT_EQ(gpu->getBricks().size(), cpu->getBricks().size()) << text;
        }
        for (const Brick& brick : cpu->getBricks())
            EXPECT_TRUE(gpu->find({brick.cell[0], brick.cell[1], brick.cell[2]}) || isTouched(*triangles, brick))
                << text;
        std::size_t weighed = 0;
        std::size_t off = 0;
        for (const Brick& brick : gpu->getBricks())
        {
            const glm::ivec3 cell(brick.cell[0], brick.cell[1], brick.cell[2]);
            const Brick* expected = cpu->find(cell);
            ASSERT_TRUE(expected || isTouched(*triangles, brick)) << text;
            // In a cell that triangles only touch, the weights depend on the subdivision.
            if (!expected || areaIn(*triangles, cell) < 1e-3) continue;
            ++weighed;
            off += isColorOff(brick, *expected) ? 1 : 0;
        }
        EXPECT_GT(weighed, 1000u);
        EXPECT_EQ(off, 0u) << text;
    }
}

/** Tiny triangles, each around a corner of the grid and so in up to eight cells: more than the pass estimates. */
osg::ref_ptr<osg::Node> createCornerTriangles()
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    const float reach = 0.02f;
    // Slightly beside the corner, so that rounding doesn't decide which cells are touched.
    const osg::Vec3 beside(0.003f, 0.002f, 0.001f);
    const auto add = [&](const osg::Vec3& corner)
    {
        const osg::Vec3 center = corner + beside;
        vertices->push_back(center + osg::Vec3(reach, -reach, 0));
        vertices->push_back(center + osg::Vec3(0, reach, -reach));
        vertices->push_back(center + osg::Vec3(-reach, 0, reach));
    };
    for (int x = 1; x < 32; x += 2)
        for (int y = 1; y < 32; y += 2)
            for (int z = 1; z < 32; z += 2)
                add(osg::Vec3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
    // Two triangles that fix the size of the grid.
    for (const float far : {0.0f, 32.0f})
        for (const osg::Vec3& corner : {osg::Vec3(far, far, far), osg::Vec3(16, far, far), osg::Vec3(far, 16, far)})
            vertices->push_back(corner);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    return geometry;
}

TEST_F(ExactVoxelizationLimits, ABrickBufferThatIsTooSmallGrows)
{
    const osg::ref_ptr<osg::Node> node = createCornerTriangles();
    const LegoSettings settings = parseSettings("32");
    const osg::ref_ptr<const GridTriangles> triangles = GridTriangles::create(*SceneTriangles::create(*node), settings);
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings, &statistics);
    ASSERT_TRUE(gpu);
    EXPECT_GT(statistics.numDrawnBricks, triangles->estimateCoveredCells() + 1024)
        << "the buffer would not have to grow";
    expectSame("corners", *node, settings, *gpu, statistics);
}

/** Triangles with every edge just above a power of two times the limit: many more pieces than the pass estimates. */
osg::ref_ptr<osg::Node> createAwkwardTriangles(std::size_t count)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (std::size_t triangle = 0; triangle < count; ++triangle)
    {
        const float z = 64.0f * static_cast<float>(triangle) / static_cast<float>(count);
        vertices->push_back(osg::Vec3(0, 0, z));
        vertices->push_back(osg::Vec3(64, 0, z));
        vertices->push_back(osg::Vec3(62, 1.9f, z));
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    return geometry;
}

TEST_F(ExactVoxelizationLimits, ABufferOfFineTrianglesThatIsTooSmallGrows)
{
    const osg::ref_ptr<osg::Node> node = createAwkwardTriangles(300);
    const LegoSettings settings = parseSettings("64,edge=2");
    const osg::ref_ptr<const GridTriangles> triangles = GridTriangles::create(*SceneTriangles::create(*node), settings);
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings, &statistics);
    ASSERT_TRUE(gpu);
    const std::size_t estimate = triangles->getBatches().front().estimateFineTriangles(2.0);
    EXPECT_GT(statistics.numFineTriangles, estimate + estimate / 4 + 1024) << "the buffer would not have to grow";
    expectSame("awkward", *node, settings, *gpu, statistics);
}

} // namespace

} // namespace osgLego::test
