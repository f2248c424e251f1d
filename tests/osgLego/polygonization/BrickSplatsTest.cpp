#include <common/RacingCar.h>

#include <LookTest.h>
#include <PartModels.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <osg/ClipNode>
#include <osg/FrontFace>
#include <osg/MatrixTransform>
#include <osg/PolygonOffset>

namespace osgLego::test
{

namespace
{

/** Compares bricks drawn as splats, or as triangles with back-face culling, with bricks whose faces and studs are all
 * drawn. */
class BrickSplats : public LookTest
{
protected:
    static constexpr std::size_t NUM_PIXELS = WIDTH * HEIGHT;

    static osg::ref_ptr<LegoNode> createLego(const std::string& settings)
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->addChild(createRacingCar());
        return lego;
    }

    osg::ref_ptr<osg::Image> drawWith(osg::Node& node, const Viewpoint& viewpoint,
                                      const std::function<void(osg::StateSet&)>& change)
    {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(&node);
        change(*group->getOrCreateStateSet());
        return draw(*group, viewpoint);
    }

    /** Bricks with a polygon offset are drawn as triangles; this offset has no effect. */
    static void forceTriangles(osg::StateSet& stateSet)
    {
        stateSet.setAttributeAndModes(new osg::PolygonOffset(0.0f, 0.0f));
    }

    /** With a stencil test, all faces are drawn; this one always passes. */
    static void forceAllFaces(osg::StateSet& stateSet) { stateSet.setMode(GL_STENCIL_TEST, osg::StateAttribute::ON); }

