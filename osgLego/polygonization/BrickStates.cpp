#include <osgLego/polygonization/BrickStates.h>

#include <osgLego/data/SharedObjects.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/SharedBetweenViewers.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/light/LightProbeState.h>
#include <osgLego/polygonization/DistantOcclusionView.h>
#include <osgLego/polygonization/GridOcclusionView.h>
#include <osgLego/polygonization/ReliefMap.h>

#include <utility>

#include <osg/Depth>
#include <osg/Texture2D>
#include <osg/Uniform>

namespace osgLego
{

namespace
{

constexpr unsigned int RELIEF_UNIT = 0;

// Protected, since no other program, such as that of a shadow pass, can draw bricks from their buffer.
constexpr osg::StateAttribute::OverrideValue PROGRAM = osg::StateAttribute::ON | OVERRIDE_PROTECTED;

constexpr const char* CLIP_PLANES = "#define CLIP_PLANES\n";

/** The names of a look's programs and fragment shader. */
struct LookNames
{
    explicit LookNames(Look look) :
        pass(look == Look::PLAIN ? "polygonization" : "polygonization_full"),
        fragments(look == Look::PLAIN ? "polygonization/polygonization.frag"
                                      : "polygonization/polygonization_full.frag")
    {
    }

    const char* pass;
    const char* fragments;
};

osg::ref_ptr<osg::Texture2D> createReliefTexture(const osg::Image* image)
{
    const osg::ref_ptr<osg::Image> map = createReliefMap(image);
    // Prevents OSG from dropping the map once it is loaded, since other contexts may need it later.
    map->setDataVariance(osg::Object::DYNAMIC);
    osg::ref_ptr<SharedBetweenViewers<osg::Texture2D>> texture = new SharedBetweenViewers<osg::Texture2D>(map);
    texture->setInternalFormat(GL_RGBA16F_ARB);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->reserveContexts();
    return texture;
}

/** The texture of a relief, which looks with the same image share. */
osg::ref_ptr<osg::Texture2D> getReliefTexture(const osg::Image* image)
{
    static SharedObjects<std::pair<osg::observer_ptr<const osg::Image>, unsigned int>, osg::Texture2D> textures;
    return textures.findOrCreate({image, image ? image->getModifiedCount() : 0},
                                 [image] { return createReliefTexture(image); });
}

void applyAppearance(const BrickAppearance& appearance, osg::StateSet& stateSet)
{
    stateSet.addUniform(new osg::Uniform("variation", static_cast<float>(appearance.variation)));
    stateSet.addUniform(new osg::Uniform("roughness", static_cast<float>(appearance.roughness)));
    stateSet.addUniform(new osg::Uniform("reliefHeight", static_cast<float>(appearance.reliefHeight)));
    stateSet.addUniform(new osg::Uniform("usesMaterial", appearance.materialSpecular));
    stateSet.addUniform(new osg::Uniform("reliefMap", static_cast<int>(RELIEF_UNIT)));
    stateSet.setTextureAttribute(RELIEF_UNIT, getReliefTexture(appearance.reliefImage), OVERRIDE_PROTECTED);
}

/** Prepare for a geometry buffer: it does not contain colours, so they must not be blended. */
void applyBufferModes(osg::StateSet& stateSet)
{
    constexpr osg::StateAttribute::OverrideValue OFF = osg::StateAttribute::OFF | OVERRIDE_PROTECTED;
    for (const auto mode : {GL_BLEND, GL_ALPHA_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE_ARB, GL_COLOR_LOGIC_OP})
        stateSet.setMode(static_cast<osg::StateAttribute::GLMode>(mode), OFF);
}

std::string define(Look look, const BrickStates::Kind& kind, const BrickAppearance& appearance, const LightProbe& probe)
{
    std::string definitions;
    if (kind.isPartial) definitions += "#define PARTIAL\n";
    if (kind.hasLines) definitions += "#define LINES\n";
    if (look == Look::PLAIN) return definitions;
    // Software renderers would compute both branches of a condition.
    if (appearance.joints) definitions += "#define JOINTS\n";
    if (appearance.reliefHeight > 0.0) definitions += "#define RELIEF\n";
    if (kind.hasGridOcclusion) definitions += "#define GRID_OCCLUSION\n";
    if (kind.hasOwnOcclusion) definitions += "#define OWN_OCCLUSION\n";
    if (kind.hasDistantOcclusion) definitions += "#define DISTANT_OCCLUSION\n";
    if (kind.target == BrickStates::Target::FRAME) return definitions + defineLightProbe(probe);
    return definitions + "#define GEOMETRY_BUFFER\n";
}

osg::ref_ptr<osg::Program> getTriangleProgram(Look look, const std::string& definitions)
{
    const LookNames names(look);
    return ShaderLibrary::getProgram(
        names.pass, {"polygonization/polygonization.vert", "polygonization/polygonization.geom", names.fragments},
        definitions);
}

/** Create the state that all programs for shading have in common. */
osg::ref_ptr<osg::StateSet> createCommonState(Look look, const BrickStates::Kind& kind,
                                              const BrickAppearance& appearance, const LightProbe& probe)
{
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    if (look == Look::PLAIN) return stateSet;
    applyAppearance(appearance, *stateSet);
    if (kind.target == BrickStates::Target::FRAME)
        applyLightProbe(probe, *stateSet);
    else
        applyBufferModes(*stateSet);
    if (kind.hasGridOcclusion)
    {
        stateSet->addUniform(new osg::Uniform("neighbors", static_cast<int>(GridOcclusionView::NEIGHBORS_UNIT)));
        stateSet->addUniform(new osg::Uniform("occlusionTable", static_cast<int>(GridOcclusionView::TABLE_UNIT)));
        stateSet->addUniform(new osg::Uniform("studTable", static_cast<int>(GridOcclusionView::STUDS_UNIT)));
    }
    if (!kind.hasDistantOcclusion) return stateSet;
    stateSet->addUniform(new osg::Uniform("hiddenMean", static_cast<int>(DistantOcclusionView::MEAN_UNIT)));
    stateSet->addUniform(new osg::Uniform("hiddenBend", static_cast<int>(DistantOcclusionView::BEND_UNIT)));
    return stateSet;
}

/** Create the state for shading with a program. */
osg::ref_ptr<osg::StateSet> createShadingState(const osg::StateSet& common, osg::Program& program)
{
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet(common, osg::CopyOp::SHALLOW_COPY);
    stateSet->setAttributeAndModes(&program, PROGRAM);
    return stateSet;
}

osg::ref_ptr<osg::StateSet> createSplatState(const osg::StateSet& common, Look look, const std::string& definitions)
{
    const LookNames names(look);
    osg::ref_ptr<osg::StateSet> stateSet = createShadingState(
        common,
        *ShaderLibrary::getProgram(names.pass, {"polygonization/splat_shading.vert", names.fragments}, definitions));
    setPointModes(*stateSet);
    stateSet->addUniform(new osg::Uniform("splats", static_cast<int>(BrickStates::SPLATS_UNIT)));
    stateSet->addUniform(new osg::Uniform("splatDepths", static_cast<int>(BrickStates::DEPTHS_UNIT)));
    stateSet->addUniform(new osg::Uniform("splatBricks", static_cast<int>(BrickStates::BRICKS_UNIT)));
    return stateSet;
}

BrickStates::Shading createShading(const osg::StateSet& common, Look look, const std::string& definitions)
{
    const std::string splats = definitions + "#define SPLATS\n";
    return {createShadingState(common, *getTriangleProgram(look, definitions)), createSplatState(common, look, splats),
            createSplatState(common, look, splats + "#define ONE_LIGHT\n")};
}

osg::ref_ptr<osg::StateSet> createDepthState(const std::string& definitions)
{
    const osg::ref_ptr<osg::Program> program = ShaderLibrary::getProgram(
        "polygonization_depth",
        {"polygonization/polygonization.vert", "polygonization/polygonization.geom", "polygonization/depth.frag"},
        definitions);
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(program, PROGRAM);
    return stateSet;
}

osg::ref_ptr<osg::StateSet> createPartialNeighborsState()
{
    const osg::ref_ptr<osg::Program> program =
        ShaderLibrary::getProgram("partial neighbours", {"polygonization/partial_neighbors.vert"}, {}, {"neighbors"});
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(program, PROGRAM);
    return stateSet;
}

osg::ref_ptr<osg::Program> getPointProgram(const std::string& definitions)
{
    return ShaderLibrary::getProgram("splats", {"polygonization/splats.vert", "polygonization/splats.frag"},
                                     definitions);
}

/** Create the state for points that are drawn with the depth test of the scene. */
osg::ref_ptr<osg::StateSet> createDepthPointState(const std::string& definitions)
{
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(getPointProgram(definitions), PROGRAM);
    setPointModes(*stateSet);
    return stateSet;
}

osg::ref_ptr<osg::StateSet> createPointState(const std::string& definitions)
{
    const osg::ref_ptr<osg::Program> program = getPointProgram(definitions);
    osg::ref_ptr<osg::StateSet> stateSet = createPassState(*program);
    stateSet->setAttributeAndModes(new osg::Depth(osg::Depth::LESS), osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    setPointModes(*stateSet);
    return stateSet;
}

} // namespace

BrickStates::Key::Key(Look ofLook, const Kind& ofKind, const BrickAppearance& ofAppearance, const LightProbe& probe) :
    look(ofLook), kind(ofKind)
{
    if (look == Look::PLAIN)
    {
        kind.target = Target::FRAME;
        kind.hasGridOcclusion = false;
        kind.hasDistantOcclusion = false;
        kind.hasOwnOcclusion = false;
        return;
    }
    appearance = ofAppearance;
    // Properties of each node.
    appearance.outline = 0.0;
    appearance.occlusion = BrickOcclusion::BOTH;
    appearance.distantOcclusion = true;
    const osg::ref_ptr<const osg::Image> image = std::exchange(appearance.reliefImage, nullptr);
    relief = image;
    reliefCount = image ? image->getModifiedCount() : 0;
    if (kind.target != Target::FRAME) return;
    light = probe.getConvolvedMap();
    rotation = probe.getRotation();
    intensity = probe.getIntensity();
}

osg::ref_ptr<const BrickStates> BrickStates::get(Look look, const Kind& kind, const BrickAppearance& appearance,
                                                 const LightProbe& probe)
{
    static SharedObjects<Key, const BrickStates> states;
    return states.findOrCreate(Key(look, kind, appearance, probe),
                               [&] { return new BrickStates(look, kind, appearance, probe); });
}

BrickStates::BrickStates(Look look, const Kind& kind, const BrickAppearance& appearance, const LightProbe& probe) :
    _look(look), _definitions(define(look, kind, appearance, probe)),
    _common(createCommonState(look, kind, appearance, probe)), _shading(createShading(*_common, look, _definitions))
{
    const std::string partial = kind.isPartial ? "#define PARTIAL\n" : "";
    _boxes = createPointState(partial);
    _studded = createPointState("#define STUDS\n" + partial);
    if (kind.isPartial && kind.hasGridOcclusion) _partialNeighbors = createPartialNeighborsState();
    const std::string depths = "#define DEPTH_ONLY\n" + partial;
    _depths = createDepthState(depths);
    _clippedDepths = createDepthState(depths + CLIP_PLANES);
    for (std::size_t isBack : {0, 1})
        for (std::size_t hasStuds : {0, 1})
            _depthPoints[isBack][hasStuds] = createDepthPointState(depths + (isBack ? "#define BACK_FACES\n" : "") +
                                                                   (hasStuds ? "#define STUDS\n" : ""));
}

BrickStates::Shading BrickStates::getShading(bool hasShadows) const
{
    if (!hasShadows) return _shading;
    const std::lock_guard lock(_mutex);
    if (!_shadowed.triangles) _shadowed = createShading(*_common, _look, _definitions + "#define SHADOWS\n");
    return _shadowed;
}

const osg::StateSet& BrickStates::getClippedTriangles(bool hasShadows) const
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<osg::StateSet>& stateSet = _clipped[hasShadows ? 1 : 0];
    const std::string definitions = _definitions + CLIP_PLANES + (hasShadows ? "#define SHADOWS\n" : "");
    if (!stateSet) stateSet = createShadingState(*_common, *getTriangleProgram(_look, definitions));
    return *stateSet;
}

void BrickStates::resizeGLObjectBuffers(unsigned int maxSize) const
{
    const std::lock_guard lock(_mutex);
    for (const osg::ref_ptr<osg::StateSet>& stateSet :
         {_boxes, _studded, _depths, _clippedDepths, _clipped[0], _clipped[1], _depthPoints[0][0], _depthPoints[0][1],
          _depthPoints[1][0], _depthPoints[1][1], _shading.triangles, _shading.splats, _shading.splatsByOneLight,
          _shadowed.triangles, _shadowed.splats, _shadowed.splatsByOneLight, _partialNeighbors})
        if (stateSet) stateSet->resizeGLObjectBuffers(maxSize);
}

} // namespace osgLego
