#include <common/RacingCar.h>
#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/TriangleOverlap.h>
#include <osgLego/voxelization/ProjectionPass.h>

#include <GlTest.h>
#include <Meshes.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace osgLego::test
{

namespace
{

struct PointModel
{
    const char* name;
    osg::ref_ptr<osg::Node> (*create)();
};

osg::ref_ptr<const GridTriangles> toGrid(osg::Node& node, const LegoSettings& settings)
{
    return GridTriangles::create(*SceneTriangles::create(node), settings);
}

/** The number of filled cells that no triangle overlaps, except cells that one touches within rounding. */
std::size_t countUnsound(const GridTriangles& triangles, const BrickModel& truth, const BrickModel& found)
{
    constexpr double MARGIN = 1e-4;
    std::size_t count = 0;
    for (const Brick& brick : found.getBricks())
    {
        const glm::ivec3 cell(brick.cell[0], brick.cell[1], brick.cell[2]);
        if (truth.find(cell)) continue;
        bool touched = false;
        for (const GridBatch& batch : triangles.getBatches())
            for (std::size_t first = 0; first < batch.vertices.size() && !touched; first += 3)
                touched = TriangleOverlap(batch.vertices[first].position, batch.vertices[first + 1].position,
                                          batch.vertices[first + 2].position)
                              .getMargin(cell) > -MARGIN;
        if (!touched) ++count;
    }
    return count;
}

double recallOf(const BrickModel& truth, const BrickModel& found)
{
    std::size_t hits = 0;
    for (const Brick& brick : truth.getBricks())
        if (found.find({brick.cell[0], brick.cell[1], brick.cell[2]})) ++hits;
    return static_cast<double>(hits) / static_cast<double>(truth.getBricks().size());
}

/** Whether the segment between the centres of a cell and its upper neighbour along an axis crosses a triangle, well
 * inside both. */
bool crosses(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::ivec3& cell, int axis)
{
    const glm::dvec3 from = glm::dvec3(cell) + 0.5;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (std::abs(normal[axis]) < 1e-9) return false;
    const double along = glm::dot(normal, a - from) / normal[axis];
    if (along < 1e-6 || along > 1.0 - 1e-6) return false;
    glm::dvec3 place = from;
    place[axis] += along;
    const double whole = glm::dot(normal, normal);
    const double u = glm::dot(glm::cross(c - b, place - b), normal) / whole;
    const double v = glm::dot(glm::cross(a - c, place - c), normal) / whole;
    constexpr double INSIDE = 1e-6;
    return u > INSIDE && v > INSIDE && 1.0 - u - v > INSIDE;
}

/** The number of pairs of empty neighbours with a triangle between their centres. */
std::size_t countTunnels(const GridTriangles& triangles, const BrickModel& found)
{
    std::size_t tunnels = 0;
    const glm::ivec3 size = found.getGrid().dimensions;
    std::vector<glm::ivec3> cells;
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.vertices.size(); first += 3)
        {
            const glm::dvec3 a(batch.vertices[first].position);
            const glm::dvec3 b(batch.vertices[first + 1].position);
            const glm::dvec3 c(batch.vertices[first + 2].position);
            cells.clear();
            TriangleOverlap(a, b, c).findCells(size, cells);
            for (const glm::ivec3& cell : cells)
                for (int axis = 0; axis < 3; ++axis)
                    for (const int back : {0, 1})
                    {
                        glm::ivec3 lower = cell;
                        lower[axis] -= back;
                        glm::ivec3 upper = lower;
                        ++upper[axis];
                        if (lower[axis] < 0 || upper[axis] >= size[axis]) continue;
                        if (found.find(lower) || found.find(upper)) continue;
                        if (crosses(a, b, c, lower, axis)) ++tunnels;
                    }
        }
    return tunnels;
}

/** Whether the ray from a cell's centre to the picture of the projected target meets another cell. */
bool isHidden(const BrickModel& found, const glm::ivec3& cell)
{
    const glm::dvec3 direction(ProjectionPass::getDirection()); // upward along every axis
    const glm::ivec3& size = found.getGrid().dimensions;
    glm::dvec3 next = 0.5 / direction; // where the ray leaves its cell along each axis
    glm::ivec3 place = cell;
    while (true)
    {
        const int axis = next.x <= std::min(next.y, next.z) ? 0 : next.y <= next.z ? 1 : 2;
        next[axis] += 1.0 / direction[axis];
        if (++place[axis] == size[axis]) return false;
        if (found.find(place)) return true;
    }
}

/** The share of the cells found by `reachable` that `found` contains too: of the front ones and of the hidden ones. */
std::array<double, 2> sharesOfFrontAndHidden(const BrickModel& reachable, const BrickModel& found)
{
    std::array<std::size_t, 2> hits{};
    std::array<std::size_t, 2> counts{};
    for (const Brick& brick : reachable.getBricks())
    {
        const std::size_t side = isHidden(reachable, brick.getCell()) ? 1 : 0;
        ++counts[side];
        if (found.find(brick.getCell())) ++hits[side];
    }
    return {static_cast<double>(hits[0]) / static_cast<double>(counts[0]),
            static_cast<double>(hits[1]) / static_cast<double>(counts[1])};
}

/** Runs on each model, and prints the share of covered cells that is found. */
class PointVoxelizationOfModels : public GlTest, public ::testing::WithParamInterface<PointModel>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _node = GetParam().create();
        if (!_node) GTEST_SKIP() << "the model could not be fetched";
    }

    osg::ref_ptr<osg::Node> _node;
};

