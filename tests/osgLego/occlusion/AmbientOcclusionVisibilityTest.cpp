#include "AmbientOcclusionTest.h"

#include <osgLego/data/DistantOcclusion.h>

#include <common/BrickRayCaster.h>
#include <common/RacingCar.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <osg/Math>

namespace osgLego::test
{

namespace
{

using AmbientOcclusionVisibility = AmbientOcclusionTest;

/** A white floor and wall that meet at the x axis. */
osg::ref_ptr<osg::Group> createInnerEdge()
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createQuad({-10, -10, 0}, {20, 0, 0}, {0, 10, 0}, WHITE));
    group->addChild(createQuad({-10, 0, 0}, {20, 0, 0}, {0, 0, 10}, WHITE));
    return group;
}

TEST_F(AmbientOcclusionVisibility, AnOpenPlaneSeesAllOfTheSky)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium,radius=2,show=occlusion", nullptr);
    group->addChild(createQuad({-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, WHITE));
    for (const Viewpoint& viewpoint :
         {Viewpoint{{0, -1, 20}, {}}, Viewpoint{{0, -18, 6}, {}}, Viewpoint{{0, -1, 20}, {}, {0, 0, 1}, 8},
          Viewpoint{{9, -18, 9}, {}, {0, 0, 1}, 6}})
    {
        const osg::ref_ptr<osg::Image> image = draw(*group, viewpoint);
        for (const osg::Vec3d& place :
             {osg::Vec3d(), osg::Vec3d(1, 0, 0), osg::Vec3d(-1, 1, 0), osg::Vec3d(0.5, -1, 0)})
        {
            const osg::Vec3d color = colorAt(*image, place);
            EXPECT_GT(color.x(), 0.95) << viewpoint.eye.y() << " " << viewpoint.height;
            EXPECT_EQ(color.x(), color.y());
            EXPECT_EQ(color.x(), color.z());
        }
    }
}

TEST_F(AmbientOcclusionVisibility, AnInnerEdgeSeesHalfOfTheSky)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createInnerEdge());
    for (const char* quality : {"low", "medium", "high"})
        for (const double height : {0.0, 4.0})
        {
            group->setSettings(parseOcclusion(std::string(quality) + ",radius=1,show=occlusion"));
            const osg::ref_ptr<osg::Image> image = draw(*group, {{0, -6, 6}, {}, {0, 0, 1}, height});
            for (const double along : {-0.7, 0.1, 0.8})
            {
                const auto visibility = [&](double y, double z) { return colorAt(*image, {along, y, z}).x(); };
                for (const double contact : {visibility(-0.06, 0.0), visibility(0.0, 0.06)})
                {
                    EXPECT_GT(contact, 0.45) << quality << " " << height;
                    EXPECT_LT(contact, 0.7) << quality << " " << height;
                }
                EXPECT_GT(visibility(-0.4, 0.0), visibility(-0.06, 0.0) + 0.1);
                EXPECT_GT(visibility(-1.4, 0.0), 0.97) << quality << " " << height;
                EXPECT_GT(visibility(0.0, 1.4), 0.97) << quality << " " << height;
            }
        }
}

TEST_F(AmbientOcclusionVisibility, BricksOccludeAndAreOccluded)
{
    // A wall of bricks on a wider one: the front of the lower one, near and far from the edge of the protruding one.
    osg::ref_ptr<osg::Group> steps = new osg::Group;
    steps->addChild(createBrickBox({12, 1, 12}, "12"));
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("high,show=occlusion", steps);
    const Viewpoint front{{6, -30, 6.5}, {6, 0, 6.5}, {0, 0, 1}, 9};
    osg::ref_ptr<osg::Image> image = draw(*group, front);
    for (const osg::Vec3d& place : {osg::Vec3d(3.5, 0, 8.5), osg::Vec3d(6.5, 0, 6.5), osg::Vec3d(5, 0, 7)})
        EXPECT_GT(colorAt(*image, place).x(), 0.97);
    steps->addChild(createQuad({7, 0, -1}, {0, -6, 0}, {0, 0, 14}, WHITE));
    image = draw(*group, {{-3, -20, 6.5}, {6, 0, 6.5}}); // the quad seen from its side hides no brick
    EXPECT_LT(colorAt(*image, {6.85, 0, 6.5}).x(), 0.75) << "other nodes occlude bricks";
    EXPECT_GT(colorAt(*image, {3.5, 0, 6.5}).x(), 0.97);
    steps->removeChild(1);
    steps->addChild(createQuad({-10, -6, 0}, {30, 0, 0}, {0, 6, 0}, WHITE));
    image = draw(*group, {{6, -14, 12}, {6, -1, 0}});
    EXPECT_LT(colorAt(*image, {6, -0.15, 0}).x(), 0.75) << "bricks occlude other nodes";
    EXPECT_GT(colorAt(*image, {6, -5, 0}).x(), 0.95);
}

struct Reach
{
    const char* name;
    BrickOcclusion occlusion;
    bool isDistant;
    double error; //!< the greatest root mean square
    double angle; //!< the greatest mean angle of bent normals, in degrees
};

class AmbientOcclusionReach : public AmbientOcclusionVisibility, public testing::WithParamInterface<Reach>
{
};

INSTANTIATE_TEST_SUITE_P(Reaches, AmbientOcclusionReach,
                         testing::Values(Reach{"near", BrickOcclusion::SCREEN, false, 0.08, 3.0},
                                         Reach{"distant", BrickOcclusion::SCREEN, true, 0.1, 5.5},
                                         Reach{"nearInTheGrid", BrickOcclusion::GRID, false, 0.029, 2.3},
                                         Reach{"distantInTheGrid", BrickOcclusion::GRID, true, 0.038, 3.0}),
                         [](const auto& reach) { return reach.param.name; });

