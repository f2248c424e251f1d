#include "SceneLibrary.h"

#include <common/RacingCar.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>
#include <osgLego/Palette.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <osg/BlendFunc>
#include <osg/Camera>
#include <osg/ClipNode>
#include <osg/Fog>
#include <osg/Geode>
#include <osg/Group>
#include <osg/LightSource>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Program>
#include <osg/ShapeDrawable>
#include <osg/Texture2D>
#include <osg/Uniform>

namespace osgLego::test
{

namespace
{

constexpr unsigned int RESOLUTION = 40; // a brick is about 5 pixels wide
const osg::Vec4 GREY(0.75f, 0.75f, 0.72f, 1.0f);
const osg::Vec4 GREEN(0.25f, 0.62f, 0.30f, 1.0f);
const osg::Vec4 ORANGE(0.95f, 0.55f, 0.10f, 1.0f);

osg::ref_ptr<LegoNode> createLego(const osg::ref_ptr<osg::Node>& source = createRacingCar(),
                                  unsigned int resolution = RESOLUTION)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->addChild(source);
    return lego;
}

template <typename... Nodes>
osg::ref_ptr<osg::Group> groupOf(const Nodes&... nodes)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    (group->addChild(nodes), ...);
    return group;
}

template <typename... Nodes>
osg::ref_ptr<AmbientOcclusionScene> occlusionOf(const Nodes&... nodes)
{
    osg::ref_ptr<AmbientOcclusionScene> group = new AmbientOcclusionScene;
    (group->addChild(nodes), ...);
    return group;
}

osg::ref_ptr<osg::ShapeDrawable> createShape(const osg::ref_ptr<osg::Shape>& shape, const osg::Vec4& color)
{
    osg::ref_ptr<osg::ShapeDrawable> drawable = new osg::ShapeDrawable(shape);
    drawable->setColor(color);
    return drawable;
}

osg::ref_ptr<osg::Node> createBox(const osg::Vec3& middle, const osg::Vec3& size, const osg::Vec4& color)
{
    return createShape(new osg::Box(middle, size.x(), size.y(), size.z()), color);
}

osg::ref_ptr<osg::Node> createSphere(const osg::Vec3& middle, float radius, const osg::Vec4& color)
{
    return createShape(new osg::Sphere(middle, radius), color);
}

osg::ref_ptr<osg::Node> createGround()
{
    return createBox(osg::Vec3(0, 0, -0.05f), osg::Vec3(6.0f, 4.0f, 0.1f), GREY);
}

/** A transparent upright pane across the car. */
osg::ref_ptr<osg::Node> createPane(float x, const osg::Vec4& color)
{
    osg::ref_ptr<osg::Node> pane = createBox(osg::Vec3(x, -1.15f, 0.6f), osg::Vec3(1.1f, 0.02f, 1.3f), color);
    osg::StateSet* state = pane->getOrCreateStateSet();
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    return pane;
}

osg::ref_ptr<osg::LightSource> createLight(int number, const osg::Vec4& position, const osg::Vec4& color)
{
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->getLight()->setLightNum(number);
    source->getLight()->setPosition(position);
    source->getLight()->setAmbient(osg::Vec4(0, 0, 0, 1));
    source->getLight()->setDiffuse(color);
    source->getLight()->setSpecular(color);
    return source;
}

osg::ref_ptr<osg::Node> createEmbedded()
{
    return occlusionOf(createLego(), createGround(), createSphere(osg::Vec3(-0.9f, -0.9f, 0.25f), 0.4f, ORANGE));
}

osg::ref_ptr<osg::Node> createOutside()
{
    return groupOf(occlusionOf(createLego()), createGround(), createSphere(osg::Vec3(0.3f, -0.4f, 0.6f), 0.4f, ORANGE),
                   createBox(osg::Vec3(-1.0f, 0, 0.5f), osg::Vec3(0.2f, 2.4f, 0.3f), GREEN));
}

osg::ref_ptr<osg::Node> createOverlapping()
{
    osg::ref_ptr<osg::MatrixTransform> across = new osg::MatrixTransform(
        osg::Matrix::rotate(1.2, osg::Vec3(0, 0, 1)) * osg::Matrix::translate(osg::Vec3(-0.3f, 0, 0.25f)));
    across->addChild(createLego());
    return groupOf(occlusionOf(createLego()), occlusionOf(across));
}