TEST_P(PointVoxelizationOfModels, AddressedIsSoundAndWithoutTunnelsUpToAnEdgeOfOneCell)
{
    for (const char* text : {"48,edge=1", "48,edge=0.25", "96,edge=1"})
    {
        const LegoSettings settings = parseSettings(std::string(text) + ",method=points,target=addressed");
        const osg::ref_ptr<const GridTriangles> triangles = toGrid(*_node, settings);
        const osg::ref_ptr<const BrickModel> truth = voxelizeOnCpu(*triangles);
        const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*_node, settings);
        ASSERT_TRUE(found);
        const std::size_t unsound = countUnsound(*triangles, *truth, *found);
        const std::size_t tunnels = countTunnels(*triangles, *found);
        std::printf("points, addressed  %-8s %-14s recall %.4f, %zu unsound cells, %zu tunnels\n", GetParam().name,
                    text, recallOf(*truth, *found), unsound, tunnels);
        EXPECT_EQ(unsound, 0u);
        EXPECT_EQ(tunnels, 0u);
    }
}

TEST_P(PointVoxelizationOfModels, ProjectedIsSoundAndFindsMoreInLargerPictures)
{
    for (const char* resolution : {"32", "80"})
    {
        std::printf("points, projected  %-8s %3s,edge=1     recall", GetParam().name, resolution);
        const osg::ref_ptr<const GridTriangles> triangles = toGrid(*_node, parseSettings(resolution));
        const osg::ref_ptr<const BrickModel> truth = voxelizeOnCpu(*triangles);
        double previous = 0.0;
        double smallest = 0.0;
        for (const char* size : {"256", "512", "1024"})
        {
            const LegoSettings settings = parseSettings(std::string(resolution) + ",method=points,fbo=" + size);
            const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*_node, settings);
            ASSERT_TRUE(found);
            const double recall = recallOf(*truth, *found);
            std::printf(" %.4f (fbo=%s)", recall, size);
            EXPECT_EQ(countUnsound(*triangles, *truth, *found), 0u);
            EXPECT_GT(recall, previous - 0.01);
            if (previous == 0.0) smallest = recall;
            previous = recall;
        }
        EXPECT_GT(smallest, 0.02);
        EXPECT_TRUE(previous > smallest || smallest == 1.0) << previous;
        EXPECT_GT(previous, 0.5);
        std::printf("\n");
    }
}

INSTANTIATE_TEST_SUITE_P(Models, PointVoxelizationOfModels,
                         ::testing::Values(PointModel{"car", createRacingCar},
                                           PointModel{"sphere", [] { return createSphere(); }},
                                           PointModel{"torus", createTorus}, PointModel{"plate", createThinPlate},
                                           PointModel{"slivers", [] { return createSliverSoup(); }},
                                           PointModel{"bunny", readBunny}),
                         [](const auto& instance) { return std::string(instance.param.name); });

class PointVoxelization : public GlTest
{
};

TEST_F(PointVoxelization, AddressedLeaksWhenEdgesAreLonger)
{
    // Shows that the count of tunnels can fail: it must find tunnels where they exist.
    const osg::ref_ptr<osg::Node> node = createSphere();
    const LegoSettings settings = parseSettings("64,method=points,target=addressed,edge=3");
    const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*node, settings);
    ASSERT_TRUE(found);
    EXPECT_GT(countTunnels(*toGrid(*node, settings), *found), 100u);
}

