#include <common/RacingCar.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <GlTest.h>
#include <Meshes.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <osg/Geode>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

/** A model, a method, and the producer that executes it. */
struct Variant
{
    const char* name;
    osg::ref_ptr<osg::Node> (*create)();
    const char* settings;
};

std::string textOf(const glm::dvec3& vector)
{
    std::ostringstream text;
    text.precision(17);
    text << vector.x << ':' << vector.y << ':' << vector.z;
    return text.str();
}

/** A grid of cells of a lattice, selected by its first cell and its size. */
struct Part
{
    glm::ivec3 first;
    glm::ivec3 size;
};

/** Grids of one lattice, which cover a model or a part of it. */
class Lattice
{
public:
    /** @param resolution the number of cells along the longest side of the model's bounds.
     * @param height that of a cell, divided by its width, along z. */
    Lattice(const osg::Node& node, int resolution, double height = 1.0)
    {
        const osg::BoundingBoxd bounds = SceneTriangles::create(node)->getBounds();
        const osg::Vec3d extent = bounds._max - bounds._min;
        const double pitch = std::max({extent.x(), extent.y(), extent.z()}) / resolution;
        _cell = glm::dvec3(pitch, pitch, height * pitch);
        // Neither the model's lowest corner nor the cells' corners are at round numbers.
        _origin = glm::dvec3(bounds.xMin(), bounds.yMin(), bounds.zMin()) - _cell * glm::dvec3(2.3, 1.7, 3.1);
        _whole = {glm::ivec3(0), glm::ivec3(glm::dvec3(extent.x(), extent.y(), extent.z()) / _cell) + 6};
    }

    const Part& getWhole() const { return _whole; }

    std::string getSettings(const Part& part) const
    {
        std::ostringstream text;
        text.precision(17);
        text << "cell=" << _cell.x << ",origin=" << textOf(_origin + _cell * glm::dvec3(part.first))
             << ",size=" << textOf(glm::dvec3(part.size));
        return text.str();
    }

private:
    glm::dvec3 _cell;
    glm::dvec3 _origin;
    Part _whole;
};

/** The largest difference of the colours of two bricks, of 255. */
int colorDifference(const Brick& a, const Brick& b)
{
    int difference = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        difference = std::max(difference, std::abs(a.color[channel] - b.color[channel]));
    return difference;
}

bool isInside(const glm::ivec3& cell, const Part& part)
{
    return glm::all(glm::greaterThanEqual(cell, part.first)) && glm::all(glm::lessThan(cell, part.first + part.size));
}

/** Expect that a part has exactly those bricks of the whole whose cells are inside it. */
void expectSameInside(const BrickModel& whole, const BrickModel& found, const Part& part)
{
    std::size_t expected = 0;
    std::size_t missing = 0;
    std::size_t offColor = 0;
    for (const Brick& brick : whole.getBricks())
    {
        if (!isInside(brick.getCell(), part)) continue;
        ++expected;
        const Brick* other = found.find(brick.getCell() - part.first);
        if (!other)
            ++missing;
        else if (colorDifference(brick, *other) > 1)
            ++offColor;
    }
    EXPECT_GT(expected, 20u) << "the part is too empty to show anything";
    EXPECT_LT(expected, whole.getBricks().size()) << "the part contains the model";
    EXPECT_EQ(found.getBricks().size(), expected);
    EXPECT_EQ(missing, 0u);
    EXPECT_EQ(offColor, 0u);
}

class LatticeOfModels : public GlTest, public ::testing::WithParamInterface<Variant>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _node = GetParam().create();
        if (!_node) GTEST_SKIP() << "the model could not be fetched";
    }

    Lattice createLattice(int resolution) const
    {
        return {*_node, resolution, parseSettings(std::string("64") + GetParam().settings).getCellHeight()};
    }

    osg::ref_ptr<const BrickModel> legolize(const std::string& grid) const
    {
        const LegoSettings settings = parseSettings(grid + GetParam().settings);
        return settings.voxelization.device == Device::CPU ? legolizeOnCpu(*_node, settings)
                                                           : legolizeOnGpu(*_node, settings);
    }

    osg::ref_ptr<osg::Node> _node;
};

