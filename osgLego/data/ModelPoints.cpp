#include <osgLego/data/ModelPoints.h>

#include <osgLego/data/SharedObjects.h>

#include <osg/observer_ptr>

namespace osgLego
{

osg::ref_ptr<const ModelPoints> ModelPoints::get(const BrickModel& model)
{
    static SharedObjects<osg::observer_ptr<const BrickModel>, const ModelPoints> points;
    return points.findOrCreate(&model, [&] { return osg::ref_ptr<const ModelPoints>(new ModelPoints(model)); });
}

ModelPoints::ModelPoints(const BrickModel& model) : _grid(model.getGrid()), _points(createBrickPoints(model)) {}

const std::vector<BrickNeighbors>& ModelPoints::getNeighbors() const
{
    std::call_once(_neighborsFlag, [this] { _neighbors = createBrickNeighbors(_points.points); });
    return _neighbors;
}

const DistantOcclusion& ModelPoints::getDistantOcclusion(NearOcclusion near) const
{
    Occlusion& occlusion = _occlusion[static_cast<std::size_t>(near)];
    std::call_once(occlusion.flag, [&] { occlusion.distant = DistantOcclusion::create(_grid, _points.points, near); });
    occlusion.isComputed = true;
    return *occlusion.distant;
}

} // namespace osgLego
