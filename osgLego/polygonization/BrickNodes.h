#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/polygonization/BrickDrawable.h>

#include <osg/Geode>
#include <osg/ref_ptr>

namespace osgLego
{

/** The nodes that draw the bricks of a LegoNode, each with its own program and state.
 *
 * Immutable except for GL objects: a new appearance gets a new object, so that frames in progress keep theirs.
 */
class BrickNodes : public osg::Referenced
{
public:
    /** Programs differ in these properties. */
    struct Kind
    {
        bool isPartial = false; //!< whether the model is drawn partly built (BrickStore::getBuilding())
        bool hasLines = false;  //!< whether lines are drawn at the edges of parts, or parts are faded
    };

    BrickNodes(BrickStore& store, Look look, Drawing drawing, const BrickAppearance& appearance,
               const LightProbe& probe, const Kind& kind);

    /** Draws into a frame without AmbientOcclusionScene. */
    osg::Geode& getFrameNode() const { return *_frameNode; }
    /** Draws into the geometry buffer of an AmbientOcclusionScene.
     * @param distant whether the buffer includes distant occlusion. */
    osg::Geode& getBufferNode(bool distant) const { return distant ? *_distantNode : *_bufferNode; }

    /** Mark the bounds as changed. */
    void dirtyBound() const;
    /** Compute the bounds of the nodes now, so that several threads don't compute them at the same time later. */
    void getBound() const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~BrickNodes() override = default;

    osg::ref_ptr<osg::Geode> _frameNode;
    osg::ref_ptr<osg::Geode> _bufferNode;
    osg::ref_ptr<osg::Geode> _distantNode;
};

} // namespace osgLego
