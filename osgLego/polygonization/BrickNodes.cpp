#include <osgLego/polygonization/BrickNodes.h>

#include <osgLego/polygonization/BrickStates.h>

namespace osgLego
{

namespace
{

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
    const auto create = [&](BrickStates::Target target)
    {
        BrickDrawable::Options options{&store, drawing, kind.isPartial, appearance.outline};
        BrickStates::Kind states{target, kind.isPartial, kind.hasLines};
        states.hasGridOcclusion =
            appearance.gridOcclusion && look == Look::FULL && target == BrickStates::Target::FRAME && !kind.isPartial;
        states.hasDistantOcclusion = states.hasGridOcclusion && appearance.distantOcclusion;
        options.hasGridOcclusion = states.hasGridOcclusion;
        options.hasDistantOcclusion =
            states.hasDistantOcclusion || (look == Look::FULL && target == BrickStates::Target::BUFFER_WITH_DISTANT);
        return createNode(options, *BrickStates::get(look, states, appearance, probe));
    };
    _frameNode = create(BrickStates::Target::FRAME);
    _bufferNode = look == Look::PLAIN ? _frameNode : create(BrickStates::Target::BUFFER);
    _distantNode = look == Look::PLAIN ? _frameNode : create(BrickStates::Target::BUFFER_WITH_DISTANT);
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
