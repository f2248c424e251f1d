#include <common/BrickRayCaster.h>

#include <LookTest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/Geode>
#include <osg/Group>
#include <osg/Light>
#include <osg/LightSource>
#include <osg/ShapeDrawable>
#include <osgShadow/LightSpacePerspectiveShadowMap>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/SoftShadowMap>
#include <osgShadow/StandardShadowMap>
#include <osgShadow/ViewDependentShadowMap>

namespace osgLego::test
{

namespace
{

const osg::Vec3 BALL_CENTER(2.5f, 2.0f, 5.0f);
constexpr float BALL_RADIUS = 1.7f;
const Viewpoint SHADOW_VIEW{{7, -8, 16}, {4, 3.8, 1}};
const osg::Vec3 SUN(-0.45f, -0.35f, 0.82f);
const osg::Vec4 DARK(0.0f, 0.0f, 0.0f, 1.0f);

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

/** A SoftShadowMap that blurs the edges of shadows by hardly more than a texel, which isAwayFromEdges() leaves out. */
osg::ref_ptr<osgShadow::ShadowTechnique> createSharpSoftShadowMap()
{
    osg::ref_ptr<osgShadow::SoftShadowMap> technique = new osgShadow::SoftShadowMap;
    technique->setSoftnessWidth(0.0012f);
    return technique;
}

glm::dvec3 toGlm(const osg::Vec3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

/** The distance along a ray to the ball, infinite if it misses. @param direction of length 1. */
double findBall(const osg::Vec3d& origin, const osg::Vec3d& direction)
{
    const osg::Vec3d toCenter = BALL_CENTER - origin;
    const double middle = toCenter * direction;
    const double inside = BALL_RADIUS * BALL_RADIUS - (toCenter.length2() - middle * middle);
    return inside < 0.0 || middle < 0.0 ? std::numeric_limits<double>::infinity() : middle - std::sqrt(inside);
}

/** A directional light. */
osg::ref_ptr<osg::LightSource> createLight(int number, const osg::Vec3& towards)
{
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->getLight()->setLightNum(number);
    source->getLight()->setPosition(osg::Vec4(towards, 0.0f));
    source->getLight()->setAmbient(DARK); // osgShadow::ShadowMap sets this
    return source;
}

void setColor(osg::LightSource& source, const osg::Vec4& color)
{
    source.getLight()->setDiffuse(color);
    source.getLight()->setSpecular(color);
}

/** What a pixel shows. */
enum class Shown
{
    OTHER, //!< no brick
    LIT,
    SHADOWED
};

using Wrap = std::function<osg::ref_ptr<osg::Group>(osg::Node&)>;

/** A sheet with a tower, both of bricks, and a ball above on a floor. */
class BrickShadowTest : public LookTest
{
protected:
    static osg::ref_ptr<LegoNode> createBricks(const std::string& settings)
    {
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(new osg::ShapeDrawable(new osg::Box(osg::Vec3(4, 4, 0.5f), 8, 8, 1)));
        geode->addDrawable(new osg::ShapeDrawable(new osg::Box(osg::Vec3(5, 6, 2.5f), 2, 2, 3)));
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("8,device=cpu," + settings));
        lego->setLightProbe(createDarkProbe());
        lego->setWaiting(true);
        lego->addChild(geode);
        return lego;
    }

    static osg::ref_ptr<osg::Group> createScene(LegoNode& lego)
    {
        osg::ref_ptr<osg::Geode> ball = new osg::Geode;
        ball->addDrawable(new osg::ShapeDrawable(new osg::Sphere(BALL_CENTER, BALL_RADIUS)));
        osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(&lego);
        scene->addChild(ball);
        scene->addChild(createQuad({-12, -12, -0.1f}, {32, 0, 0}, {0, 32, 0}, {1, 1, 1, 1}));
        return scene;
    }

    static osg::ref_ptr<osg::Group> createPlain(osg::Node& child)
    {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(&child);
        return group;
    }

    static osg::ref_ptr<osg::Group> createShadowed(osg::Node& child, osgShadow::ShadowTechnique* technique)
    {
        const osg::ref_ptr<osgShadow::ShadowedScene> shadowed = new osgShadow::ShadowedScene;
        shadowed->setShadowTechnique(technique);
        shadowed->addChild(&child);
        return shadowed;
    }

    static osg::ref_ptr<osg::Group> createOccluded(osg::Node& child)
    {
        osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", &child);
        group->setLightProbe(createDarkProbe());
        return group;
    }

    /** The picture of a scene in the light of all sources. Some techniques need the previous frame. */
    osg::ref_ptr<osg::Image> drawLit(osg::Node& scene)
    {
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        for (const osg::ref_ptr<osg::LightSource>& light : _lights)
        {
            root->addChild(light);
            root->getOrCreateStateSet()->setMode(
                GL_LIGHT0 + static_cast<unsigned int>(light->getLight()->getLightNum()), osg::StateAttribute::ON);
        }
        root->addChild(&scene);
        draw(*root, SHADOW_VIEW);
        _viewer.frame();
        return draw(*root, SHADOW_VIEW);
    }

    /** What each pixel of the last picture shows in a light, by casting rays. */
    std::vector<Shown> castRays(const BrickModel& model, const osg::Light& light) const;

    /** Compare a picture with shadows with pictures without: of all lights off, and of each light alone.
     * @param wrap returns a group around a scene, without shadows.
     * @param wrapShadowed likewise, with shadows of the last lights. */
    void expectShadows(const std::string& settings, const Wrap& wrap, const Wrap& wrapShadowed);

    std::vector<osg::ref_ptr<osg::LightSource>> _lights{createLight(0, SUN)};
    std::size_t _firstShadow = 0; // the first light with shadows
    osg::Vec4 _brightness{2.0f, 2.0f, 2.0f, 1.0f};
};

std::vector<Shown> BrickShadowTest::castRays(const BrickModel& model, const osg::Light& light) const
{
    const BrickRayCaster caster(model);
    const osg::Camera& camera = *_viewer.getCamera();
    const osg::Matrixd toWorld = osg::Matrixd::inverse(camera.getViewMatrix() * camera.getProjectionMatrix() *
                                                       camera.getViewport()->computeWindowMatrix());
    const osg::Vec4d lightPosition(light.getPosition());
    std::vector<Shown> shown;
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column)
        {
            osg::Vec3d direction = osg::Vec3d(column + 0.5, row + 0.5, 0.5) * toWorld - SHADOW_VIEW.eye;
            direction.normalize();
            const auto hit = caster.findNearest(caster.toCaster(SHADOW_VIEW.eye), toGlm(direction), 100.0);
            const double distance = hit ? *hit * caster.getPitch() : 100.0;
            if (!hit || findBall(SHADOW_VIEW.eye, direction) < distance)
            {
                shown.push_back(Shown::OTHER);
                continue;
            }
            const osg::Vec3d place = SHADOW_VIEW.eye + direction * (distance - 1e-3);
            osg::Vec3d toLight(lightPosition.x(), lightPosition.y(), lightPosition.z());
            toLight -= place * lightPosition.w();
            const double range = lightPosition.w() == 0.0 ? 100.0 : toLight.length() / caster.getPitch();
            toLight.normalize();
            const bool isHidden = caster.findNearest(caster.toCaster(place), toGlm(toLight), range).has_value() ||
                                  findBall(place, toLight) < range * caster.getPitch();
            shown.push_back(isHidden ? Shown::SHADOWED : Shown::LIT);
        }
    return shown;
}

/** Whether all pixels around one show the same. */
bool isAwayFromEdges(const std::vector<Shown>& shown, int column, int row)
{
    constexpr int MARGIN = 4;
    const auto at = [&shown](int x, int y)
    {
        const int place = std::clamp(y, 0, GlTest::HEIGHT - 1) * GlTest::WIDTH + std::clamp(x, 0, GlTest::WIDTH - 1);
        return shown[static_cast<std::size_t>(place)];
    };
    for (int y = -MARGIN; y <= MARGIN; ++y)
        for (int x = -MARGIN; x <= MARGIN; ++x)
            if (at(column + x, row + y) != at(column, row)) return false;
    return true;
}

void BrickShadowTest::expectShadows(const std::string& settings, const Wrap& wrap, const Wrap& wrapShadowed)
{
    constexpr double DISTINCT = 0.05;
    const osg::ref_ptr<LegoNode> lego = createBricks(settings);
    const osg::ref_ptr<osg::Group> scene = createScene(*lego);
    const osg::ref_ptr<osg::Group> plain = wrap(*scene);
    for (const osg::ref_ptr<osg::LightSource>& light : _lights)
        setColor(*light, DARK);
    const osg::ref_ptr<osg::Image> dark = drawLit(*plain);
    std::vector<osg::ref_ptr<osg::Image>> alone;
    std::vector<std::vector<Shown>> shown;
    for (const osg::ref_ptr<osg::LightSource>& light : _lights)
    {
        setColor(*light, _brightness);
        alone.push_back(drawLit(*plain));
        shown.push_back(castRays(*lego->getBricks(), *light->getLight()));
        setColor(*light, DARK);
    }
    for (const osg::ref_ptr<osg::LightSource>& light : _lights)
        setColor(*light, _brightness);
    const osg::ref_ptr<osg::Image> image = drawLit(*wrapShadowed(*scene));

    std::size_t numWrong = 0;
    std::vector<std::size_t> numLit(_lights.size());
    std::vector<std::size_t> numShadowed(_lights.size());
    for (int row = 0; row < HEIGHT; ++row)
        for (int column = 0; column < WIDTH; ++column)
        {
            double expected = brightnessAt(*dark, column, row);
            double range = 0.0;
            bool isComparable = true;
            for (std::size_t light = 0; light < _lights.size(); ++light)
            {
                const Shown here = shown[light][static_cast<std::size_t>(row * WIDTH + column)];
                isComparable = isComparable && here != Shown::OTHER &&
                               (light < _firstShadow || isAwayFromEdges(shown[light], column, row));
                const double part = brightnessAt(*alone[light], column, row) - brightnessAt(*dark, column, row);
                const bool isLit = here == Shown::LIT || light < _firstShadow;
                if (isLit) expected += part;
                range = std::max(range, part);
                if (isComparable && part > DISTINCT) ++(isLit ? numLit : numShadowed)[light];
            }
            if (!isComparable || range < DISTINCT) continue;
            if (std::abs(brightnessAt(*image, column, row) - expected) > 0.1 * range) ++numWrong;
        }
    for (std::size_t light = _firstShadow; light < _lights.size(); ++light)
    {
        EXPECT_GT(numLit[light], 300u);
        EXPECT_GT(numShadowed[light], 300u);
    }
    // Texels are a twentieth of a brick wide: a few pixels at the feet of studs are too near the edge of a shadow.
    EXPECT_LT(numWrong, 10u) << "of " << numLit.back() << " in the light and " << numShadowed.back() << " in shadow";
}

/** A second light. */
const osg::Vec3 LAMP(-0.2f, -0.25f, 0.94f);

TEST_F(BrickShadowTest, ALightWithoutShadowMapReachesBricksInTheShadowOfAnother)
{
    // osgShadow takes the last light.
    _firstShadow = 1;
    _lights.insert(_lights.begin(), createLight(1, LAMP));
    _brightness = osg::Vec4(0.5f, 0.5f, 0.5f, 1.0f);
    expectShadows("look=plain", createPlain,
                  [](osg::Node& scene) { return createShadowed(scene, new osgShadow::ShadowMap); });
}

TEST_F(BrickShadowTest, ALightAtAPlaceCastsShadows)
{
    _lights.front()->getLight()->setPosition({-2.0f, -1.5f, 12.0f, 1.0f});
    expectShadows("look=plain", createPlain,
                  [](osg::Node& scene) { return createShadowed(scene, new osgShadow::ShadowMap); });
}

TEST_F(BrickShadowTest, EachLightHasItsOwnShadows)
{
    _lights.push_back(createLight(1, LAMP));
    _brightness = osg::Vec4(0.5f, 0.5f, 0.5f, 1.0f);
    expectShadows("look=plain", createPlain,
                  [](osg::Node& scene) { return createShadowed(scene, new osgShadow::ViewDependentShadowMap); });
}

TEST_F(BrickShadowTest, EdgesOfSoftShadowsAreSoft)
{
    const osg::ref_ptr<LegoNode> lego = createBricks("look=plain");
    const osg::ref_ptr<osg::Group> scene = createScene(*lego);
    setColor(*_lights.front(), DARK);
    const osg::ref_ptr<osg::Image> dark = drawLit(*scene);
    setColor(*_lights.front(), _brightness);
    const osg::ref_ptr<osg::Image> lit = drawLit(*scene);
    const std::vector<Shown> shown = castRays(*lego->getBricks(), *_lights.front()->getLight());
    const auto countHalf = [&](osgShadow::ShadowTechnique* technique)
    {
        const osg::ref_ptr<osg::Image> image = drawLit(*createShadowed(*scene, technique));
        int count = 0;
        for (int row = 0; row < HEIGHT; ++row)
            for (int column = 0; column < WIDTH; ++column)
            {
                const double range = brightnessAt(*lit, column, row) - brightnessAt(*dark, column, row);
                if (shown[static_cast<std::size_t>(row * WIDTH + column)] == Shown::OTHER || range < 0.05) continue;
                const double share = (brightnessAt(*image, column, row) - brightnessAt(*dark, column, row)) / range;
                count += share > 0.25 && share < 0.75 ? 1 : 0;
            }
        return count;
    };
    EXPECT_GT(countHalf(new osgShadow::SoftShadowMap), 2 * countHalf(new osgShadow::ShadowMap));
}

/** Light from a colour, 0 to 1: the inverse of toColor() in shaders/light/color_space.glsl. */
double toLight(double color)
{
    const double light = std::pow(color, 2.2 / 1.2);
    const double above = (light - 0.75) / 0.25;
    return above > 0.0 ? 0.75 + 0.25 * above / (1.0 - above) : light;
}

TEST_F(BrickShadowTest, ShadowsHideTheDocumentedShareOfTheEnvironmentLight)
{
    const osg::ref_ptr<LightProbe> probe = new LightProbe;
    const osg::ref_ptr<LegoNode> lego = createBrickBox({8, 8, 1}, "8,device=cpu", {0.8f, 0.8f, 0.8f, 1.0f});
    BrickAppearance appearance;
    appearance.variation = 0.0;
    appearance.occlusion = BrickOcclusion::OFF;
    lego->setAppearance(appearance);
    lego->setLightProbe(probe);
    lego->setWaiting(true);
    const osg::ref_ptr<osg::Group> scene = createScene(*lego);
    // Beside a stud in the middle of the ball's shadow.
    const osg::Vec3d place(4.82, 3.82, 1.0);
    const Viewpoint view{{4.8, -1, 9}, place};
    const auto lightOf = [&](osg::Node& node)
    {
        drawLit(node);
        return toLight(colorAt(*draw(*_viewer.getSceneData(), view), place).x());
    };
    setColor(*_lights.front(), DARK);
    const double without = lightOf(*scene);
    setColor(*_lights.front(), _brightness);
    const double shadowed = lightOf(*createShadowed(*scene, new osgShadow::ShadowMap));
    const double cosine = SUN.z() / SUN.length();
    const double albedo = std::pow(0.8, 2.2 / 1.2);
    const double expected = 0.6 * cosine * albedo * probe->getIrradiance({0, 0, 1}).x();
    EXPECT_NEAR(without - shadowed, expected, 0.03 * expected) << without << ' ' << shadowed;
}

class BrickShadowTechniqueTest : public BrickShadowTest,
                                 public testing::WithParamInterface<std::tuple<Technique, std::string>>
{
protected:
    static osg::ref_ptr<osg::Group> shade(osg::Node& child)
    {
        return createShadowed(child, std::get<0>(GetParam()).create());
    }

    static std::string getDrawing() { return "drawing=" + std::get<1>(GetParam()); }
};

TEST_P(BrickShadowTechniqueTest, ShadowsFallOnBricksOfThePlainLook)
{
    expectShadows("look=plain," + getDrawing(), createPlain, shade);
}

TEST_P(BrickShadowTechniqueTest, ShadowsFallOnBricksOfTheFullLook)
{
    expectShadows("look=full," + getDrawing(), createPlain, shade);
}

const auto TECHNIQUES =
    testing::Values(technique<osgShadow::ShadowMap>("ShadowMap"), Technique{"SoftShadowMap", createSharpSoftShadowMap},
                    technique<osgShadow::StandardShadowMap>("StandardShadowMap"),
                    technique<osgShadow::LightSpacePerspectiveShadowMapVB>("LightSpacePerspectiveShadowMapVB"),
                    technique<osgShadow::LightSpacePerspectiveShadowMapCB>("LightSpacePerspectiveShadowMapCB"),
                    technique<osgShadow::LightSpacePerspectiveShadowMapDB>("LightSpacePerspectiveShadowMapDB"),
                    technique<osgShadow::ViewDependentShadowMap>("ViewDependentShadowMap"));

std::string getTestName(const testing::TestParamInfo<std::tuple<Technique, std::string>>& test)
{
    return std::get<0>(test.param).name + "_" + std::get<1>(test.param);
}

INSTANTIATE_TEST_SUITE_P(Techniques, BrickShadowTechniqueTest,
                         testing::Combine(TECHNIQUES, testing::Values("splats", "triangles")), getTestName);

TEST_P(BrickShadowTechniqueTest, ShadowsFallOnBricksOfAnOccludedSceneInAShadowedScene)
{
    expectShadows("look=full," + getDrawing(), createOccluded,
                  [](osg::Node& scene) { return shade(*createOccluded(scene)); });
}

TEST_P(BrickShadowTechniqueTest, ShadowsFallOnBricksOfAShadowedSceneInAnOccludedScene)
{
    expectShadows("look=full," + getDrawing(), createOccluded,
                  [](osg::Node& scene) { return createOccluded(*shade(scene)); });
}

} // namespace

} // namespace osgLego::test
