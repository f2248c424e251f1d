#include "ReadBackContender.h"

namespace osgLego
{

std::string ReadBackContender::createObjects(osg::State& state)
{
    _points = GlBuffer(state);
    return {};
}

void ReadBackContender::findBricks(osg::State& state)
{
    _cells.reset(getGrid().dimensions);
    gatherCells(state, _cells);
    const std::vector<BrickPoint>& points = _cells.findVisible();
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_ARRAY_BUFFER, _points.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(BrickPoint)), points.data(),
                            GL_STATIC_DRAW);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

osg::ref_ptr<const BrickModel> ReadBackContender::readBricks(osg::State&)
{
    return _cells.createModel(getGrid());
}

void ReadBackContender::releaseObjects()
{
    _cells = GatheredCells();
    _points = GlBuffer();
}

} // namespace osgLego
