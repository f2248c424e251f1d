#include <osgLego/polygonization/BrickNodes.h>

#include <osgLego/polygonization/BrickStates.h>

#include <atomic>

namespace osgLego
{

namespace
{

// Of bricks that nothing in the picture occludes (geometry_buffer.glsl).
constexpr int ALONE = 255;

/** A number that few other nodes have. */
int createOccluder()
{
    static std::atomic<unsigned int> numOccluders{0};
    return 1 + static_cast<int>(numOccluders++ % (ALONE - 1));
}

osg::ref_ptr<osg::Geode> createNode(const BrickDrawable::Options& options, const BrickStates& states)
{
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(new BrickDrawable(options, states));
    node->setStateSet(&states.getTriangles());
    return node;
}

const BrickDrawable& getDrawable(const osg::Geode& node)
{
    return static_cast<const BrickDrawable&>(*node.getDrawable(0));
}

} // namespace

BrickNodes::BrickNodes(BrickStore& store, Look look, Drawing drawing, const BrickAppearance& appearance,
                       const LightProbe& probe, const Kind& kind)
{
    const BrickOcclusion occlusion = look == Look::PLAIN ? BrickOcclusion::OFF : appearance.occlusion;
    const bool hasGrid = occlusion == BrickOcclusion::GRID || occlusion == BrickOcclusion::BOTH;
    const auto create = [&](BrickStates::Target target, bool isDistant)
    {
        BrickStates::Kind states{target, kind.isPartial, kind.hasLines};
        states.hasGridOcclusion = hasGrid;
        states.hasDistantOcclusion = isDistant;
        states.hasOwnOcclusion = target == BrickStates::Target::BUFFER && occlusion != BrickOcclusion::SCREEN;
        BrickDrawable::Options options{&store, drawing, kind.isPartial, appearance.outline};
        options.hasGridOcclusion = states.hasGridOcclusion;
        options.hasDistantOcclusion = states.hasDistantOcclusion;
        if (states.hasOwnOcclusion) options.occluder = occlusion == BrickOcclusion::BOTH ? createOccluder() : ALONE;
        return createNode(options, *BrickStates::get(look, states, appearance, probe));
    };
    const bool hasDistant = hasGrid && appearance.distantOcclusion;
    _frameNode = create(BrickStates::Target::FRAME, hasDistant);
    if (look == Look::PLAIN)
    {
        _bufferNode = _distantNode = _frameNode;
        return;
    }
    _bufferNode = create(BrickStates::Target::BUFFER, false);
    _distantNode = create(BrickStates::Target::BUFFER, hasDistant || occlusion == BrickOcclusion::SCREEN);
}

void BrickNodes::cull(osg::Geode& node, osgUtil::CullVisitor& visitor)
{
    getDrawable(node).useIn(visitor.getState()->getContextID());
    node.accept(visitor);
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
    for (const osg::ref_ptr<osg::Geode>& node : {_frameNode, _bufferNode, _distantNode})
        getDrawable(*node).releaseGLObjects(state);
}

} // namespace osgLego
