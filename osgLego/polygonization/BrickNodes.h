#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LightProbe.h>
#include <osgLego/polygonization/BrickDrawable.h>

#include <osg/Geode>
#include <osg/ref_ptr>

namespace osgLego
{

/** The ways to draw the bricks of a node: a drawable under the program and state of each.
 *
 * Immutable but for GL objects: another appearance is another object, so that frames that are being drawn keep theirs.
 */
class BrickNodes : public osg::Referenced
{
public:
    BrickNodes(BrickStore& store, Look look, Drawing drawing, const BrickAppearance& appearance,
               const LightProbe& probe);

    /** Draws into a frame as it is. */
    osg::Geode& getFrameNode() const { return *_frameNode; }
    /** Draws into the geometry buffer of an AmbientOcclusionScene. */
    osg::Geode& getBufferNode() const { return *_bufferNode; }

    /** Say that the bounds of the bricks have changed. */
    void dirtyBound() const;
    /** Compute the bounds of the nodes, which several threads would compute at once when they ask for them later. */
    void getBound() const;
    void resizeGLObjectBuffers(unsigned int maxSize) const;
    void releaseGLObjects(osg::State* state) const;

private:
    ~BrickNodes() override = default;

    osg::ref_ptr<osg::Geode> _frameNode;
    osg::ref_ptr<osg::Geode> _bufferNode;
};

} // namespace osgLego