TEST_P(LatticeOfModels, APartHasTheCellsAndColoursOfTheWhole)
{
    for (const int resolution : {24, 61})
    {
        const Lattice lattice = createLattice(resolution);
        const osg::ref_ptr<const BrickModel> whole = legolize(lattice.getSettings(lattice.getWhole()));
        ASSERT_TRUE(whole);
        const glm::ivec3 size = lattice.getWhole().size;
        // The middle; the lower half and the upper, which end in the model; and the half of one that begins below.
        for (const Part& part : {Part{size / 4, size / 2}, Part{glm::ivec3(0), {size.x / 2, size.y, size.z}},
                                 Part{{size.x / 2, 0, 0}, {size.x - size.x / 2, size.y, size.z}},
                                 Part{{-40, -3, size.z / 3}, {40 + size.x / 2, size.y + 9, size.z}}})
        {
            const osg::ref_ptr<const BrickModel> found = legolize(lattice.getSettings(part));
            ASSERT_TRUE(found);
            SCOPED_TRACE(lattice.getSettings(part));
            expectSameInside(*whole, *found, part);
        }
    }
}

TEST_P(LatticeOfModels, AdjacentGridsPartitionTheCellsOfTheWhole)
{
    const Lattice lattice = createLattice(33);
    const osg::ref_ptr<const BrickModel> whole = legolize(lattice.getSettings(lattice.getWhole()));
    ASSERT_TRUE(whole);
    const glm::ivec3 size = lattice.getWhole().size;
    std::size_t sum = 0;
    for (int octant = 0; octant < 8; ++octant)
    {
        const glm::ivec3 isUpper(octant & 1, octant >> 1 & 1, octant >> 2);
        const glm::ivec3 middle = size / 2;
        const Part part{isUpper * middle, middle + isUpper * (size - 2 * middle)};
        const osg::ref_ptr<const BrickModel> found = legolize(lattice.getSettings(part));
        ASSERT_TRUE(found);
        sum += found->getBricks().size();
        for (const Brick& brick : found->getBricks())
            ASSERT_TRUE(whole->find(brick.getCell() + part.first));
    }
    EXPECT_EQ(sum, whole->getBricks().size());
}

