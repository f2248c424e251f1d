#include <osgLego/BuildingPlan.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace osgLego
{

namespace
{

/** Lists the parts of steps in the order in which they are put in place. */
class PlacingOrder
{
public:
    PlacingOrder(const std::vector<Submodel>& submodels, std::size_t numParts) :
        _submodels(submodels), _isUsed(submodels.size(), false), _isPlaced(numParts, false)
    {
    }

    /** @return false if there is nothing to place, if a part or a submodel is unknown or is placed twice, or if the
     * view is impossible. */
    bool add(const BuildingStep& step)
    {
        if (step.parts.empty() && step.submodels.empty()) return false;
        if (step.turns < 0 || step.turns >= BuildingStep::NUM_TURNS) return false;
        for (const std::uint32_t part : step.parts)
        {
            if (part >= _isPlaced.size() || _isPlaced[part]) return false;
            _isPlaced[part] = true;
            _order.push_back(part);
        }
        for (const std::uint32_t submodel : step.submodels)
        {
            if (submodel >= _isUsed.size() || _isUsed[submodel]) return false;
            _isUsed[submodel] = true;
            const std::vector<BuildingStep>& steps = _submodels[submodel].steps;
            const auto addOwn = [&](const BuildingStep& own)
            { return own.isFromBelow == steps.front().isFromBelow && add(own); };
            if (steps.empty() || !std::all_of(steps.begin(), steps.end(), addOwn)) return false;
        }
        return true;
    }

    bool isComplete() const
    {
        return _order.size() == _isPlaced.size() &&
               std::all_of(_isUsed.begin(), _isUsed.end(), [](bool isUsed) { return isUsed; });
    }

    std::vector<std::uint32_t> take() { return std::move(_order); }
    std::size_t getNumPlaced() const { return _order.size(); }

private:
    const std::vector<Submodel>& _submodels;
    std::vector<bool> _isUsed;
    std::vector<bool> _isPlaced;
    std::vector<std::uint32_t> _order;
};

/** Whether parts are in ascending order, each once, and exist. */
bool areAscending(const std::vector<std::uint32_t>& parts, std::size_t numParts)
{
    return std::adjacent_find(parts.begin(), parts.end(), std::greater_equal<>()) == parts.end() &&
           (parts.empty() || parts.back() < numParts);
}

} // namespace

osg::ref_ptr<const BuildingPlan> BuildingPlan::create(std::size_t numParts, std::vector<BuildingStep> steps,
                                                      std::vector<Submodel> submodels,
                                                      std::vector<std::uint32_t> unheld)
{
    osg::ref_ptr<BuildingPlan> plan = new BuildingPlan;
    PlacingOrder order(submodels, numParts);
    for (const BuildingStep& step : steps)
    {
        if (step.isFromBelow || !order.add(step)) return nullptr;
        plan->_numPlaced.push_back(order.getNumPlaced());
    }
    if (!order.isComplete() || !areAscending(unheld, numParts)) return nullptr;
    plan->_order = order.take();
    plan->_ranks.resize(numParts);
    for (std::size_t rank = 0; rank < numParts; ++rank)
        plan->_ranks[plan->_order[rank]] = static_cast<std::uint32_t>(rank);
    plan->_steps = std::move(steps);
    plan->_submodels = std::move(submodels);
    plan->_unheld = std::move(unheld);
    plan->measureSubmodels(plan->_steps, 1);
    return plan;
}

/** Take the size and the depth of submodels of steps into account. @param depth that of the submodels. */
void BuildingPlan::measureSubmodels(const std::vector<BuildingStep>& steps, std::size_t depth)
{
    for (const BuildingStep& step : steps)
        for (const std::uint32_t submodel : step.submodels)
        {
            std::size_t numParts = 0;
            for (const BuildingStep& own : _submodels[submodel].steps)
                for (const std::uint32_t part : getPlacedParts(own))
                    numParts += std::binary_search(_unheld.begin(), _unheld.end(), part) ? 0 : 1;
            if (numParts == 0) continue;
            _largestSubmodel = std::max(_largestSubmodel, numParts);
            _deepestSubmodel = std::max(_deepestSubmodel, depth);
            measureSubmodels(_submodels[submodel].steps, depth + 1);
        }
}

/** By how much a plan is beyond the limits: the sum of what is beyond each, in multiples of it, times all limits, so
 * that it is exact. */
std::size_t BuildingPlan::getExcess() const
{
    const auto getExcessOf = [](std::size_t value, std::size_t limit) {
        return (std::max(value, limit) - limit) * (MOST_SUBMODEL_PARTS * DEEPEST_SUBMODEL * MOST_FALLING_STEPS / limit);
    };
    return getExcessOf(_largestSubmodel, MOST_SUBMODEL_PARTS) + getExcessOf(_deepestSubmodel, DEEPEST_SUBMODEL) +
           getExcessOf(getNumFalling(), MOST_FALLING_STEPS);
}

bool BuildingPlan::keepsLimits() const
{
    return getExcess() == 0;
}

bool BuildingPlan::exceedsLimitsLessThan(const BuildingPlan& other) const
{
    return getExcess() < other.getExcess();
}

std::size_t BuildingPlan::getNumUnchecked() const
{
    const auto isUnchecked = [](const BuildingStep& step) { return !step.isChecked; };
    auto number = std::count_if(_steps.begin(), _steps.end(), isUnchecked);
    for (const Submodel& submodel : _submodels)
        number += std::count_if(submodel.steps.begin(), submodel.steps.end(), isUnchecked);
    return static_cast<std::size_t>(number);
}

std::size_t BuildingPlan::getNumFalling() const
{
    const auto countFalling = [](const std::vector<BuildingStep>& steps)
    {
        return static_cast<std::size_t>(
            std::count_if(steps.begin(), steps.end(), [](const BuildingStep& step) { return !step.stands; }));
    };
    std::size_t number = countFalling(_steps);
    for (const Submodel& submodel : _submodels)
    {
        const std::size_t numParts = std::accumulate(submodel.steps.begin(), submodel.steps.end(), std::size_t{0},
                                                     [this](std::size_t sum, const BuildingStep& step)
                                                     { return sum + getPlacedParts(step).size(); });
        if (numParts > MOST_PARTS_HELD) number += countFalling(submodel.steps);
    }
    return number;
}

std::vector<std::uint32_t> BuildingPlan::getPlacedParts(const BuildingStep& step) const
{
    PlacingOrder order(_submodels, _ranks.size());
    order.add(step);
    return order.take();
}

} // namespace osgLego
