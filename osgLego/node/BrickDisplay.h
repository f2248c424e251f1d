#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/polygonization/BrickNodes.h>
#include <osgLego/producer/BrickProducer.h>
#include <osgLego/store/BrickStore.h>

#include <array>
#include <mutex>

#include <osg/Geode>
#include <osg/State>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The look of the bricks of a store, and the nodes that draw them, which are created on first use.
 *
 * Every function may be called from any thread.
 */
class BrickDisplay
{
public:
    explicit BrickDisplay(BrickStore& store);

    void setLook(Look look, Drawing drawing);
    void setAppearance(const BrickAppearance& appearance);
    BrickAppearance getAppearance() const;
    void setLightProbe(const LightProbe& probe);
    osg::ref_ptr<const LightProbe> getLightProbe() const;

    /** Add the occlusion with which cull() draws the bricks. */
    void addOcclusion(osgUtil::CullVisitor& visitor, FrameNeeds& needs) const;
    /** Queue the bricks in the render stage that the visitor is filling. */
    void cull(osgUtil::CullVisitor& visitor);

    /** The node that represents the bricks for drawing, picking and bounds. */
    osg::ref_ptr<osg::Geode> getBrickNode() const { return &getNodes()->getFrameNode(); }

    /** Recompute the bounds of the nodes after those of the bricks have changed. Call it in the update traversal. */
    void dirtyBound();

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

private:
    osg::ref_ptr<const BrickNodes> getNodes() const;
    void dropNodes() { _nodes.fill(nullptr); }

    osg::ref_ptr<BrickStore> _store;
    mutable std::mutex _mutex;
    Look _look = Look::FULL;
    Drawing _drawing = Drawing::AUTO;
    BrickAppearance _appearance;
    osg::ref_ptr<const LightProbe> _lightProbe;
    /** For each kind of nodes (BrickNodes::Kind). */
    mutable std::array<osg::ref_ptr<const BrickNodes>, 4> _nodes;
};

} // namespace osgLego