    /** The number of pixels that differ. */
    std::size_t countDifference(osg::Node& node, const Viewpoint& viewpoint)
    {
        const osg::ref_ptr<osg::Image> all = drawWith(node, viewpoint, forceAllFaces);
        EXPECT_GT(countDrawn(*all), NUM_PIXELS / 200) << "there is nothing to compare";
        return std::max(countDifferent(*all, *draw(node, viewpoint), 3),
                        countDifferent(*all, *drawWith(node, viewpoint, forceTriangles), 3));
    }
};

const osg::Vec3d MIDDLE(0, 0, 0.5);
const std::vector<std::pair<const char*, Viewpoint>> VIEWS{
    {"from above", {{5, -9, 5}, MIDDLE}},
    {"from below", {{4, -8, -4}, MIDDLE}},
    {"level with the studs", {{2, -9, 0.9}, MIDDLE}},
    {"close up", {{1.2, -2.4, 1.6}, MIDDLE}},
    {"from afar", {{20, -30, 20}, MIDDLE}},
    {"straight down", {{0, 0, 9}, MIDDLE, {0, 1, 0}}},
    {"orthographic", {{5, -9, 5}, MIDDLE, {0, 0, 1}, 5.0}},
    {"orthographic from below", {{5, -9, -5}, MIDDLE, {0, 0, 1}, 5.0}},
    {"orthographic along an axis", {{0, -9, 0.5}, MIDDLE, {0, 0, 1}, 5.0}},
    {"orthographic straight down", {{0, 0, 9}, MIDDLE, {0, 1, 0}, 5.0}},
    {"beside the picture", {{3, -4, 2}, {2.5, 0, 0}}},
    {"from inside", {{0.1, 0.1, 0.5}, {1, -2, 0.3}}}};

TEST_F(BrickSplats, MakeThePictureOfTheTriangles)
{
    for (const char* settings : {"20,look=plain", "20,look=full", "24,up=y,proportions=plate,look=full"})
    {
        const osg::ref_ptr<LegoNode> lego = createLego(settings);
        for (const auto& [name, viewpoint] : VIEWS)
            EXPECT_LE(countDifference(*lego, viewpoint), NUM_PIXELS / 400) << settings << " " << name;
    }
}

/** Bricks and plates in a ball of about the size of the car, of three colours. */
osg::ref_ptr<const BrickModel> createPartBall(UpAxis up)
{
    constexpr int SIDE = 20;
    const glm::ivec3 size =
        up == UpAxis::Y ? glm::ivec3(SIDE, SIDE * 5 / 2, SIDE) : glm::ivec3(SIDE, SIDE, SIDE * 5 / 2);
    BrickGrid grid = createPartGrid(size, 0.4, up);
    grid.cellSize *= 0.147; // so that no border between cells is exactly in the middle of a pixel
    grid.origin = -0.5 * grid.cellSize * glm::dvec3(size);
    PartFilling filling;
    filling.heights = {1, 3};
    filling.colors = {{200, 30, 20}, {240, 240, 235}, {20, 80, 170}};
    filling.isCovered = [size](const glm::ivec3& cell)
    { return glm::length((glm::dvec3(cell) + 0.5) / (0.5 * glm::dvec3(size)) - 1.0) < 1.0; };
    return createParts(grid, filling);
}

TEST_F(BrickSplats, MakeThePictureOfTheTrianglesOfParts)
{
    for (const char* settings : {"20,look=plain", "20,look=full"})
        for (const UpAxis up : {UpAxis::Z, UpAxis::Y})
        {
            const osg::ref_ptr<LegoNode> lego = createStoredNode(*createPartBall(up), settings);
            for (const auto& [name, viewpoint] : VIEWS)
                EXPECT_LE(countDifference(*lego, viewpoint), NUM_PIXELS / 400) << settings << " " << name;
        }
}

TEST_F(BrickSplats, MakeTheGeometryBufferOfTheTriangles)
{
    for (const char* output : {"low", "low,show=normals"})
    {
        const osg::ref_ptr<AmbientOcclusionScene> scene = createGroup(output, createLego("20"));
        EXPECT_LE(countDifference(*scene, VIEWS.front().second), NUM_PIXELS / 200) << output;
    }
}

TEST_F(BrickSplats, AreRightInAMirror)
{
    osg::ref_ptr<osg::MatrixTransform> mirror = new osg::MatrixTransform(osg::Matrix::scale(-1, 1, 1));
    mirror->addChild(createLego("20"));
    EXPECT_LE(countDifference(*mirror, VIEWS.front().second), NUM_PIXELS / 400);
    mirror->getOrCreateStateSet()->setAttribute(new osg::FrontFace(osg::FrontFace::CLOCKWISE));
    EXPECT_LE(countDifference(*mirror, VIEWS.front().second), NUM_PIXELS / 400) << "front faces turned";
}

TEST_F(BrickSplats, AreThereWhereMatricesAreUniforms)
{
    _context->getState()->setUseModelViewAndProjectionUniforms(true);
    EXPECT_LE(countDifference(*createLego("20"), VIEWS.front().second), NUM_PIXELS / 400);
}

TEST_F(BrickSplats, AreNotTriedFromSoFarThatRaysCannotBeToldApart)
{
    for (const double distance : {1e3, 1e5})
        EXPECT_LE(
            countDifference(*createLego("24"), {{0.3 * distance, -distance, 0.3 * distance}, MIDDLE, {0, 0, 1}, 5.0}),
            NUM_PIXELS / 400)
            << distance;
}

TEST_F(BrickSplats, LeaveWhatIsCutOpenToTheTriangles)
{
    const Viewpoint& viewpoint = VIEWS.front().second;
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    const osg::ref_ptr<osg::Image> whole = draw(*lego, viewpoint);
    osg::ref_ptr<osg::ClipNode> cut = new osg::ClipNode;
    cut->addClipPlane(new osg::ClipPlane(0, osg::Vec4d(0, 1, 0, 0)));
    cut->addChild(lego);
    EXPECT_EQ(countDifference(*cut, viewpoint), 0u);
    EXPECT_GT(countDifferent(*whole, *draw(*cut, viewpoint), 3), NUM_PIXELS / 100);
}

} // namespace

} // namespace osgLego::test
