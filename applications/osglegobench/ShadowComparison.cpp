#include "ShadowComparison.h"

#include "Spread.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>
#include <osg/LightSource>
#include <osg/NodeCallback>
#include <osg/Switch>
#include <osgShadow/LightSpacePerspectiveShadowMap>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>
#include <osgShadow/SoftShadowMap>
#include <osgShadow/StandardShadowMap>
#include <osgShadow/ViewDependentShadowMap>
#include <osgUtil/CullVisitor>

namespace osgLego
{

namespace
{

struct TechniqueEntry
{
    const char* name;
    osg::ref_ptr<osgShadow::ShadowTechnique> (*create)();
};

template <typename Technique>
osg::ref_ptr<osgShadow::ShadowTechnique> createTechnique()
{
    return new Technique;
}

constexpr std::array TECHNIQUES{
    TechniqueEntry{"ShadowMap", createTechnique<osgShadow::ShadowMap>},
    TechniqueEntry{"SoftShadowMap", createTechnique<osgShadow::SoftShadowMap>},
    TechniqueEntry{"StandardShadowMap", createTechnique<osgShadow::StandardShadowMap>},
    TechniqueEntry{"LightSpacePerspectiveShadowMapVB", createTechnique<osgShadow::LightSpacePerspectiveShadowMapVB>},
    TechniqueEntry{"LightSpacePerspectiveShadowMapCB", createTechnique<osgShadow::LightSpacePerspectiveShadowMapCB>},
    TechniqueEntry{"LightSpacePerspectiveShadowMapDB", createTechnique<osgShadow::LightSpacePerspectiveShadowMapDB>},
    TechniqueEntry{"ViewDependentShadowMap", createTechnique<osgShadow::ViewDependentShadowMap>}};

osg::ref_ptr<osgShadow::ShadowTechnique> createTechniqueOfName(const std::string& name)
{
    const auto* const found = std::find_if(TECHNIQUES.begin(), TECHNIQUES.end(),
                                           [&](const TechniqueEntry& entry) { return entry.name == name; });
    if (found == TECHNIQUES.end()) throw std::runtime_error("there is no technique '" + name + "'");
    return found->create();
}

/** Gives each camera that culls a node into a shadow map a colour buffer without mask, which the map does not need. */
class ColorBufferCallback : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        auto* const cullVisitor = dynamic_cast<osgUtil::CullVisitor*>(visitor);
        osg::Camera* camera = cullVisitor ? cullVisitor->getCurrentCamera() : nullptr;
        if (camera && camera->getBufferAttachmentMap().count(osg::Camera::DEPTH_BUFFER) > 0 &&
            camera->getBufferAttachmentMap().count(osg::Camera::COLOR_BUFFER) == 0)
        {
            camera->attach(osg::Camera::COLOR_BUFFER, GL_RGBA);
            camera->getOrCreateStateSet()->removeAttribute(osg::StateAttribute::COLORMASK);
        }
        traverse(node, visitor);
    }
};

/** The scenes that are drawn in turns. */
enum Place : unsigned int
{
    UNSHADOWED,
    SHADOWED,
    SHADED, //!< with a colour buffer for the shadow map
    NUM_PLACES
};

/** A switch between the same node without and with shadows. */
osg::ref_ptr<osg::Switch> createSwitch(osg::Node& node, const std::string& technique)
{
    const osg::ref_ptr<osg::Switch> scenes = new osg::Switch;
    scenes->addChild(&node);
    for (const bool isShaded : {false, true})
    {
        const osg::ref_ptr<osgShadow::ShadowedScene> shadowed = new osgShadow::ShadowedScene;
        shadowed->setShadowTechnique(createTechniqueOfName(technique));
        const osg::ref_ptr<osg::Group> group = new osg::Group;
        if (isShaded) group->setCullCallback(new ColorBufferCallback);
        group->addChild(&node);
        shadowed->addChild(group);
        scenes->addChild(shadowed);
    }
    return scenes;
}

osg::ref_ptr<osg::LightSource> createSun(UpAxis upAxis)
{
    const osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition(upAxis == UpAxis::Y ? osg::Vec4(0.5f, 0.8f, 0.4f, 0.0f)
                                                     : osg::Vec4(0.5f, -0.4f, 0.8f, 0.0f));
    return sun;
}

double medianFrame(const JsonValue& row, const char* scene)
{
    return row[scene]["median"].toNumber();
}

} // namespace

std::vector<std::string> getShadowTechniques()
{
    std::vector<std::string> names(TECHNIQUES.size());
    std::transform(TECHNIQUES.begin(), TECHNIQUES.end(), names.begin(),
                   [](const TechniqueEntry& entry) { return entry.name; });
    return names;
}

JsonValue compareShadows(const BenchScene& scene, const ShadowOptions& options)
{
    constexpr unsigned int NUM_ROUNDS_BEFORE = 3; // some techniques need the previous frame
    FrameViewer viewer(options.size);
    const osg::ref_ptr<LegoNode> lego = scene.createLego();
    const osg::ref_ptr<osg::Switch> scenes = createSwitch(*lego, options.technique);
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(createSun(scene.settings.grid.upAxis));
    root->addChild(scenes);
    viewer.show(*root, scene);
    std::array<std::vector<double>, NUM_PLACES> times;
    for (unsigned int round = 0; round < NUM_ROUNDS_BEFORE + options.numFrames; ++round)
        for (unsigned int place = 0; place < NUM_PLACES; ++place)
        {
            scenes->setSingleChildOn(place);
            const double time = viewer.timeFrame();
            if (round >= NUM_ROUNDS_BEFORE) times[place].push_back(time);
        }
    checkBricks(*lego, viewer);
    checkPicture(*viewer.read());
    const JsonValue unshadowed = createSpread(times[UNSHADOWED]);
    const JsonValue shadowed = createSpread(times[SHADOWED]);
    const JsonValue shaded = createSpread(times[SHADED]);
    return {{"resolution", scene.settings.grid.resolution},
            {"drawnBricks", lego->getStatistics(viewer.getContextID()).numDrawnBricks},
            {"unshadowed", unshadowed},
            {"shadowed", shadowed},
            {"shaded", shaded},
            {"ratio", shadowed["median"].toNumber() / shaded["median"].toNumber()}};
}

void printShadows(const JsonValue& document)
{
    fmt::print(
        "{}, frames in ms (median):\n\n"
        "| cells | bricks | without shadows | with shadows | with a shaded shadow map | ratio of the last two |\n"
        "|---|---|---|---|---|---|\n",
        document["technique"].toText());
    for (const JsonValue& row : document["rows"].getElements())
        fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |\n", row["resolution"].toInteger(),
                   row["drawnBricks"].toInteger(), medianFrame(row, "unshadowed"), medianFrame(row, "shadowed"),
                   medianFrame(row, "shaded"), row["ratio"].toNumber());
}

} // namespace osgLego
