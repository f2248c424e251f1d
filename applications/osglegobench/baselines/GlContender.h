#pragma once

#include "../Contender.h"

#include <osgLego/gl/GlObject.h>

#include <vector>

#include <osg/State>
#include <osg/Texture2D>
#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgLego
{

/** The base class of contenders that draw the triangles of a mesh with their own programs. It uploads the triangles,
 * measures the time, and restores the GL state. */
class GlContender : public Contender
{
public:
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) final;
    double run() final;
    osg::ref_ptr<const BrickModel> getBricks() final;
    void release() final;

protected:
    // The following functions are called with a plain GL state, which they need not restore.

    /** @return an error message, in one sentence; empty on success. */
    virtual std::string createObjects(osg::State& state) = 0;
    /** Process the triangles, which are already on the GPU, into points of bricks in a buffer. */
    virtual void findBricks(osg::State& state) = 0;
    virtual osg::ref_ptr<const BrickModel> readBricks(osg::State& state) = 0;
    virtual void releaseObjects() = 0;

    /** Draw the triangles with the program that the state has applied, with the inputs of
     * shaders/passes/surface_color.glsl. */
    void draw(osg::State& state) const;
    const GridTriangles& getTriangles() const { return *_triangles; }
    const BrickGrid& getGrid() const { return _triangles->getGrid(); }

private:
    struct Batch
    {
        const GridBatch* source = nullptr;
        GlBuffer buffer;
        osg::ref_ptr<osg::Texture2D> texture;
    };

    void createBatches(osg::State& state);
    void upload(const osg::State& state) const;

    osg::ref_ptr<const GridTriangles> _triangles;
    osg::observer_ptr<osg::State> _state;
    std::vector<Batch> _batches;
};

} // namespace osgLego
