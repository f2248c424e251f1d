#include "ReadBackContender.h"

#include "GlRestoration.h"

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
    uploadBuffer(state, GL_ARRAY_BUFFER, _points, _cells.findVisible(), GL_STATIC_DRAW);
}

osg::ref_ptr<const BrickModel> ReadBackContender::readBricks(osg::State&)
{
    return createModel(getGrid(), _cells.getBricks());
}

void ReadBackContender::releaseObjects()
{
    _cells = GatheredCells();
    _points = GlBuffer();
}

} // namespace osgLego
