#include <osgLego/data/BrickSet.h>

#include <utility>

namespace osgLego
{

BrickSet::BrickSet(std::uint64_t revision, const BrickModel& model, const LegoStatistics& statistics,
                   MeasureLayout measureLayout, const BrickModel* shown) :
    _revision(revision),
    _grid(model.getGrid()), _points(ModelPoints::get(shown ? *shown : model)), _statistics(statistics),
    _makeModel([] { return nullptr; }), _measureLayout(std::move(measureLayout)), _model(&model)
{
    _statistics.numDrawnBricks = getPoints().points.size();
}

BrickSet::BrickSet(std::uint64_t revision, const BrickGrid& grid, MakeModel makeModel) :
    _revision(revision), _grid(grid), _makeModel(std::move(makeModel))
{
}

std::optional<LayoutStatistics> BrickSet::getLayoutStatistics() const
{
    if (!_measureLayout) return std::nullopt;
    std::call_once(_layoutFlag, [this] { _layoutStatistics = _measureLayout(); });
    return _layoutStatistics;
}

osg::ref_ptr<const BrickModel> BrickSet::getModel() const
{
    std::call_once(_modelFlag,
                   [this]
                   {
                       if (!_model) _model = _makeModel();
                   });
    return _model;
}

} // namespace osgLego
