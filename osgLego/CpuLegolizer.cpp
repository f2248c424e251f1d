#include <osgLego/CpuLegolizer.h>

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/flattening/GridTriangles.h>

#include <osg/Notify>

namespace osgLego
{

osg::ref_ptr<const BrickModel> legolizeOnCpu(const osg::Node& node, const LegoSettings& settings)
{
    if (const std::string error = settings.check(); !error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return nullptr;
    }
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(node);
    if (scene->getNumTriangles() == 0)
    {
        OSG_WARN << "osgLego: '" << node.getName() << "' has no visible triangles to legolize" << std::endl;
        return nullptr;
    }
    if (const std::string obstacle = BrickGrid::findObstacle(scene->getBounds(), settings); !obstacle.empty())
    {
        OSG_WARN << "osgLego: " << obstacle << std::endl;
        return nullptr;
    }
    return voxelizeOnCpu(*GridTriangles::create(*scene, settings));
}

} // namespace osgLego