osg::ref_ptr<osg::Node> createTransparent()
{
    return groupOf(occlusionOf(createLego(), createPane(-1.0f, osg::Vec4(0.9f, 0.2f, 0.1f, 0.5f))),
                   createPane(0.7f, osg::Vec4(0.1f, 0.3f, 0.9f, 0.5f)));
}

const char* const RECEIVER_VERTEX = R"(
uniform mat4 toShadow;
varying vec4 place;
void main()
{
    place = toShadow * gl_Vertex;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
})";

const char* const RECEIVER_FRAGMENT = R"(
uniform sampler2DShadow depths;
varying vec4 place;
void main()
{
    gl_FragColor = vec4(vec3(0.35 + 0.4 * shadow2DProj(depths, place).r), 1.0);
})";

/** A camera that draws only depth, in the direction of the light, like those of osgShadow's techniques. These can't be
 * used here: they find no lights below a camera that renders to a texture. */
osg::ref_ptr<osg::Camera> createShadowCamera(osg::Texture2D& depths, const osg::Vec3& toLight)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->attach(osg::Camera::DEPTH_BUFFER, &depths);
    camera->setViewport(0, 0, depths.getTextureWidth(), depths.getTextureHeight());
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionMatrixAsOrtho(-4, 4, -4, 4, 1, 20);
    camera->setViewMatrixAsLookAt(toLight * 10.0f, osg::Vec3(), osg::Vec3(0, 0, 1));
    return camera;
}

osg::ref_ptr<osg::Node> createShadow()
{
    constexpr int SIZE = 512;
    osg::ref_ptr<osg::Texture2D> depths = new osg::Texture2D;
    depths->setTextureSize(SIZE, SIZE);
    depths->setInternalFormat(GL_DEPTH_COMPONENT);
    depths->setShadowComparison(true);
    depths->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    const osg::ref_ptr<osg::Node> bricks = occlusionOf(createLego());
    const osg::ref_ptr<osg::Camera> camera = createShadowCamera(*depths, osg::Vec3(-0.4f, 0.5f, 0.7f));
    camera->addChild(bricks);

    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, RECEIVER_VERTEX));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, RECEIVER_FRAGMENT));
    const osg::Matrix toShadow = camera->getViewMatrix() * camera->getProjectionMatrix() *
                                 osg::Matrix::translate(1, 1, 1) * osg::Matrix::scale(0.5, 0.5, 0.5);
    const osg::ref_ptr<osg::Node> ground = createGround();
    osg::StateSet* state = ground->getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->setTextureAttributeAndModes(0, depths);
    state->addUniform(new osg::Uniform("depths", 0));
    state->addUniform(new osg::Uniform("toShadow", osg::Matrixf(toShadow)));
    return groupOf(camera, bricks, ground);
}

osg::ref_ptr<osg::Node> createLights()
{
    const osg::ref_ptr<osg::LightSource> directional =
        createLight(1, osg::Vec4(-1.0f, -0.3f, 0.5f, 0), osg::Vec4(0.9f, 0.1f, 0.1f, 1));
    const osg::ref_ptr<osg::LightSource> point =
        createLight(2, osg::Vec4(1.2f, -1.3f, 0.8f, 1), osg::Vec4(0.1f, 1.2f, 0.1f, 1));
    point->getLight()->setQuadraticAttenuation(1.5f);
    const osg::ref_ptr<osg::LightSource> spot = createLight(3, osg::Vec4(0, 0, 3, 1), osg::Vec4(0.2f, 0.2f, 1.5f, 1));
    spot->getLight()->setDirection(osg::Vec3(0, 0, -1));
    spot->getLight()->setSpotCutoff(14.0f);
    const osg::ref_ptr<osg::Group> scene = groupOf(directional, point, spot, occlusionOf(createLego(), createGround()));
    for (unsigned int light = GL_LIGHT1; light <= GL_LIGHT3; ++light)
        scene->getOrCreateStateSet()->setMode(light, osg::StateAttribute::ON);
    scene->getStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF);
    return scene;
}

