#include <osgLego/BrickNodes.h>

#include <osgLego/LightProbeState.h>
#include <osgLego/ReliefMap.h>
#include <osgLego/ShaderLibrary.h>

#include <osg/Texture2D>
#include <osg/Uniform>

namespace osgLego
{

namespace
{

constexpr unsigned int RELIEF_UNIT = 0;

// Protected, since no other program, as of a pass for shadows, can draw what the buffer holds.
constexpr osg::StateAttribute::OverrideValue OURS =
    osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;

osg::ref_ptr<osg::Geode> createNode(BrickDrawable& drawable, osg::Program& program)
{
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(&drawable);
    node->getOrCreateStateSet()->setAttributeAndModes(&program, OURS);
    return node;
}

void applyAppearance(const BrickAppearance& appearance, osg::Texture2D& relief, osg::StateSet& stateSet)
{
    stateSet.addUniform(new osg::Uniform("hasJoints", appearance.joints));
    stateSet.addUniform(new osg::Uniform("variation", static_cast<float>(appearance.variation)));
    stateSet.addUniform(new osg::Uniform("roughness", static_cast<float>(appearance.roughness)));
    stateSet.addUniform(new osg::Uniform("reliefHeight", static_cast<float>(appearance.reliefHeight)));
    stateSet.addUniform(new osg::Uniform("usesMaterial", appearance.materialSpecular));
    stateSet.addUniform(new osg::Uniform("reliefMap", static_cast<int>(RELIEF_UNIT)));
    stateSet.setTextureAttribute(RELIEF_UNIT, &relief, osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED);
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

osg::ref_ptr<osg::Program> createPlainProgram()
{
    return ShaderLibrary::createProgram("polygonization",
                                        {"polygonization.vert", "polygonization.geom", "polygonization.frag"});
}

osg::ref_ptr<osg::Program> createFullProgram(const char* definitions)
{
    return ShaderLibrary::createProgram(
        "polygonization_full", {"polygonization.vert", "polygonization.geom", "polygonization_full.frag"}, definitions);
}

} // namespace

BrickNodes::BrickNodes(BrickDrawable& drawable, Look look, const BrickAppearance& appearance, const LightProbe& probe)
{
    if (look == Look::PLAIN)
    {
        _frameNode = createNode(drawable, *createPlainProgram());
        _bufferNode = _frameNode;
        return;
    }
    _frameNode = createNode(drawable, *createFullProgram(""));
    _bufferNode = createNode(drawable, *createFullProgram("#define GEOMETRY_BUFFER\n"));
    // What is in the buffer is no colour.
    constexpr osg::StateAttribute::OverrideValue OFF =
        osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
    for (const auto mode : {GL_BLEND, GL_ALPHA_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE_ARB, GL_COLOR_LOGIC_OP})
        _bufferNode->getStateSet()->setMode(static_cast<osg::StateAttribute::GLMode>(mode), OFF);
    const osg::ref_ptr<osg::Texture2D> relief = createReliefTexture(appearance);
    for (const osg::ref_ptr<osg::Geode>& node : {_frameNode, _bufferNode})
        applyAppearance(appearance, *relief, *node->getStateSet());
    applyLightProbe(probe, *_frameNode->getStateSet());
}

void BrickNodes::getBound() const
{
    _frameNode->getBound();
    _bufferNode->getBound();
}

void BrickNodes::resizeGLObjectBuffers(unsigned int maxSize) const
{
    _frameNode->resizeGLObjectBuffers(maxSize);
    _bufferNode->resizeGLObjectBuffers(maxSize);
}

void BrickNodes::releaseGLObjects(osg::State* state) const
{
    _frameNode->releaseGLObjects(state);
    _bufferNode->releaseGLObjects(state);
}

} // namespace osgLego
