#include "SoakRun.h"

#include <common/RacingCar.h>
#include <osgLego/AmbientOcclusionScene.h>

#include <stdexcept>
#include <string>

#include <osg/Geode>
#include <osg/Image>
#include <osg/ShapeDrawable>

namespace osgLego
{

namespace
{

const std::array<const char*, 8> SOAK_SETTINGS{"12",
                                               "24",
                                               "16,parts=bricks,effort=instant",
                                               "20,dither=on,palette=ldraw",
                                               "12,look=plain",
                                               "16,fill=solid",
                                               "16,device=gpu",
                                               "12,proportions=plate"};
constexpr std::array<BrickOcclusion, 4> SOAK_OCCLUSIONS{BrickOcclusion::GRID, BrickOcclusion::OFF,
                                                        BrickOcclusion::SCREEN, BrickOcclusion::BOTH};
constexpr std::array<glm::ivec2, 4> SOAK_SIZES{glm::ivec2(320, 240), glm::ivec2(640, 360), glm::ivec2(200, 300),
                                               glm::ivec2(480, 480)};

osg::ref_ptr<osg::Node> createShape(osg::Shape* shape, const osg::Vec4& color)
{
    const osg::ref_ptr<osg::ShapeDrawable> drawable = new osg::ShapeDrawable(shape);
    drawable->setColor(color);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(drawable);
    return geode;
}

/** A light probe whose sky has a colour. */
osg::ref_ptr<osg::Image> createPicture(const osg::Vec3& color)
{
    constexpr int WIDTH = 32;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(WIDTH, WIDTH / 2, 1, GL_RGB, GL_FLOAT);
    for (int row = 0; row < WIDTH / 2; ++row)
        for (int column = 0; column < WIDTH; ++column)
            image->setColor(osg::Vec4(color * static_cast<float>(row), 1.0f), static_cast<unsigned int>(column),
                            static_cast<unsigned int>(row));
    return image;
}

} // namespace

SoakRun::SoakRun() : _scene(MeshSource(), 12), _root(new AmbientOcclusionScene)
{
    for (std::size_t place = 0; place < NUM_NODES; ++place)
        replaceNode(place);
    rest();
}

std::size_t SoakRun::choose(std::size_t count)
{
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(_random);
}

void SoakRun::change()
{
    switch (choose(6))
    {
    case 0:
        setSource(chooseNode(), choose(3));
        break;
    case 1:
        setSettings(chooseNode(), choose(SOAK_SETTINGS.size()));
        break;
    case 2:
        setProbe(chooseNode());
        break;
    case 3:
        setOcclusion(chooseNode(), choose(SOAK_OCCLUSIONS.size()));
        break;
    case 4:
        replaceNode(choose(NUM_NODES));
        break;
    default:
        reopen(choose(_viewers.size()), SOAK_SIZES[choose(SOAK_SIZES.size())]);
    }
    draw();
}

void SoakRun::rest()
{
    for (std::size_t place = 0; place < NUM_NODES; ++place)
    {
        setSource(*_nodes[place], place);
        setSettings(*_nodes[place], 0);
        setOcclusion(*_nodes[place], 0);
        _nodes[place]->setLightProbe(new LightProbe);
    }
    for (std::size_t viewer = 0; viewer < _viewers.size(); ++viewer)
        reopen(viewer, SOAK_SIZES[viewer]);
    draw();
}

void SoakRun::setSource(LegoNode& node, std::size_t source)
{
    const auto fraction = [this] { return 0.2f + 0.1f * static_cast<float>(choose(8)); };
    const osg::Vec4 color(fraction(), fraction(), fraction(), 1.0f);
    node.removeChildren(0, node.getNumChildren());
    node.addChild(source == 0   ? createRacingCar()
                  : source == 1 ? createShape(new osg::Sphere(osg::Vec3(), 2.0f), color)
                                : createShape(new osg::Box(osg::Vec3(), 3.0f, 2.0f, 1.0f), color));
}

void SoakRun::setSettings(LegoNode& node, std::size_t settings)
{
    LegoSettings parsed;
    std::string error;
    if (!LegoSettings::parse(SOAK_SETTINGS[settings], parsed, error)) throw std::runtime_error(error);
    node.setSettings(parsed);
}

void SoakRun::setProbe(LegoNode& node)
{
    const osg::ref_ptr<LightProbe> probe = new LightProbe;
    probe->setIntensity(0.5 + 0.25 * static_cast<double>(choose(4)));
    std::string error;
    const auto color = [this] { return static_cast<float>(1 + choose(4)); };
    if (choose(2) == 0) probe->setImage(createPicture({color(), color(), color()}), LightProbe::AUTO, error);
    if (!error.empty()) throw std::runtime_error(error);
    node.setLightProbe(probe);
}

void SoakRun::setOcclusion(LegoNode& node, std::size_t occlusion)
{
    BrickAppearance appearance = node.getAppearance();
    appearance.occlusion = SOAK_OCCLUSIONS[occlusion];
    node.setAppearance(appearance);
}

void SoakRun::replaceNode(std::size_t place)
{
    if (_nodes[place]) _root->removeChild(_nodes[place]);
    _nodes[place] = new LegoNode;
    _nodes[place]->setWaiting(true);
    setSettings(*_nodes[place], 0);
    setSource(*_nodes[place], place);
    _root->addChild(_nodes[place]);
}

void SoakRun::reopen(std::size_t viewer, const glm::ivec2& size)
{
    _viewers[viewer] = nullptr; // before the next one, so that it can have the same ID
    _viewers[viewer] = std::make_unique<FrameViewer>(size);
    _viewers[viewer]->show(*_root, _scene);
}

void SoakRun::draw()
{
    constexpr int NUM_FRAMES = 3;
    for (int frame = 0; frame < NUM_FRAMES; ++frame)
        for (const std::unique_ptr<FrameViewer>& viewer : _viewers)
        {
            viewer->getContext().makeCurrent(); // a viewer assumes that its context is, since it drew last
            viewer->drawFrame();
        }
}

} // namespace osgLego