osg::ref_ptr<osg::Node> createFog()
{
    osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setMode(osg::Fog::LINEAR);
    fog->setStart(6.5f); // the centre of the car is about 9 away
    fog->setEnd(11.0f);
    fog->setColor(osg::Vec4(0.66f, 0.72f, 0.79f, 1.0f)); // the background's
    const osg::ref_ptr<osg::Group> scene = groupOf(occlusionOf(createLego(), createGround()));
    scene->getOrCreateStateSet()->setAttributeAndModes(fog);
    return scene;
}

osg::ref_ptr<osg::Node> createClip()
{
    osg::ref_ptr<osg::ClipNode> scene = new osg::ClipNode;
    scene->addClipPlane(new osg::ClipPlane(0, osg::Plane(osg::Vec3(0.3f, 1, 0), osg::Vec3(0, -0.1f, 0))));
    scene->addChild(occlusionOf(createLego()));
    return scene;
}

osg::ref_ptr<osg::Node> createMaterial()
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    BrickAppearance appearance;
    appearance.materialSpecular = true;
    lego->setAppearance(appearance);
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setSpecular(osg::Material::FRONT_AND_BACK, osg::Vec4(1.0f, 0.9f, 0.2f, 1.0f));
    material->setShininess(osg::Material::FRONT_AND_BACK, 12.0f);
    const osg::ref_ptr<osg::Group> scene = groupOf(occlusionOf(lego));
    scene->getOrCreateStateSet()->setAttributeAndModes(material);
    return scene;
}

osg::ref_ptr<osg::Node> createNoJoints()
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    BrickAppearance appearance;
    appearance.joints = false;
    appearance.reliefHeight = 0.0;
    appearance.variation = 0.0;
    lego->setAppearance(appearance);
    return occlusionOf(lego);
}