TEST_P(AmbientOcclusionReach, VisibilityAndBentNormalsAreThoseOfRaysCastAtTheBricks)
{
    const Reach& wanted = GetParam();
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(wanted.isDistant ? "24" : "14"));
    BrickAppearance appearance;
    appearance.occlusion = wanted.occlusion;
    lego->setAppearance(appearance);
    lego->addChild(createRacingCar());
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", lego);
    const osg::BoundingSphere bound = lego->getBound();
    const Viewpoint viewpoint{osg::Vec3d(bound.center()) + osg::Vec3d(0.5, -0.75, 0.45) * (3.3 * bound.radius()),
                              bound.center()};
    const auto drawOutput = [&](const char* show)
    {
        group->setSettings(
            parseOcclusion(std::string("high,distant=") + (wanted.isDistant ? "on" : "off") + ",show=" + show));
        return draw(*group, viewpoint);
    };
    const osg::ref_ptr<osg::Image> visibility = drawOutput("occlusion");
    const osg::ref_ptr<osg::Image> bentNormals = drawOutput("bent-normals");
    const osg::ref_ptr<osg::Image> normals = drawOutput("normals");
    const osg::Camera& camera = *_viewer.getCamera();
    const osg::Matrixd toWorld = osg::Matrixd::inverse(camera.getViewMatrix() * camera.getProjectionMatrix() *
                                                       camera.getViewport()->computeWindowMatrix());
    const osg::Matrixd viewToWorld = camera.getInverseViewMatrix();
    const auto toGlm = [](const osg::Vec3d& vector) { return glm::dvec3(vector.x(), vector.y(), vector.z()); };

    const BrickRayCaster caster(*lego->getBricks());
    const double reach = wanted.isDistant ? DistantOcclusion::getReach(caster.getModel().getGrid())
                                          : AmbientOcclusionSettings::RADIUS_IN_BRICKS;
    const auto readDirection = [&](const osg::Image& image, int column, int row)
    {
        osg::Vec3d direction =
            osg::Matrixd::transform3x3(readColor(image, column, row) * 2.0 - osg::Vec3d(1, 1, 1), viewToWorld);
        direction.normalize();
        return toGlm(direction);
    };
    double squares = 0.0;
    double angles = 0.0;
    int count = 0;
    for (int row = 3; row < HEIGHT; row += 5)
        for (int column = 3; column < WIDTH; column += 5)
        {
            const osg::Vec3d near = osg::Vec3d(column + 0.5, row + 0.5, 0.0) * toWorld;
            osg::Vec3d direction = osg::Vec3d(column + 0.5, row + 0.5, 1.0) * toWorld - near;
            direction.normalize();
            const glm::dvec3 start = caster.toCaster(viewpoint.eye);
            const auto distance = caster.findNearest(start, toGlm(direction), 1e6);
            const osg::Vec3d shown = readColor(*visibility, column, row);
            if (!distance || shown.x() != shown.z()) continue; // the background is blue
            const BrickRayCaster::Occlusion rays = caster.sampleOcclusion(
                start + *distance * toGlm(direction), readDirection(*normals, column, row), reach,
                AmbientOcclusionSettings::FALLOFF, 256, static_cast<std::uint32_t>(row * WIDTH + column));
            squares += (shown.x() - rays.visibility) * (shown.x() - rays.visibility);
            const double cosine = glm::dot(readDirection(*bentNormals, column, row), rays.bentNormal);
            angles += osg::RadiansToDegrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
            ++count;
        }
    ASSERT_GT(count, 150);
    const double error = std::sqrt(squares / count);
    RecordProperty("rootMeanSquare", std::to_string(error));
    EXPECT_LE(error, wanted.error) << count << " pixels";
    RecordProperty("meanAngle", std::to_string(angles / count));
    EXPECT_LE(angles / count, wanted.angle) << count << " pixels";
}

TEST_F(AmbientOcclusionVisibility, NormalsAreShownInTheEyesCoordinates)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", nullptr);
    group->addChild(createBrickBox({8, 8, 2}, "8"));
    group->addChild(createQuad({10, 0, 0}, {6, 0, 0}, {0, 8, 0}, WHITE));
    const Viewpoint viewpoint{{12, -18, 20}, {8, 4, 0}};
    for (const char* show : {"normals", "bent-normals"})
    {
        group->setSettings(parseOcclusion(std::string("medium,radius=0.5,show=") + show));
        const osg::ref_ptr<osg::Image> image = draw(*group, viewpoint);
        const auto normalAt = [&](const osg::Vec3d& place)
        {
            const osg::Vec3d eye = colorAt(*image, place) * 2.0 - osg::Vec3d(1, 1, 1);
            return osg::Matrixd::transform3x3(eye, _viewer.getCamera()->getInverseViewMatrix());
        };
        EXPECT_LT((normalAt({3.5, 3.5, 2.2125}) - osg::Vec3d(0, 0, 1)).length(), 0.1) << show << ", on a stud";
        EXPECT_LT((normalAt({4.5, 0, 1.2}) - osg::Vec3d(0, -1, 0)).length(), 0.1) << show << ", a side";
        if (show[0] == 'b')
        {
            EXPECT_LT((normalAt({13, 4, 0}) - osg::Vec3d(0, 0, 1)).length(), 0.1) << "of other nodes";
        }
    }
}

} // namespace

} // namespace osgLego::test
