#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/polygonization/BrickDrawable.h>

#include <osg/Geode>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The nodes that draw the bricks of a LegoNode, each in the states for its target (BrickStates).
 *
 * Immutable except for GL objects: a new appearance gets a new object, so that frames in progress keep theirs.
 */
class BrickNodes : public osg::Referenced
{
public:
    /** The properties in which the nodes for one look differ; see BrickStates::Kind. */
    struct Kind
    {
        bool isPartial = false; //!< whether the model is drawn partly built (BrickStore::getBuilding())
        bool hasLines = false;  //!< whether lines are drawn at the edges of parts, or parts are faded
    };

    BrickNodes(BrickStore& store, Look look, Drawing drawing, const BrickAppearance& appearance,
               const LightProbe& probe, const Kind& kind);

    osg::Geode& getFrameNode() const { return *_frameNode; }
    /** Cull the node that draws into a frame without AmbientOcclusionScene. */
    void cullForFrame(osgUtil::CullVisitor& visitor) const { cull(*_frameNode, visitor); }
    /** Cull the node that draws into the geometry buffer of an AmbientOcclusionScene.
     * @param distant whether distant bricks may occlude. */
    void cullForBuffer(bool distant, osgUtil::CullVisitor& visitor) const
    {
        cull(distant ? *_distantNode : *_bufferNode, visitor);
    }

    /** Mark the bounds as changed. */
    void dirtyBound() const;
    /** Compute the bounds of the nodes now, so that several threads don't compute them at the same time later. */
    void getBound() const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~BrickNodes() override = default;

    static void cull(osg::Geode& node, osgUtil::CullVisitor& visitor);

    osg::ref_ptr<osg::Geode> _frameNode;
    osg::ref_ptr<osg::Geode> _bufferNode;
    osg::ref_ptr<osg::Geode> _distantNode;
};

} // namespace osgLego
