#pragma once

#include "../Contender.h"
#include "MeshDrawing.h"

#include <osg/State>
#include <osg/observer_ptr>

namespace osgLego
{

/** What contenders have in common that draw the triangles of a mesh by programs of their own: the triangles on the
 * GPU, the time taken, and a GL state that is as it was. */
class GlContender : public Contender
{
public:
    std::string prepare(const BenchMesh& mesh, osg::GraphicsContext& context) final;
    double run() final;
    osg::ref_ptr<const BrickModel> getBricks() final;
    void release() final;

protected:
    // All of these are called with a plain GL state, which need not be left as it was.

    /** @return why it can't, in one sentence; empty when it can. */
    virtual std::string createObjects(osg::State& state) = 0;
    /** Turn the triangles, which are on the GPU by now, into points of bricks in a buffer. */
    virtual void findBricks(osg::State& state) = 0;
    virtual osg::ref_ptr<const BrickModel> readBricks(osg::State& state) = 0;
    virtual void releaseObjects() = 0;

    const MeshDrawing& getDrawing() const { return _drawing; }
    const GridTriangles& getTriangles() const { return *_triangles; }
    const BrickGrid& getGrid() const { return _triangles->getGrid(); }

private:
    osg::ref_ptr<const GridTriangles> _triangles;
    osg::observer_ptr<osg::State> _state;
    MeshDrawing _drawing;
};

} // namespace osgLego
