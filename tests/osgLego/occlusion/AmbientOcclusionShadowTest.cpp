#include "AmbientOcclusionTest.h"

#include <string>

#include <osg/LightSource>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/SoftShadowMap>
#include <osgShadow/ViewDependentShadowMap>

namespace osgLego::test
{

namespace
{

struct Technique
{
    std::string name;
    osg::ref_ptr<osgShadow::ShadowTechnique> (*create)();
};

template <typename Shadow>
Technique technique(const std::string& name)
{
    return {name, [] { return osg::ref_ptr<osgShadow::ShadowTechnique>(new Shadow); }};
}

/** Bricks and a ball on a white floor. The light comes from above, from one side. */
class AmbientOcclusionShadowTest : public AmbientOcclusionTest, public testing::WithParamInterface<Technique>
{
protected:
    AmbientOcclusionShadowTest()
    {
        _scene->addChild(createMixedScene());
        _scene->addChild(createQuad({-12, -12, -0.1f}, {32, 0, 0}, {0, 32, 0}, WHITE));
        switchLighting(*_scene, false);
        _sun->getLight()->setPosition({-2.0f, -1.0f, 3.0f, 0.0f});
        _shadowed->setShadowTechnique(GetParam().create());
    }

    const osg::ref_ptr<osg::Group> _scene = new osg::Group;
    const osg::ref_ptr<osg::LightSource> _sun = new osg::LightSource;
    const osg::ref_ptr<osgShadow::ShadowedScene> _shadowed = new osgShadow::ShadowedScene;
};

TEST_P(AmbientOcclusionShadowTest, ItIsTheSameAboveAndBelowTheShadowedScene)
{
    const osg::ref_ptr<osg::Image> withoutShadow = draw(*createGroup("medium", _scene), MIXED_VIEW);
    const osg::ref_ptr<AmbientOcclusionScene> below = createGroup("medium", _scene);
    _shadowed->addChild(below);
    _shadowed->addChild(_sun);
    const osg::ref_ptr<osg::Image> expected = draw(*_shadowed, MIXED_VIEW);
    EXPECT_GT(countDifferent(*expected, *withoutShadow, 40), 300u) << "no shadow";

    _shadowed->replaceChild(below, _scene);
    const osg::ref_ptr<AmbientOcclusionScene> above = createGroup("medium", _shadowed);
    EXPECT_LT(countDifferent(*expected, *draw(*above, MIXED_VIEW), 3), 5u);

    _shadowed->removeChild(_sun);
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(_sun);
    root->addChild(above);
    EXPECT_LT(countDifferent(*expected, *draw(*root, MIXED_VIEW), 3), 5u) << "a light outside";
}

INSTANTIATE_TEST_SUITE_P(Techniques, AmbientOcclusionShadowTest,
                         testing::Values(technique<osgShadow::ShadowMap>("ShadowMap"),
                                         technique<osgShadow::SoftShadowMap>("SoftShadowMap"),
                                         technique<osgShadow::ViewDependentShadowMap>("ViewDependentShadowMap")),
                         [](const auto& test) { return test.param.name; });

} // namespace

} // namespace osgLego::test
