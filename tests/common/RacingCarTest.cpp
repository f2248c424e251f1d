#include <common/RacingCar.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osgUtil/Optimizer>

namespace osgLego
{

namespace
{

using Triangles = osg::ref_ptr<const SceneTriangles>;

/** The triangles of two cars that exist at the same time. */
std::pair<Triangles, Triangles> flattenTwoCars()
{
    const osg::ref_ptr<osg::Node> first = createRacingCar();
    const osg::ref_ptr<osg::Node> second = createRacingCar();
    return {SceneTriangles::create(*first), SceneTriangles::create(*second)};
}

TEST(RacingCar, StandsOnTheGroundAndIsPartlyTextured)
{
    const osg::ref_ptr<const SceneTriangles> triangles = SceneTriangles::create(*createRacingCar());
    EXPECT_GT(triangles->getNumTriangles(), 2000u);
    EXPECT_NEAR(triangles->getBounds().zMin(), 0.0, 1e-3);
    EXPECT_NEAR(triangles->getBounds().yMin(), -triangles->getBounds().yMax(), 1e-6);
    std::size_t textured = 0;
    for (const SceneBatch& batch : triangles->getBatches())
        textured += batch.texture ? batch.vertices.size() / 3 : 0;
    EXPECT_GT(textured, 500u);
    EXPECT_LT(textured, triangles->getNumTriangles());
}

/** What osgviewer does with a scene, and all else that the optimizer can do. */
void optimize(osg::Node& car, unsigned int options)
{
    const osg::ref_ptr<osg::MatrixTransform> scene = new osg::MatrixTransform(osg::Matrixd::translate(1.0, 2.0, 3.0));
    scene->setDataVariance(osg::Object::STATIC);
    scene->addChild(&car);
    osgUtil::Optimizer().optimize(scene, options);
}

void expectEqual(const SceneTriangles& first, const SceneTriangles& second)
{
    ASSERT_EQ(first.getBatches().size(), second.getBatches().size());
    for (std::size_t batch = 0; batch < first.getBatches().size(); ++batch)
    {
        const auto& a = first.getBatches()[batch].vertices;
        const auto& b = second.getBatches()[batch].vertices;
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t vertex = 0; vertex < a.size(); ++vertex)
            ASSERT_EQ(a[vertex].position, b[vertex].position);
    }
}

TEST(RacingCar, IsTheSameEvenIfAnotherHasBeenOptimized)
{
    const Triangles before = SceneTriangles::create(*createRacingCar());
    for (const unsigned int options :
         {osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS, osgUtil::Optimizer::ALL_OPTIMIZATIONS})
    {
        optimize(*createRacingCar(), options);
        expectEqual(*before, *SceneTriangles::create(*createRacingCar()));
    }
}

TEST(RacingCar, IsTheSameOnEveryCall)
{
    const auto [first, second] = flattenTwoCars();
    expectEqual(*first, *second);
}

TEST(RacingCar, SharesItsTexturesWithOtherCars)
{
    const auto [first, second] = flattenTwoCars();
    ASSERT_EQ(first->getBatches().size(), second->getBatches().size());
    for (std::size_t batch = 0; batch < first->getBatches().size(); ++batch)
        EXPECT_EQ(first->getBatches()[batch].texture, second->getBatches()[batch].texture);
}

/** The drawables of a car, and their state. */
class DrawableFinder : public osg::NodeVisitor
{
public:
    DrawableFinder() : NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Geometry& geometry) override { geometries.insert(&geometry); }

    std::set<osg::ref_ptr<osg::Geometry>> geometries;
};

std::set<osg::ref_ptr<osg::Geometry>> findGeometries(osg::Node& car)
{
    DrawableFinder finder;
    car.accept(finder);
    return finder.geometries;
}

TEST(RacingCar, SharesItsArraysButNoDrawableWithOtherCars)
{
    const auto first = findGeometries(*createRacingCar());
    const auto second = findGeometries(*createRacingCar());
    ASSERT_EQ(first.size(), second.size());
    std::set<const osg::Object*> shared;
    for (const osg::ref_ptr<osg::Geometry>& geometry : first)
        shared.insert({geometry->getVertexArray(), geometry->getPrimitiveSet(0)});
    for (const osg::ref_ptr<osg::Geometry>& geometry : second)
    {
        EXPECT_FALSE(first.contains(geometry));
        EXPECT_TRUE(shared.contains(geometry->getVertexArray()));
        EXPECT_TRUE(shared.contains(geometry->getPrimitiveSet(0)));
    }
}

TEST(RacingCar, SharesItsWheelsWithinACar)
{
    const osg::ref_ptr<osg::Group> wheels = createRacingCar()->asGroup()->getChild(2)->asGroup();
    ASSERT_EQ(wheels->getNumChildren(), 4u);
    const auto wheelOf = [&](unsigned int place) { return wheels->getChild(place)->asGroup()->getChild(0); };
    EXPECT_EQ(wheelOf(0), wheelOf(1));
    EXPECT_EQ(wheelOf(2), wheelOf(3));
    EXPECT_NE(wheelOf(0), wheelOf(2));
}

} // namespace

} // namespace osgLego
