#pragma once

#include <osgLego/gl/PassCamera.h>
#include <osgLego/passes/PassPlan.h>
#include <osgLego/passes/PassWorkspace.h>

#include <string>

#include <osg/Drawable>
#include <osg/ref_ptr>

namespace osgLego
{

/** A pass of the legolization: a drawable that does one step of the work when it is drawn in its turn.
 *
 * The passes of a source are numbered. The first one starts a legolization if the context lacks the bricks of the
 * wanted source, each of the others continues where the previous one stopped, and the last one completes it. A pass
 * that is drawn again in the same frame, or in a frame without work, does nothing.
 *
 * Preconditions:
 * 1. The passes are drawn through their own cameras, in the order of their numbers, all in one context and one frame.
 * 2. GL objects that only this pass needs do not outlive its run().
 */
class LegolizationPass : public osg::Drawable
{
public:
    /** The camera that draws this pass; have a cull visitor visit it. */
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

    const PassWorkspace& getWorkspace() const { return *_workspace; }
    void setCamera(PassCamera* camera) { _camera = camera; }
    /** Start the legolization of the wanted source, unless the context has its bricks or has failed to make them, or
     * another context is making them. For begin() of the first pass. @return whether it was started. */
    bool start(osg::State& state, PassContext& context, const PassPlan& plan) const;

    /** Bind the texture of a batch and set its environment, for shaders/passes/surface_color.glsl. For run(). */
    void bindSurfaceOf(osg::State& state, const GridBatch& batch) const;

    /** Bind the palette of a source, if it has one, and set its uniforms, for shaders/extraction/palette_color.glsl.
     * For run(). */
    void bindPaletteOf(osg::State& state, const LegoSource& source, unsigned int tableUnit,
                       unsigned int colorsUnit) const;

    /** Whether it is this pass's turn; the first pass starts the legolization here. Called in the same way as run(). */
    virtual bool begin(osg::State& state, PassContext& context) const;
    /** Do the work; the last pass marks it as complete. Called with the context current, its work locked, and the
     * program of the pass applied. @return the reason for a failure, in one sentence; empty on success. */
    virtual std::string run(osg::State& state, Legolization& work) const = 0;
    /** The statistic to which the time of this pass is added. */
    virtual double& getTime(LegoStatistics& statistics) const = 0;

private:
    std::string runWithProgram(osg::State& state, Legolization& work) const;
    void deliver(const osg::State& state, Legolization& work) const;

    osg::ref_ptr<PassWorkspace> _workspace;
    unsigned int _step;
    osg::ref_ptr<PassCamera> _camera;
};

} // namespace osgLego