TEST_F(PointVoxelization, TheLastPointInACellDeterminesItsColour)
{
    const auto add = [](osg::Group& node, const osg::Vec4& color)
    {
        const osg::ref_ptr<osg::Geometry> triangle = createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 1});
        const osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(1);
        colors->front() = color;
        triangle->setColorArray(colors, osg::Array::BIND_OVERALL);
        node.addChild(triangle);
    };
    osg::ref_ptr<osg::Group> node = new osg::Group;
    add(*node, osg::Vec4(1.0f, 0.0f, 0.0f, 1.0f));
    add(*node, osg::Vec4(0.2f, 0.4f, 0.6f, 1.0f));
    const osg::ref_ptr<const BrickModel> found =
        legolizeOnGpu(*node, parseSettings("16,method=points,target=addressed"));
    ASSERT_TRUE(found);
    EXPECT_GT(found->getBricks().size(), 16u);
    for (const Brick& brick : found->getBricks())
        ASSERT_EQ(brick.color, (std::array<std::uint8_t, 3>{51, 102, 153}));
}

TEST_F(PointVoxelization, ProjectedNeverFindsMoreThanAddressed)
{
    const osg::ref_ptr<osg::Node> node = createRacingCar();
    const osg::ref_ptr<const BrickModel> addressed =
        legolizeOnGpu(*node, parseSettings("64,method=points,target=addressed"));
    const osg::ref_ptr<const BrickModel> projected = legolizeOnGpu(*node, parseSettings("64,method=points,fbo=2048"));
    ASSERT_TRUE(addressed && projected);
    EXPECT_GT(projected->getBricks().size(), addressed->getBricks().size() / 2);
    EXPECT_LE(projected->getBricks().size(), addressed->getBricks().size());
    for (const Brick& brick : projected->getBricks())
        ASSERT_TRUE(addressed->find({brick.cell[0], brick.cell[1], brick.cell[2]}));
}

TEST_F(PointVoxelization, ProjectedKeepsTheCellsInFrontAndLosesThoseBehindThem)
{
    const osg::ref_ptr<osg::Node> node = readBunny();
    if (!node) GTEST_SKIP() << "the model could not be fetched";
    const osg::ref_ptr<const BrickModel> reachable =
        legolizeOnGpu(*node, parseSettings("64,up=y,method=points,target=addressed"));
    ASSERT_TRUE(reachable);
    for (const int size : {128, 256, 512, 1024, 2048, 4096})
    {
        const osg::ref_ptr<const BrickModel> found =
            legolizeOnGpu(*node, parseSettings("64,up=y,method=points,fbo=" + std::to_string(size)));
        ASSERT_TRUE(found);
        const auto [front, hidden] = sharesOfFrontAndHidden(*reachable, *found);
        std::printf("points, projected  bunny 64, fbo=%d: kept %.4f of the cells in front, %.4f of the hidden ones\n",
                    size, front, hidden);
        EXPECT_GT(front, hidden);
        EXPECT_GT(front, size < 256 ? 0.9 : 0.985);
    }
}

TEST_F(PointVoxelization, ProjectedNumbersTheLastCellsOfTheLargestGrid)
{
    // Beyond 2^23, single precision still represents every integer, but no halves.
    osg::ref_ptr<osg::Group> node = new osg::Group;
    node->addChild(createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    node->addChild(createTriangle({245, 250, 250}, {250, 245, 250}, {250, 250, 245}));
    const LegoSettings settings = parseSettings("250,method=points,fbo=2048");
    const osg::ref_ptr<const GridTriangles> triangles = toGrid(*node, settings);
    ASSERT_GT(triangles->getGrid().getNumCells(), std::size_t(1) << 23);
    const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*node, settings);
    ASSERT_TRUE(found);
    EXPECT_GT(found->getBricks().size(), 20u);
    EXPECT_EQ(countUnsound(*triangles, *voxelizeOnCpu(*triangles), *found), 0u);
}

TEST_F(PointVoxelization, ProjectedRefusesMoreCellsThanAFloatCanNumber)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("257,method=points"));
    lego->addChild(createSphere());
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *lego);
    viewer.frame();
    viewer.frame();
    const unsigned int contextID = context->getState()->getContextID();
    EXPECT_FALSE(lego->isLegolized(contextID));
    EXPECT_NE(lego->getFailure(contextID).find("at most 16777216 cells"), std::string::npos);
    EXPECT_GT(countDrawn(*readPixels(*context)), 1000u) << "the source is drawn instead";
}

} // namespace

} // namespace osgLego::test
