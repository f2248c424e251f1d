#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/polygonization/BrickRanges.h>
#include <osgLego/polygonization/BrickSplats.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/store/BrickStore.h>

#include <osg/Drawable>
#include <osg/StateSet>
#include <osg/buffered_value>

namespace osgLego
{

/** Draws the bricks of a context, each a point that a geometry shader makes faces and a stud of (the paper, section
 * III-C, Algorithm 5), or, where a renderer in software is at work, a splat (BrickSplats).
 *
 * Tells the programs of BrickNodes, under which it is drawn, of the scene's lights and fog; with GL_LIGHTING off,
 * colours show as they are. Draws nothing in a context in which no bricks are made yet. Not an osg::Geometry, since the
 * optimizer merges those.
 */
class BrickDrawable : public osg::Drawable
{
public:
    /** @param geometryState what it is drawn under, its program that of the geometry shader.
     * @param splatState the same for splats, its program that of their shading.
     * @param splatStateByOneLight likewise, where the scene has one light. */
    BrickDrawable(BrickStore& store, Drawing drawing, osg::StateSet& geometryState, osg::StateSet& splatState,
                  osg::StateSet& splatStateByOneLight);

    osg::BoundingBox computeBoundingBox() const override;
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

    /** The bricks that accept() goes through; null when there are none. */
    osg::ref_ptr<const BrickModel> getModel() const;

    // For picking: what acceptBrickTriangles says.
    bool supports(const osg::PrimitiveFunctor&) const override { return true; }
    void accept(osg::PrimitiveFunctor& functor) const override;
    using osg::Drawable::accept;
    using osg::Drawable::supports;

    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const BrickDrawable*>(object) != nullptr;
    }
    const char* libraryName() const override { return "osgLego"; }
    const char* className() const override { return "BrickDrawable"; }

private:
    ~BrickDrawable() override = default;

    /** What each frame of a context uses again, so that it allocates no memory. */
    struct Workspace
    {
        osg::ref_ptr<osg::RefMatrix> cellsToEye;
        BrickRanges ranges;
    };

    void drawBricks(osg::State& state, const ContextBricks& bricks, Workspace& workspace) const;

    osg::ref_ptr<BrickStore> _store;
    Drawing _drawing;
    osg::ref_ptr<osg::StateSet> _geometryState;
    mutable osg::buffered_object<Workspace> _workspaces;
    BrickSplats _splats;
};

} // namespace osgLego
