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

/** A state for each way to draw: by the geometry shader, and as splats. */
struct WayStates
{
    osg::ref_ptr<osg::StateSet> geometry = new osg::StateSet;
    osg::ref_ptr<osg::StateSet> splats = new osg::StateSet;

    /** @param fragments the file of the fragment shader that both share. */
    WayStates(const std::string& name, const char* fragments, const std::string& definitions = {})
    {
        const osg::ref_ptr<osg::Program> triangles =
            ShaderLibrary::createProgram(name, {"polygonization.vert", "polygonization.geom", fragments}, definitions);
        const osg::ref_ptr<osg::Program> shading =
            ShaderLibrary::createProgram(name, {"splat_shading.vert", fragments}, definitions + "#define SPLATS\n");
        geometry->setAttributeAndModes(triangles, OURS);
        splats->setAttributeAndModes(shading, OURS);
    }

    osg::ref_ptr<osg::Geode> createNode(BrickStore& store) const
    {
        osg::ref_ptr<osg::Geode> node = new osg::Geode;
        node->addDrawable(new BrickDrawable(store, *geometry, *splats));
        node->setStateSet(geometry);
        return node;
    }
};

} // namespace

BrickNodes::BrickNodes(BrickStore& store, Look look, const BrickAppearance& appearance, const LightProbe& probe)
{
    if (look == Look::PLAIN)
    {
        _frameNode = WayStates("polygonization", "polygonization.frag").createNode(store);
        _bufferNode = _frameNode;
        return;
    }
    const WayStates frame("polygonization_full", "polygonization_full.frag");
    const WayStates buffer("polygonization_full", "polygonization_full.frag", "#define GEOMETRY_BUFFER\n");
    const osg::ref_ptr<osg::Texture2D> relief = createReliefTexture(appearance);
    for (osg::StateSet* stateSet :
         {frame.geometry.get(), frame.splats.get(), buffer.geometry.get(), buffer.splats.get()})
        applyAppearance(appearance, *relief, *stateSet);
    for (osg::StateSet* stateSet : {frame.geometry.get(), frame.splats.get()})
        applyLightProbe(probe, *stateSet);
    // What is in the buffer is no colour.
    constexpr osg::StateAttribute::OverrideValue OFF =
        osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
    for (osg::StateSet* stateSet : {buffer.geometry.get(), buffer.splats.get()})
        for (const auto mode : {GL_BLEND, GL_ALPHA_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE_ARB, GL_COLOR_LOGIC_OP})
            stateSet->setMode(static_cast<osg::StateAttribute::GLMode>(mode), OFF);
    _frameNode = frame.createNode(store);
    _bufferNode = buffer.createNode(store);
}

void BrickNodes::dirtyBound() const
{
    for (const osg::ref_ptr<osg::Geode>& node : {_frameNode, _bufferNode})
        node->getDrawable(0)->dirtyBound();
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
