#include <osgLego/polygonization/BrickNodes.h>

#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/light/LightProbeState.h>
#include <osgLego/polygonization/DistantOcclusionView.h>
#include <osgLego/polygonization/ReliefMap.h>

#include <osg/Texture2D>
#include <osg/Uniform>

namespace osgLego
{

namespace
{

constexpr unsigned int RELIEF_UNIT = 0;

// Protected, since no other program, such as that of a shadow pass, can draw bricks from their buffer.
constexpr osg::StateAttribute::OverrideValue PROGRAM = osg::StateAttribute::ON | OVERRIDE_PROTECTED;

void applyAppearance(const BrickAppearance& appearance, osg::Texture2D& relief, osg::StateSet& stateSet)
{
    stateSet.addUniform(new osg::Uniform("hasJoints", appearance.joints));
    stateSet.addUniform(new osg::Uniform("variation", static_cast<float>(appearance.variation)));
    stateSet.addUniform(new osg::Uniform("roughness", static_cast<float>(appearance.roughness)));
    stateSet.addUniform(new osg::Uniform("reliefHeight", static_cast<float>(appearance.reliefHeight)));
    stateSet.addUniform(new osg::Uniform("usesMaterial", appearance.materialSpecular));
    stateSet.addUniform(new osg::Uniform("reliefMap", static_cast<int>(RELIEF_UNIT)));
    stateSet.setTextureAttribute(RELIEF_UNIT, &relief, OVERRIDE_PROTECTED);
}

osg::ref_ptr<osg::Texture2D> createReliefTexture(const BrickAppearance& appearance)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(createReliefMap(appearance.reliefImage));
    texture->setInternalFormat(GL_RGBA16F_ARB);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

osg::ref_ptr<osg::StateSet> createState(const std::string& name, const char* fragments, const std::string& definitions)
{
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(
        ShaderLibrary::createProgram(
            name, {"polygonization/polygonization.vert", "polygonization/polygonization.geom", fragments}, definitions),
        PROGRAM);
    return stateSet;
}

/** Create the state for shading splats, which differs from the state for triangles in its program. */
osg::ref_ptr<osg::StateSet> createSplatState(const osg::StateSet& triangles, const std::string& name,
                                             const char* fragments, const std::string& definitions)
{
    osg::ref_ptr<osg::StateSet> splats = new osg::StateSet(triangles, osg::CopyOp::SHALLOW_COPY);
    splats->setAttributeAndModes(
        ShaderLibrary::createProgram(name, {"polygonization/splat_shading.vert", fragments}, definitions), PROGRAM);
    return splats;
}

/** Create a node with the given state for triangles. */
osg::ref_ptr<osg::Geode> createNode(const BrickDrawable::Options& options, osg::StateSet& triangles,
                                    const std::string& name, const char* fragments, const std::string& definitions)
{
    constexpr const char* SPLATS = "#define SPLATS\n";
    constexpr const char* ONE_LIGHT = "#define ONE_LIGHT\n";
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(
        new BrickDrawable(options, triangles, *createSplatState(triangles, name, fragments, definitions + SPLATS),
                          *createSplatState(triangles, name, fragments, definitions + SPLATS + ONE_LIGHT)));
    node->setStateSet(&triangles);
    return node;
}

} // namespace

BrickNodes::BrickNodes(BrickStore& store, Look look, Drawing drawing, const BrickAppearance& appearance,
                       const LightProbe& probe, const Kind& kind)
{
    BrickDrawable::Options options{&store, drawing, kind.isPartial, appearance.outline};
    const std::string definitions =
        std::string(kind.isPartial ? "#define PARTIAL\n" : "") + (kind.hasLines ? "#define LINES\n" : "");
    if (look == Look::PLAIN)
    {
        constexpr const char* NAME = "polygonization";
        constexpr const char* FRAGMENTS = "polygonization/polygonization.frag";
        _frameNode = createNode(options, *createState(NAME, FRAGMENTS, definitions), NAME, FRAGMENTS, definitions);
        _bufferNode = _frameNode;
        _distantNode = _frameNode;
        return;
    }
    constexpr const char* NAME = "polygonization_full";
    constexpr const char* FRAGMENTS = "polygonization/polygonization_full.frag";
    const std::string forFrame = definitions + defineLightProbe(probe);
    const std::string forBuffer = definitions + "#define GEOMETRY_BUFFER\n";
    const std::string withDistant = forBuffer + "#define DISTANT_OCCLUSION\n";
    const osg::ref_ptr<osg::StateSet> frame = createState(NAME, FRAGMENTS, forFrame);
    const osg::ref_ptr<osg::StateSet> buffer = createState(NAME, FRAGMENTS, forBuffer);
    const osg::ref_ptr<osg::StateSet> distant = createState(NAME, FRAGMENTS, withDistant);
    const osg::ref_ptr<osg::Texture2D> relief = createReliefTexture(appearance);
    for (const osg::ref_ptr<osg::StateSet>& stateSet : {frame, buffer, distant})
        applyAppearance(appearance, *relief, *stateSet);
    applyLightProbe(probe, *frame);
    // The buffer does not contain colours, so they must not be blended.
    constexpr osg::StateAttribute::OverrideValue OFF = osg::StateAttribute::OFF | OVERRIDE_PROTECTED;
    for (const auto mode : {GL_BLEND, GL_ALPHA_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE_ARB, GL_COLOR_LOGIC_OP})
        for (const osg::ref_ptr<osg::StateSet>& stateSet : {buffer, distant})
            stateSet->setMode(static_cast<osg::StateAttribute::GLMode>(mode), OFF);
    distant->addUniform(new osg::Uniform("hiddenFromLower", static_cast<int>(DistantOcclusionView::LOWER_UNIT)));
    distant->addUniform(new osg::Uniform("hiddenFromUpper", static_cast<int>(DistantOcclusionView::UPPER_UNIT)));
    _frameNode = createNode(options, *frame, NAME, FRAGMENTS, forFrame);
    _bufferNode = createNode(options, *buffer, NAME, FRAGMENTS, forBuffer);
    options.hasDistantOcclusion = true;
    _distantNode = createNode(options, *distant, NAME, FRAGMENTS, withDistant);
}

void BrickNodes::dirtyBound() const
{
    for (const osg::ref_ptr<osg::Geode>& node : {_frameNode, _bufferNode, _distantNode})
        node->getDrawable(0)->dirtyBound();
}

void BrickNodes::getBound() const
{
    _frameNode->getBound();
    _bufferNode->getBound();
    _distantNode->getBound();
}

void BrickNodes::resizeGLObjectBuffers(unsigned int maxSize) const
{
    _frameNode->resizeGLObjectBuffers(maxSize);
    _bufferNode->resizeGLObjectBuffers(maxSize);
    _distantNode->resizeGLObjectBuffers(maxSize);
}

void BrickNodes::releaseGLObjects(osg::State* state) const
{
    _frameNode->releaseGLObjects(state);
    _bufferNode->releaseGLObjects(state);
    _distantNode->releaseGLObjects(state);
}

} // namespace osgLego
