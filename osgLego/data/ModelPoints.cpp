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

const DistantOcclusion& ModelPoints::getDistantOcclusion() const
{
    std::call_once(_occlusionFlag, [this] { _distantOcclusion = DistantOcclusion::create(_grid, _points.points); });
    _hasDistantOcclusion = true;
    return *_distantOcclusion;
}

} // namespace osgLego
