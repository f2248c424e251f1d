#include "AmbientOcclusionTest.h"

#include <Probes.h>

#include <vector>

#include <osg/LightSource>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

using AmbientOcclusionLight = AmbientOcclusionTest;

TEST_F(AmbientOcclusionLight, LightsInsideLightNodesOutside)
{
    osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
    lamp->getLight()->setLightNum(1);
    lamp->getLight()->setPosition(osg::Vec4(4, -10, 8, 1));
    lamp->getLight()->setDiffuse(osg::Vec4(0.9f, 0.8f, 0.3f, 1.0f));
    osg::ref_ptr<osg::Group> children = new osg::Group;
    children->addChild(lamp);
    children->addChild(createBrickBox({8, 8, 2}, "8"));
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", children);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(createQuad({-2, 9, 0}, {12, 0, 0}, {0, 0, 6}, WHITE));
    root->addChild(group);
    root->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    lamp->setStateSetModes(*root->getStateSet(), osg::StateAttribute::ON);
    const osg::Vec3d place(4, 9, 5);
    const Pair pair = drawBoth(*root, *group, MIXED_VIEW);
    EXPECT_LT((colorAt(*pair.with, place) - colorAt(*pair.without, place)).length(), 0.01);
    root->getStateSet()->setMode(GL_LIGHT1, osg::StateAttribute::OFF);
    EXPECT_GT((colorAt(*pair.with, place) - colorAt(*draw(*root, MIXED_VIEW), place)).length(), 0.2);
}

TEST_F(AmbientOcclusionLight, LightThatComesStraightIsTheSameInsideAndOutside)
{
    for (const bool isPlaced : {false, true})
    {
        const osg::ref_ptr<LegoNode> lego = createBrickBox({8, 8, 2}, "8", osg::Vec4(0.6f, 0.4f, 0.3f, 1.0f));
        lego->setLightProbe(createDarkProbe());
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", lego);
        group->setLightProbe(createDarkProbe());
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(group);
        if (isPlaced)
        {
            osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
            lamp->getLight()->setPosition(osg::Vec4(9, -6, 8, 1));
            root->addChild(lamp);
        }
        const Pair pair = drawBoth(*root, *group, MIXED_VIEW);
        EXPECT_GT(countDrawn(*pair.with), 3000u);
        EXPECT_LE(countDifferent(*pair.with, *pair.without, 3), FEW_PIXELS) << isPlaced;
    }
}

/** Red light from +X of the world. */
osg::ref_ptr<LightProbe> createRedProbe()
{
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    std::string error;
    const auto radianceOf = [](const osg::Vec3d& direction)
    { return direction.x() > 0.6 ? osg::Vec3d(1, 0, 0) : osg::Vec3d(); };
    EXPECT_TRUE(probe->setImage(createLatitudeLongitude(64, radianceOf), LightProbe::AUTO, error)) << error;
    return probe;
}

class ProbeInTheWorld : public AmbientOcclusionLight
{
protected:
    /** Compare the irradiance shown on three sides of a cube in the world with the probe's irradiance. */
    void expectIrradiance(const osg::Image& image, const LightProbe& probe, const Viewpoint& viewpoint)
    {
        for (const osg::Vec3d& normal : {osg::Vec3d(1, 0, 0), osg::Vec3d(-1, 0, 0), osg::Vec3d(0, 1, 0),
                                         osg::Vec3d(0, -1, 0), osg::Vec3d(0, 0, 1)})
        {
            if (normal * (viewpoint.eye - normal * 2.0) < 2.0) continue; // back-facing
            // Between studs, if there are any.
            const osg::Vec3d place = normal * 2.0 + (normal.z() > 0.0 ? osg::Vec3d() : osg::Vec3d(0, 0, 0.2));
            const osg::Vec3d expected = probe.getIrradiance(normal);
            EXPECT_LT((colorAt(image, place) - expected).length(), normal.z() > 0.0 ? 0.25 : 0.03)
                << normal.x() << " " << normal.y() << " " << normal.z() << " from " << viewpoint.eye.x() << ": "
                << colorAt(image, place).x() << " instead of " << expected.x();
        }
    }

    static osg::ref_ptr<LegoNode> createCube(osg::Matrix& centered)
    {
        centered = osg::Matrix::translate(-2, -2, -2);
        return createBrickBox({4, 4, 4}, "4", WHITE);
    }

    const std::vector<Viewpoint> _viewpoints{{{7, -11, 5}, {}}, {{12, 3, 5}, {}}, {{-9, 8, -4}, {}}};
};

TEST_F(ProbeInTheWorld, StaysWhereItIsWhenTheCameraGoesAround)
{
    for (const double turn : {0.0, 0.5})
        for (const bool isTexture : {false, true})
        {
            const osg::ref_ptr<LightProbe> probe = createRedProbe();
            probe->setRotation(osg::Quat(turn, osg::Vec3d(0, 0, 1)));
            EXPECT_GT(probe->getIrradiance(osg::Vec3d(1, 0, 0)).x(), 0.3);
            osg::Matrix centered;
            const osg::ref_ptr<LegoNode> cube = createCube(centered);
            // A quarter turn takes the cube's sides to other sides.
            osg::ref_ptr<osg::MatrixTransform> turned =
                new osg::MatrixTransform(centered * osg::Matrix::rotate(0.5 * osg::PI, osg::Vec3d(0, 0, 1)));
            const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium,show=irradiance", cube);
            group->setLightProbe(probe);
            turned->addChild(group);
            for (const Viewpoint& viewpoint : _viewpoints)
                expectIrradiance(isTexture ? *drawToTexture(*turned, viewpoint, 0) : *draw(*turned, viewpoint), *probe,
                                 viewpoint);
        }
}

TEST_F(ProbeInTheWorld, LightsBricksWithoutAGroupToo)
{
    for (const bool isTexture : {false, true})
    {
        osg::Matrix centered;
        const osg::ref_ptr<LegoNode> cube = createCube(centered);
        cube->setLightProbe(createRedProbe());
        osg::ref_ptr<osg::MatrixTransform> turned =
            new osg::MatrixTransform(centered * osg::Matrix::rotate(0.5 * osg::PI, osg::Vec3d(0, 0, 1)));
        turned->addChild(cube);
        turned->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
        for (const Viewpoint& viewpoint : {_viewpoints[0], _viewpoints[1]})
        {
            const osg::ref_ptr<osg::Image> image =
                isTexture ? drawToTexture(*turned, viewpoint, 0) : draw(*turned, viewpoint);
            const osg::Vec3d red = colorAt(*image, {2, 0.5, 0.5});
            EXPECT_GT(red.x(), 0.4) << isTexture;
            EXPECT_LT(red.y(), 0.1);
            const osg::Vec3d dark =
                colorAt(*image, viewpoint.eye.y() < 0.0 ? osg::Vec3d(0.5, -2, 0.5) : osg::Vec3d(0.5, 2, 0.5));
            EXPECT_LT(dark.x(), red.x() - 0.2);
        }
    }
}

} // namespace

} // namespace osgLego::test
