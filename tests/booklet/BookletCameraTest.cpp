#include <booklet/BookletCamera.h>

#include <PartModels.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const glm::dvec3 CENTRE(2.0, 3.0, 1.0);

glm::dvec2 directionOf(const BookletCamera& camera, const glm::dvec3& cells)
{
    return camera.project(CENTRE + cells) - camera.project(CENTRE);
}

Part createPart()
{
    Part part;
    part.size = {4, 2, 1};
    return part;
}

} // namespace

TEST(BookletCameraTest, ShowsTheFrontFromTheRightAndFromAbove)
{
    const BookletCamera camera(test::createPartGrid({4, 6, 2}, 1.2), {});
    EXPECT_GT(directionOf(camera, {1, 0, 0}).x, 0.0);
    EXPECT_LT(directionOf(camera, {1, 0, 0}).y, 0.0); // the right end is nearer
    EXPECT_GT(directionOf(camera, {0, 1, 0}).y, 0.0); // the back is above the front
    EXPECT_NEAR(directionOf(camera, {0, 0, 1}).x, 0.0, 1e-12);
    EXPECT_GT(directionOf(camera, {0, 0, 1}).y, 0.0);
}

TEST(BookletCameraTest, TurnsByQuartersAboutTheUpAxis)
{
    const BrickGrid grid = test::createPartGrid({4, 6, 2}, 1.2);
    const glm::dvec2 right = directionOf(BookletCamera(grid, {}), {1, 0, 0});
    const glm::dvec2 turned = directionOf(BookletCamera(grid, {1, false}), {0, 1, 0});
    EXPECT_NEAR(glm::distance(right, turned), 0.0, 1e-12);
}

TEST(BookletCameraTest, ShowsModelsUpsideDownWithTheirUndersideOnTop)
{
    const BookletCamera camera(test::createPartGrid({4, 6, 2}, 1.2), {0, true});
    EXPECT_LT(directionOf(camera, {0, 0, 1}).y, 0.0);
    EXPECT_LT(directionOf(camera, {1, 0, 0}).x, 0.0); // the front remains in front, so that right and left change
    EXPECT_GT(directionOf(camera, {0, 1, 0}).y, 0.0);
}

TEST(BookletCameraTest, FramesPartsAndTheirStuds)
{
    const BrickGrid grid = test::createPartGrid({4, 6, 2}, 1.2);
    const BookletCamera camera(grid, {});
    const std::vector<Part> parts{createPart()};
    const BookletFrame frame = camera.findFrame(parts);
    EXPECT_NEAR(frame.lowest.x, camera.project({0, 0, 0}).x, 1e-12);
    EXPECT_NEAR(frame.highest.x, camera.project({4, 2, 0}).x, 1e-12);
    EXPECT_NEAR(frame.lowest.y, camera.project({4, 0, 0}).y, 1e-12);
    EXPECT_NEAR(frame.highest.y, camera.project({0, 2, 1.0 + grid.getStudHeight()}).y, 1e-12);
}

TEST(BookletCameraTest, ShowsAFrameFromEdgeToEdge)
{
    const BrickGrid grid = test::createPartGrid({4, 6, 2}, 1.2);
    const BookletCamera place(grid, {});
    const BookletFrame frame{{-1.0, -2.0}, {5.0, 6.0}};
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    place.apply(*camera, frame);
    const osg::Vec3d corner = osg::Vec3d(0, 0, 0) * camera->getViewMatrix() * camera->getProjectionMatrix();
    const glm::dvec2 origin = place.project({0, 0, 0});
    EXPECT_NEAR(corner.x(), (origin.x - 2.0) / 3.0, 1e-9);
    EXPECT_NEAR(corner.y(), (origin.y - 2.0) / 4.0, 1e-9);
    EXPECT_GT(corner.z(), -1.0);
    EXPECT_LT(corner.z(), 1.0);
}

} // namespace osgLego
