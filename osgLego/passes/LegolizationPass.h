#pragma once

#include <osgLego/gl/PassCamera.h>
#include <osgLego/passes/PassPlan.h>
#include <osgLego/passes/PassWorkspace.h>

#include <string>

#include <osg/Drawable>
#include <osg/ref_ptr>

namespace osgLego
{

/** A pass of the legolization: a drawable that does its part of the work when it is drawn, and then only if it is its
 * turn.
 *
 * The passes of a source are numbered; the first starts a legolization if the context has no bricks of the wanted
 * source, each of the others goes on where the one before stopped, and the last finishes. A pass drawn a second time in
 * a frame, or in a frame that needs no work, does nothing.
 *
 * Preconditions:
 * 1. Drawn through its own camera, in the order of the numbers, all in one context and one frame.
 * 2. GL objects that only this pass needs do not outlive its run.
 */
class LegolizationPass : public osg::Drawable
{
public:
    /** The camera that draws this pass; give it to a cull visitor. */
    PassCamera& getCamera() const { return *_camera; }

    osg::BoundingBox computeBoundingBox() const override { return {}; }
    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    void releaseGLObjects(osg::State* state = nullptr) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

    osg::Object* cloneType() const override { return nullptr; }
    osg::Object* clone(const osg::CopyOp&) const override { return nullptr; }
    const char* libraryName() const override { return "osgLego"; }

protected:
    LegolizationPass(PassWorkspace& workspace, unsigned int step);
    ~LegolizationPass() override = default;

    void setCamera(PassCamera* camera) { _camera = camera; }
    /** Start the legolization of the wanted source, unless the context has its bricks, or can't have them, or another
     * context is at work on them. For begin() of a first pass. */
    bool start(osg::State& state, PassContext& context, const PassPlan& plan) const;

    /** Bind the texture of a batch, and say how it joins the colours, for shaders/passes/surface_color.glsl. For run().
     */
    void bindSurfaceOf(osg::State& state, const GridBatch& batch) const;

    /** Whether there is something to do; the first pass starts the legolization here. Called as run() is. */
    virtual bool begin(osg::State& state, PassContext& context) const;
    /** Do the work; the last pass says that it is complete. Called with the context current, its work locked and the
     * pass's own program applied. @return why it can't be done; empty when it was. */
    virtual std::string run(osg::State& state, Legolization& work) const = 0;
    /** Where the time it took is to be added. */
    virtual double& getTime(LegoStatistics& statistics) const = 0;

private:
    std::string runWithProgram(osg::State& state, Legolization& work) const;
    void deliver(const osg::State& state, Legolization& work) const;

    osg::ref_ptr<PassWorkspace> _workspace;
    unsigned int _step;
    osg::ref_ptr<PassCamera> _camera;
};

} // namespace osgLego
