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

/** The common part of contenders that draw the triangles of a mesh by programs of their own: the triangles on the GPU,
 * the time taken, and a GL state that is restored. */
class GlContender : public Contender
{
public:
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) final;
    double run() final;
    osg::ref_ptr<const BrickModel> getBricks() final;
    void release() final;

protected:
    // All of these are called with a plain GL state, which they need not restore.

    /** @return why it can't, in one sentence; empty when it can. */
    virtual std::string createObjects(osg::State& state) = 0;
    /** Turn the triangles, which are on the GPU by now, into points of bricks in a buffer. */
    virtual void findBricks(osg::State& state) = 0;
    virtual osg::ref_ptr<const BrickModel> readBricks(osg::State& state) = 0;
    virtual void releaseObjects() = 0;

    /** Draw the triangles by the program that the state has applied, with the inputs of
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
