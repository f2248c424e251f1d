#include <osgLego/data/BuildingSet.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace osgLego
{

namespace
{

/** The ranks of bricks that are put in place from bottom to top. */
std::vector<std::uint32_t> rankUpwards(const BrickModel& model)
{
    const auto up = static_cast<std::size_t>(model.getGrid().getUpIndex());
    const std::vector<Brick>& bricks = model.getBricks();
    std::vector<std::uint32_t> order(bricks.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t brick) { return bricks[brick].cell[up]; });
    std::vector<std::uint32_t> ranks(order.size());
    for (std::uint32_t rank = 0; rank < order.size(); ++rank)
        ranks[order[rank]] = rank;
    return ranks;
}

/** Those items whose rank is lower than a number. */
template <typename Item>
std::vector<Item> selectPlaced(const std::vector<Item>& items, const std::vector<std::uint32_t>& ranks,
                               std::size_t numPlaced)
{
    std::vector<Item> placed;
    for (std::size_t index = 0; index < items.size(); ++index)
        if (ranks[index] < numPlaced) placed.push_back(items[index]);
    return placed;
}

} // namespace

BuildingSet::BuildingSet(std::uint64_t revision, const BrickModel& model, const BuildingPlan* plan) :
    _revision(revision), _model(&model), _plan(plan), _ranks(plan ? plan->getRanks() : rankUpwards(model)),
    _points(createBuildingPoints(model, _ranks))
{
}

std::size_t BuildingSet::getNumPlaced(double progress) const
{
    return static_cast<std::size_t>(std::llround(progress * static_cast<double>(_ranks.size())));
}

osg::ref_ptr<const BrickModel> BuildingSet::getPlacedModel(std::size_t numPlaced) const
{
    if (numPlaced >= _ranks.size()) return _model;
    const std::lock_guard lock(_mutex);
    if (_placedModel && _numPlaced == numPlaced) return _placedModel;
    _numPlaced = numPlaced;
    _placedModel =
        _plan ? BrickModel::createOfParts(_model->getGrid(), selectPlaced(_model->getParts(), _ranks, numPlaced))
              : BrickModel::create(_model->getGrid(), selectPlaced(_model->getBricks(), _ranks, numPlaced));
    return _placedModel;
}

} // namespace osgLego
