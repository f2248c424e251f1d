#pragma once

#include "GatheredCells.h"
#include "GlContender.h"

#include <osgLego/gl/GlObject.h>

namespace osgLego
{

/** The base class of contenders that read pictures of the mesh back, gather their cells on the CPU, and upload points
 * of bricks. */
class ReadBackContender : public GlContender
{
protected:
    std::string createObjects(osg::State& state) override;
    void findBricks(osg::State& state) final;
    osg::ref_ptr<const BrickModel> readBricks(osg::State& state) final;
    void releaseObjects() override;

    /** Draw the mesh and add the cells that it covers. */
    virtual void gatherCells(osg::State& state, GatheredCells& cells) = 0;

private:
    GatheredCells _cells;
    GlBuffer _points;
};

} // namespace osgLego
