#include <osgLego/producer/BrickUploadPass.h>

#include <osgLego/data/BrickPoints.h>
#include <osgLego/gl/GlMemory.h>

namespace osgLego
{

BrickUploadPass::BrickUploadPass(BrickStore& store) : LegolizationPass(store, 1)
{
    setCamera(new PassCamera(*this));
}

bool BrickUploadPass::begin(osg::State& state, ContextBricks& bricks) const
{
    // Of the passes of the GPU one has the same number.
    return LegolizationPass::begin(state, bricks) && bricks.work->model;
}

std::string BrickUploadPass::run(osg::State& state, ContextBricks& bricks) const
{
    Legolization& work = *bricks.work;
    BrickPoints points = createBrickPoints(*work.model);
    work.numBricks = points.points.size();
    work.blocks = std::move(points.blocks);
    work.bricks = GlBuffer(state);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, work.bricks.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.points.size() * sizeof(BrickPoint)),
                            points.points.data(), GL_STATIC_DRAW);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    if (takeOutOfMemoryError())
        return "there is no room for " + std::to_string(work.numBricks) + " bricks; allowed: a lower resolution";
    bricks.finish();
    return {};
}

} // namespace osgLego
