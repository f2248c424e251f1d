#include <common/RacingCar.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <utility>

#include <gtest/gtest.h>

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

TEST(RacingCar, IsTheSameOnEveryCall)
{
    const auto [first, second] = flattenTwoCars();
    ASSERT_EQ(first->getBatches().size(), second->getBatches().size());
    for (std::size_t batch = 0; batch < first->getBatches().size(); ++batch)
    {
        const auto& a = first->getBatches()[batch].vertices;
        const auto& b = second->getBatches()[batch].vertices;
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t vertex = 0; vertex < a.size(); ++vertex)
            ASSERT_EQ(a[vertex].position, b[vertex].position);
    }
}

TEST(RacingCar, SharesItsTexturesWithOtherCars)
{
    const auto [first, second] = flattenTwoCars();
    ASSERT_EQ(first->getBatches().size(), second->getBatches().size());
    for (std::size_t batch = 0; batch < first->getBatches().size(); ++batch)
        EXPECT_EQ(first->getBatches()[batch].texture, second->getBatches()[batch].texture);
}

} // namespace

} // namespace osgLego