TEST_P(LatticeOfModels, AGridThatMissesTheModelHasNoBricks)
{
    const Lattice lattice = createLattice(24);
    for (const glm::ivec3& first : {lattice.getWhole().size + 5, glm::ivec3(-50000), glm::ivec3(0, 2000000000, 0)})
    {
        const osg::ref_ptr<const BrickModel> found = legolize(lattice.getSettings({first, glm::ivec3(9)}));
        ASSERT_TRUE(found);
        EXPECT_EQ(found->getBricks().size(), 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Variants, LatticeOfModels,
                         ::testing::Values(Variant{"carExactCpu", createRacingCar, ",device=cpu"},
                                           Variant{"carExactGpu", createRacingCar, ",device=gpu"},
                                           Variant{"carPlates", createRacingCar, ",proportions=plate,device=gpu"},
                                           Variant{"carPoints", createRacingCar, ",method=points,target=addressed"},
                                           Variant{"bunnyExactCpu", readBunny, ",up=y,device=cpu"},
                                           Variant{"bunnyExactGpu", readBunny, ",up=y,device=gpu"},
                                           Variant{"bunnyPoints", readBunny, ",up=y,method=points,target=addressed"},
                                           Variant{"torusExactCpu", createTorus, ",device=cpu"},
                                           Variant{"torusExactGpu", createTorus, ",device=gpu"},
                                           Variant{"torusPoints", createTorus, ",method=points,target=addressed"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

class LatticeTest : public GlTest
{
};

TEST_F(LatticeTest, TheGpuFindsTheCellsOfTheCpuInAPart)
{
    for (const osg::ref_ptr<osg::Node>& node : {createRacingCar(), readBunny()})
    {
        if (!node) continue;
        const Lattice lattice(*node, 70);
        const glm::ivec3 size = lattice.getWhole().size;
        const LegoSettings settings = parseSettings(lattice.getSettings({size / 4, size / 2}));
        const osg::ref_ptr<const BrickModel> cpu = legolizeOnCpu(*node, settings);
        const osg::ref_ptr<const BrickModel> gpu = legolizeOnGpu(*node, settings);
        ASSERT_TRUE(cpu && gpu);
        const std::size_t count = cpu->getBricks().size();
        std::size_t common = 0;
        std::size_t offColor = 0;
        for (const Brick& brick : gpu->getBricks())
            if (const Brick* other = cpu->find(brick.getCell()))
            {
                ++common;
                offColor += colorDifference(brick, *other) > 2 ? 1 : 0;
            }
        EXPECT_GT(count, 200u);
        // Single precision can't decide about cells that a triangle merely grazes.
        EXPECT_GE(common + 2, count);
        EXPECT_LE(gpu->getBricks().size(), common + 2);
        EXPECT_LE(offColor, count / 100);
    }
}

TEST_F(LatticeTest, ProjectedPointsOfAPartAreAmongTheCellsOfTheWhole)
{
    // A smaller grid has more pixels per cell, so its picture shows points that others hide in the picture of the
    // whole.
    for (const osg::ref_ptr<osg::Node>& node : {createRacingCar(), readBunny()})
    {
        if (!node) continue;
        const Lattice lattice(*node, 40);
        const auto legolize = [&](const Part& part, const std::string& method)
        { return legolizeOnGpu(*node, parseSettings(lattice.getSettings(part) + ",method=points" + method)); };
        const osg::ref_ptr<const BrickModel> addressed = legolize(lattice.getWhole(), ",target=addressed");
        const osg::ref_ptr<const BrickModel> whole = legolize(lattice.getWhole(), ",fbo=512");
        const glm::ivec3 size = lattice.getWhole().size;
        const Part part{{size.x / 2, 0, 0}, {size.x - size.x / 2, size.y, size.z}};
        const osg::ref_ptr<const BrickModel> found = legolize(part, ",fbo=512");
        ASSERT_TRUE(addressed && whole && found);
        std::size_t inWhole = 0;
        for (const Brick& brick : whole->getBricks())
            inWhole += isInside(brick.getCell(), part) ? 1 : 0;
        EXPECT_GE(found->getBricks().size() + found->getBricks().size() / 100, inWhole);
        for (const Brick& brick : found->getBricks())
            ASSERT_TRUE(addressed->find(brick.getCell() + part.first));
    }
}

/** A model beside two triangles: a floor below it and a wall, both many times larger than the model. */
osg::ref_ptr<osg::Node> createInLargeRoom(float size)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createSphere());
    group->addChild(createTriangle({-size, -size, -0.9f}, {size, -size, -0.9f}, {0.0f, size, -0.9f}));
    group->addChild(createTriangle({-size, -size, -size}, {size, size, -size}, {0.0f, 0.0f, size}));
    return group;
}

TEST_F(LatticeTest, LargeTrianglesCostNoMorePassesThanTheGridNeeds)
{
    LegoStatistics small;
    LegoStatistics large;
    for (const char* method : {",method=points,target=addressed", ""})
    {
        const std::string settings = std::string("cell=0.05,origin=-1.2:-1.2:-1.2,size=48:48:48") + method;
        const osg::ref_ptr<osg::Node> room = createInLargeRoom(4.0f);
        const osg::ref_ptr<osg::Node> hall = createInLargeRoom(200.0f);
        const osg::ref_ptr<const BrickModel> expected = legolizeOnGpu(*room, parseSettings(settings), &small);
        const osg::ref_ptr<const BrickModel> found = legolizeOnGpu(*hall, parseSettings(settings), &large);
        ASSERT_TRUE(expected && found);
        EXPECT_GT(expected->getBricks().size(), 5000u);
        EXPECT_NEAR(static_cast<double>(found->getBricks().size()), static_cast<double>(expected->getBricks().size()),
                    0.01 * static_cast<double>(expected->getBricks().size()));
        EXPECT_LE(large.numSubdivisionPasses, small.numSubdivisionPasses + 1);
        EXPECT_LE(large.numFineTriangles, 3 * small.numFineTriangles / 2);
    }
}

TEST_F(LatticeTest, AHugeTriangleDoesNotMoveTheCellsOfAModel)
{
    // 2e16 cells: far beyond single precision.
    const std::string grid = "cell=0.05,origin=-1.2:-1.2:-0.6,size=48:48:40";
    for (const char* device : {",device=cpu", ",device=gpu"})
    {
        const LegoSettings settings = parseSettings(grid + device);
        const auto legolize = [&](osg::Node& node) {
            return settings.voxelization.device == Device::CPU ? legolizeOnCpu(node, settings)
                                                               : legolizeOnGpu(node, settings);
        };
        const osg::ref_ptr<osg::Node> sphere = createSphere();
        osg::ref_ptr<osg::Group> both = new osg::Group;
        both->addChild(sphere);
        // Above and around everything, and through the lowest layer of cells.
        both->addChild(createTriangle({-1e15f, -1e15f, 5.0f}, {1e15f, -1e15f, 5.0f}, {0.0f, 1e15f, 5.0f}));
        both->addChild(createTriangle({-1e15f, -1e15f, -0.57f}, {1e15f, -1e15f, -0.57f}, {0.0f, 1e15f, -0.57f}));
        const osg::ref_ptr<const BrickModel> alone = legolize(*sphere);
        const osg::ref_ptr<const BrickModel> found = legolize(*both);
        ASSERT_TRUE(alone && found);
        std::size_t floor = 0;
        std::size_t above = 0;
        for (const Brick& brick : found->getBricks())
            ++(brick.cell[2] == 0 ? floor : above);
        EXPECT_EQ(floor, 48u * 48u);
        std::size_t expected = 0;
        std::size_t missing = 0;
        for (const Brick& brick : alone->getBricks())
        {
            if (brick.cell[2] == 0) continue;
            ++expected;
            missing += found->find(brick.getCell()) ? 0 : 1;
        }
        EXPECT_EQ(above, expected);
        EXPECT_LE(missing, expected / 1000);
    }
}

TEST_F(LatticeTest, NodesWithEqualCellsShareALattice)
{
    const LegoSettings settings = parseSettings("cell=0.1");
    osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(osg::Matrixd::translate(2.137, 0.4, -1.05));
    moved->addChild(createSphere());
    const BrickGrid first = legolizeOnCpu(*createSphere(), settings)->getGrid();
    const BrickGrid second = legolizeOnCpu(*moved, settings)->getGrid();
    EXPECT_EQ(first.cellSize, second.cellSize);
    const glm::dvec3 shift = (second.origin - first.origin) / first.cellSize;
    EXPECT_LT(glm::length(shift - glm::round(shift)), 1e-9);
    EXPECT_EQ(glm::ivec3(glm::round(shift)), glm::ivec3(21, 4, -11));
}

TEST_F(LatticeTest, APartIsDrawnWithoutAnError)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("cell=0.1,origin=-1:-1:-1,size=10:20:20"));
    lego->addChild(createSphere());
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *lego);
    viewer.frame();
    viewer.frame();
    EXPECT_GT(countDrawn(*readPixels(*context)), 1000u);
    EXPECT_NEAR(lego->getBound().center().x(), -0.5, 1e-6);

    // A grid without bricks draws nothing, and is no failure.
    lego->setSettings(parseSettings("cell=0.1,origin=5:5:5,size=10:20:20"));
    viewer.frame();
    viewer.frame();
    const unsigned int contextID = context->getState()->getContextID();
    EXPECT_TRUE(lego->isLegolized(contextID));
    EXPECT_EQ(lego->getFailure(contextID), "");
    EXPECT_EQ(countDrawn(*readPixels(*context)), 0u);
}

TEST_F(LatticeTest, CellsThatAreTooSmallAreReportedAndTheSourceIsDrawn)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("cell=0.001"));
    lego->addChild(createSphere());
    const std::string expected =
        "the model reaches into 2001 x 2001 x 2001 cells; expected at most 1024 x 1024 x 2560, "
        "by a larger cell, or by origin and size that select a part";
    EXPECT_EQ(lego->getObstacle(), expected);
    EXPECT_TRUE(lego->hasTriangles());
    EXPECT_FALSE(lego->getBricks());
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *lego);
    viewer.frame();
    viewer.frame();
    EXPECT_EQ(lego->getFailure(context->getState()->getContextID()), expected);
    EXPECT_GT(countDrawn(*readPixels(*context)), 1000u);
    lego->setSettings(parseSettings("cell=0.1"));
    viewer.frame();
    EXPECT_EQ(lego->getObstacle(), "");
    EXPECT_TRUE(lego->isLegolized(context->getState()->getContextID()));
}

} // namespace

} // namespace osgLego::test
