#include <osgLego/voxelization/DominantColorTargets.h>

#include <osgLego/gl/PassCamera.h>
#include <osgLego/voxelization/ExactCells.h>

namespace osgLego
{

DominantColorTargets::DominantColorTargets(const PassPlan& plan, osg::Texture2D& sums) :
    _program(getExactCellsProgram("dominant color", "voxelization/dominant_color.frag", plan.cellsPerTriangle)),
    _sums(&sums), _colors(PassCamera::createTarget(plan.imageSize, internalFormatOf(VoxelFormat::COLOR))),
    _depths(PassCamera::createDepthTarget(plan.imageSize))
{
}

} // namespace osgLego
