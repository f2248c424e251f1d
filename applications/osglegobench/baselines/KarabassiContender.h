#pragma once

#include "DepthPicture.h"
#include "ReadBackContender.h"

#include <osg/Program>

namespace osgLego
{

/** Six depth buffers: Karabassi, Papaioannou, Theoharis, "A Fast Depth-Buffer-Based Voxelization Algorithm", 1999.
 *
 * The mesh is drawn along x, y and z, the nearest surface and the farthest, and the cells that the six depth maps tell
 * are taken; colours come from pictures drawn with the depths. Where the published method fills all the cells that lie
 * between both depths along all three axes, a solid, only the surface counts here, as it does for all contenders. What
 * no axis sees from outside (cavities, folds) is not found, nor what falls between the centres of pixels on all axes.
 */
class KarabassiContender : public ReadBackContender
{
public:
    std::string getName() const override { return "karabassi"; }
    bool hasColors() const override { return true; }

protected:
    std::string createObjects(osg::State& state) override;
    void gatherCells(osg::State& state, GatheredCells& cells) override;
    void releaseObjects() override;

private:
    DepthPictures _pictures;
    osg::ref_ptr<osg::Program> _program;
};

} // namespace osgLego