/** A raised ring around an arrow that points along +X. */
osg::ref_ptr<osg::Image> createRelief()
{
    constexpr int SIZE = 64;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(SIZE, SIZE, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    for (int row = 0; row < SIZE; ++row)
        for (int column = 0; column < SIZE; ++column)
        {
            const double x = (column + 0.5) / SIZE * 2.0 - 1.0;
            const double y = (row + 0.5) / SIZE * 2.0 - 1.0;
            const bool isRing = std::abs(std::hypot(x, y) - 0.8) < 0.08;
            const bool isShaft = x > -0.5 && x < 0.1 && std::abs(y) < 0.12;
            const bool isHead = x >= 0.1 && x < 0.55 && std::abs(y) < 0.55 - x;
            *image->data(column, row) = isRing || isShaft || isHead ? 255 : 0;
        }
    return image;
}

osg::ref_ptr<osg::Node> createReliefImage()
{
    const osg::ref_ptr<LegoNode> lego = createLego();
    BrickAppearance appearance;
    appearance.reliefImage = createRelief();
    appearance.reliefHeight = 0.12;
    lego->setAppearance(appearance);
    return occlusionOf(lego);
}

osg::ref_ptr<LegoNode> createPartsNode(double outline)
{
    const osg::ref_ptr<LegoNode> lego = createLego(createRacingCar(), 32);
    LegoSettings settings = lego->getSettings();
    settings.grid.proportions = Proportions::BRICK;
    settings.parts.set = PartSet::BRICKS;
    lego->setSettings(settings);
    BrickAppearance appearance;
    appearance.outline = outline;
    lego->setAppearance(appearance);
    return lego;
}

/** The first half of the car's parts, in layers, so that the picture doesn't change with the planner.
 * @param numNew the number of highlighted parts. */
osg::ref_ptr<osg::Node> createHalf(std::size_t numNew)
{
    const osg::ref_ptr<LegoNode> lego = createPartsNode(numNew > 0 ? 1.0 : 0.0);
    BuildingStep all;
    all.parts.resize(lego->getBricks()->getParts().size()); // sorted by their lowest layer
    std::iota(all.parts.begin(), all.parts.end(), 0u);
    lego->setBuildingPlan(BuildingPlan::create(all.parts.size(), {all}));
    lego->setBuildProgress(0.5);
    lego->setNumNewParts(numNew);
    return occlusionOf(lego);
}

/** A pair of parts in each colour, of which the right one is new. */
osg::ref_ptr<osg::Node> createStepInColors()
{
    constexpr int ACROSS = 7;
    std::string error;
    const std::span<const PaletteColor> colors = Palette::read("ldraw", error)->getColors();
    BrickGrid grid;
    grid.dimensions = glm::ivec3(5 * ACROSS, 3 * static_cast<int>(colors.size() / ACROSS + 1), 1);
    grid.cellSize = glm::dvec3(1.0, 1.0, 1.2);
    std::vector<Part> parts;
    for (std::size_t index = 0; index < colors.size(); ++index)
        for (const int column : {0, 2})
        {
            Part& part = parts.emplace_back();
            part.cell = {static_cast<std::uint16_t>(5 * (index % ACROSS) + static_cast<std::size_t>(column)),
                         static_cast<std::uint16_t>(3 * (index / ACROSS)), 0};
            part.size = {2, 2, 1};
            part.color = colors[index].color;
        }
    const osg::ref_ptr<const BrickModel> model = BrickModel::createOfParts(grid, parts);
    BuildingStep earlier;
    BuildingStep added;
    for (std::uint32_t part = 0; part < model->getParts().size(); ++part)
        (model->getParts()[part].cell[0] % 5 == 0 ? earlier : added).parts.push_back(part);
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->setStoredBricks(model);
    lego->setBuildingPlan(BuildingPlan::create(model->getParts().size(), {earlier, added}));
    lego->setNumNewParts(added.parts.size());
    return occlusionOf(lego);
}

constexpr float CAR_LENGTH = 4.35f; // from the nose to the pipes' ends

/** A box of the car's colour that fills one brick. */
osg::ref_ptr<osg::Node> createOneBrick(const osg::Vec3& middle, float size)
{
    return createBox(middle, osg::Vec3(size, size, size), osg::Vec4(0.80f, 0.10f, 0.11f, 1.0f));
}

/** The car with a brick of the same colour on its nose. @param cells the brick's offset. */
osg::ref_ptr<osg::Node> createOneStud(int cells)
{
    constexpr float CELL = CAR_LENGTH / RESOLUTION;
    const osg::Vec3 place(-1.35f + CELL * static_cast<float>(cells), 0.0f, 0.71f);
    return occlusionOf(createLego(groupOf(createRacingCar(), createOneBrick(place, 0.02f))));
}

/** The car in 128 cells, with two bricks of the same colour on its flank. */
osg::ref_ptr<osg::Node> createFewBricks()
{
    constexpr unsigned int FINE_RESOLUTION = 128;
    constexpr float CELL = CAR_LENGTH / FINE_RESOLUTION;
    const osg::ref_ptr<osg::Group> source = groupOf(createRacingCar());
    for (const float cells : {0.0f, 3.0f})
        source->addChild(createOneBrick(osg::Vec3(-0.705f + CELL * cells, -0.205f, 0.663f), 0.005f));
    return occlusionOf(createLego(source, FINE_RESOLUTION));
}

} // namespace

osg::ref_ptr<osg::Node> createLibraryScene(const std::string& name)
{
    static const std::map<std::string, osg::ref_ptr<osg::Node> (*)()> scenes{
        {"embedded", createEmbedded},
        {"outside", createOutside},
        {"overlapping", createOverlapping},
        {"transparent", createTransparent},
        {"shadow", createShadow},
        {"lights", createLights},
        {"fog", createFog},
        {"clip", createClip},
        {"material", createMaterial},
        {"no-joints", createNoJoints},
        {"relief-image", createReliefImage},
        {"outlines", [] { return osg::ref_ptr<osg::Node>(occlusionOf(createPartsNode(1.5))); }},
        {"progress", [] { return createHalf(0); }},
        {"step", [] { return createHalf(9); }},
        {"step-colors", createStepInColors},
        {"few-bricks", createFewBricks},
        {"one-stud", [] { return createOneStud(0); }},
        {"one-stud-moved", [] { return createOneStud(1); }}};
    const auto found = scenes.find(name);
    return found == scenes.end() ? nullptr : found->second();
}

} // namespace osgLego::test
