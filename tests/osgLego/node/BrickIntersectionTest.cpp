#include <osgLego/BrickDimensions.h>
#include <osgLego/BrickGeometry.h>
#include <osgLego/BrickIntersection.h>
#include <osgLego/PartType.h>

#include <Meshes.h>
#include <PartModels.h>
#include <Settings.h>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/KdTree>
#include <osg/MatrixTransform>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/Optimizer>

namespace osgLego::test
{

namespace
{

using Intersection = osgUtil::LineSegmentIntersector::Intersection;

osg::ref_ptr<LegoNode> createLego(const std::string& text)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(text));
    lego->addChild(createSphere(12));
    return lego;
}

osg::ref_ptr<osg::Geode> createGeode(const BrickModel& model)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(createBrickGeometry(model));
    return geode;
}

osgUtil::LineSegmentIntersector::Intersections pick(osg::Node& scene, const osg::Vec3d& from, const osg::Vec3d& to)
{
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray = new osgUtil::LineSegmentIntersector(from, to);
    osgUtil::IntersectionVisitor visitor(ray);
    scene.accept(visitor);
    return ray->getIntersections();
}

std::optional<BrickIntersection> pickFirst(osg::Node& scene, const osg::Vec3d& from, const osg::Vec3d& to)
{
    const auto hits = pick(scene, from, to);
    EXPECT_FALSE(hits.empty());
    return hits.empty() ? std::nullopt : BrickIntersection::find(*hits.begin());
}

/** The centre of a side of a brick, moved outwards by `distance` cells, in model units. */
osg::Vec3d placeBefore(const BrickGrid& grid, const Brick& brick, int axis, bool isUpper, double distance)
{
    glm::dvec3 place = glm::dvec3(brick.getCell()) + 0.5;
    place[axis] += (isUpper ? 1.0 : -1.0) * (0.5 + distance);
    const glm::dvec3 point = grid.origin + grid.cellSize * place;
    return {point.x, point.y, point.z};
}

/** Shoot a ray at every open side of every brick, and expect to find that side. */
void expectEverySideIsFound(osg::Node& scene, const BrickModel& model, const LegoNode* lego)
{
    const BrickGrid& grid = model.getGrid();
    ASSERT_GT(model.getBricks().size(), 100u);
    for (const Brick& brick : model.getBricks())
        for (int number = 0; number < 6; ++number)
        {
            if (!(brick.openSides & (1 << number))) continue;
            const int axis = number / 2;
            const bool isUpper = number % 2 == 1;
            const auto hit = pickFirst(scene, placeBefore(grid, brick, axis, isUpper, 0.45),
                                       placeBefore(grid, brick, axis, isUpper, -0.4));
            ASSERT_TRUE(hit);
            ASSERT_EQ(hit->brick, brick);
            ASSERT_EQ(hit->side, 1 << number);
            ASSERT_EQ(hit->isStud, isUpper && axis == grid.getUpIndex());
            ASSERT_EQ(hit->node, lego);
            ASSERT_EQ(hit->model->getBricks(), model.getBricks());
        }
}

TEST(BrickIntersection, EverySideAndStudOfANodesBricksIsFound)
{
    for (const char* settings : {"12,proportions=brick", "12,up=y"})
    {
        const osg::ref_ptr<LegoNode> lego = createLego(settings);
        expectEverySideIsFound(*lego, *lego->getBricks(), lego);
    }
}

TEST(BrickIntersection, EverySideAndStudOfBrickGeometryIsFoundWithOrWithoutAKdTree)
{
    const osg::ref_ptr<const BrickModel> model = createLego("12,proportions=brick")->getBricks();
    const osg::ref_ptr<osg::Geode> geode = createGeode(*model);
    expectEverySideIsFound(*geode, *model, nullptr);
    osg::ref_ptr<osg::KdTreeBuilder> builder = new osg::KdTreeBuilder;
    geode->accept(*builder);
    ASSERT_TRUE(geode->getDrawable(0)->getShape());
    expectEverySideIsFound(*geode, *model, nullptr);
}

TEST(BrickIntersection, ColorAndCellAreThoseOfTheFirstBrickOnTheRay)
{
    const osg::ref_ptr<LegoNode> lego = createLego("16");
    osg::ref_ptr<osg::MatrixTransform> scene = new osg::MatrixTransform(osg::Matrix::translate(10, 0, 0));
    scene->addChild(lego);
    const auto hits = pick(*scene, {15, 0.06, 0.06}, {5, 0.06, 0.06});
    ASSERT_FALSE(hits.empty());
    const auto hit = BrickIntersection::find(*hits.begin());
    ASSERT_TRUE(hit);
    // The sphere touches x = 1, in the last of sixteen cells, and is coloured by position.
    EXPECT_EQ(hit->brick.getCell(), glm::ivec3(15, 8, 8));
    EXPECT_EQ(hit->side, SIDE_RIGHT);
    EXPECT_FALSE(hit->isStud);
    EXPECT_EQ(hit->brick, *lego->getBricks()->find({15, 8, 8}));
    EXPECT_GT(hit->brick.color[0], 200);
    EXPECT_EQ(hit->node, lego);
    EXPECT_TRUE(hits.begin()->indexList.empty()) << "as the header documents";
}

TEST(BrickIntersection, AStudIsHitFromTheSide)
{
    const osg::ref_ptr<LegoNode> lego = createLego("16");
    // The studs of the topmost bricks extend above z = 1, their faces do not.
    const double z = 1.0 + 0.5 * BrickDimensions::STUD_HEIGHT * lego->getBricks()->getGrid().getPitch();
    const auto hit = pickFirst(*lego, {5, 0.06, z}, {-5, 0.06, z});
    ASSERT_TRUE(hit);
    EXPECT_TRUE(hit->isStud);
    EXPECT_EQ(hit->side, SIDE_TOP);
    EXPECT_EQ(hit->brick.cell[2], 15);
}

TEST(BrickIntersection, TheIndexListOfBrickGeometryNamesTheCornersOfTheTriangle)
{
    const osg::ref_ptr<osg::Geode> geode = createGeode(*createLego("16")->getBricks());
    const auto hits = pick(*geode, {5, 0.055, 0.06}, {-5, 0.055, 0.06});
    ASSERT_FALSE(hits.empty());
    const Intersection& hit = *hits.begin();
    ASSERT_EQ(hit.indexList.size(), 3u);
    const osg::Geometry& geometry = *geode->getDrawable(0)->asGeometry();
    for (unsigned int corner = 0; corner < 3; ++corner)
        EXPECT_EQ(hit.indexList[corner], geometry.getPrimitiveSet(0)->index(3 * hit.primitiveIndex + corner));
}

TEST(BrickIntersection, BrickGeometryIsFoundAfterTheDefaultOptimizations)
{
    const osg::ref_ptr<const BrickModel> model = createLego("12")->getBricks();
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(osg::Matrix::translate(3, 0, 0));
    transform->setDataVariance(osg::Object::STATIC);
    transform->addChild(createGeode(*model));
    scene->addChild(transform);
    osgUtil::Optimizer().optimize(scene, osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS);
    const auto hit = pickFirst(*scene, {8, 0.06, 0.06}, {-8, 0.06, 0.06});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->brick.getCell(), glm::ivec3(11, 6, 6));
}

TEST(BrickIntersection, ThePartOfTheBrickIsFound)
{
    Part brick;
    brick.size = {2, 4, 3};
    brick.colorCode = 4;
    Part plate;
    plate.cell = {0, 0, 3};
    plate.size = {1, 8, 1};
    plate.color = {1, 2, 3};
    const osg::ref_ptr<const BrickModel> model =
        BrickModel::createOfParts(createPartGrid({2, 8, 4}, 0.4), {brick, plate});
    const osg::ref_ptr<LegoNode> node = createStoredNode(*model, "8");
    const osg::ref_ptr<osg::Geode> geode = createGeode(*model);
    for (osg::Node* scene : {static_cast<osg::Node*>(node), static_cast<osg::Node*>(geode)})
    {
        const auto side = pickFirst(*scene, {5, 3.6, 0.9}, {-5, 3.6, 0.9});
        ASSERT_TRUE(side && side->part);
        EXPECT_EQ(*side->part, brick);
        EXPECT_EQ(findPartType(*side->part, model->getGrid())->getName(), "Brick 2 x 4");
        const auto stud = pickFirst(*scene, {0.4, 6.4, 9}, {0.4, 6.4, -9});
        ASSERT_TRUE(stud && stud->part);
        EXPECT_TRUE(stud->isStud);
        EXPECT_EQ(*stud->part, plate);
        EXPECT_EQ(findPartType(*stud->part, model->getGrid())->getName(), "Plate 1 x 8");
    }
    const auto cell = pickFirst(*createStoredNode(*createCells(*model), "8"), {5, 3.6, 0.9}, {-5, 3.6, 0.9});
    ASSERT_TRUE(cell);
    EXPECT_EQ(cell->part, nullptr);
}

TEST(BrickIntersection, OtherGeometryGivesNoBrick)
{
    const auto hits = pick(*createSphere(12), {5, 0.06, 0.06}, {-5, 0.06, 0.06});
    ASSERT_FALSE(hits.empty());
    EXPECT_FALSE(BrickIntersection::find(*hits.begin()));
    EXPECT_FALSE(BrickIntersection::find(Intersection()));

    const osg::ref_ptr<osg::Geode> geode = createGeode(*createLego("4")->getBricks());
    Intersection beyond;
    beyond.drawable = geode->getDrawable(0);
    beyond.primitiveIndex = geode->getDrawable(0)->asGeometry()->getPrimitiveSet(0)->getNumIndices() / 3;
    EXPECT_FALSE(BrickIntersection::find(beyond));
    beyond.primitiveIndex -= 1;
    EXPECT_TRUE(BrickIntersection::find(beyond));
}

} // namespace

} // namespace osgLego::test
