#include "PlanCheck.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego::test
{

PlanCheck::PlanCheck(const BrickModel& model, const BuildingPlan& plan) :
    _model(model), _plan(plan), _up(model.getGrid().getUpIndex())
{
    checkSequence(plan.getSteps(), "the model");
    for (std::size_t index = 0; index < plan.getSubmodels().size(); ++index)
        checkSequence(plan.getSubmodels()[index].steps, "submodel " + std::to_string(index));
}

template <typename Visitor>
void PlanCheck::visitCells(std::uint32_t part, const Visitor& visit) const
{
    const glm::ivec3 lower = _model.getParts()[part].getCell();
    const glm::ivec3 upper = lower + _model.getParts()[part].getSize();
    for (int z = lower.z; z < upper.z; ++z)
        for (int y = lower.y; y < upper.y; ++y)
            for (int x = lower.x; x < upper.x; ++x)
                visit(glm::ivec3(x, y, z));
}

std::size_t PlanCheck::toIndex(const glm::ivec3& cell) const
{
    const glm::ivec3& size = _model.getGrid().dimensions;
    return static_cast<std::size_t>(cell.x + size.x * (cell.y + size.y * cell.z));
}

bool PlanCheck::isCovered(const glm::ivec3& cell) const
{
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
           glm::all(glm::lessThan(cell, _model.getGrid().dimensions)) && _isPlaced[toIndex(cell)];
}

void PlanCheck::checkSequence(const std::vector<BuildingStep>& steps, const std::string& name)
{
    _isPlaced.assign(_model.getGrid().getNumCells(), false);
    if (steps.empty()) return;
    _way = steps.front().isFromBelow ? -1 : 1;
    _baseLayer = std::numeric_limits<int>::max();
    for (const BuildingStep& step : steps)
        for (const std::uint32_t part : _plan.getPlacedParts(step))
            visitCells(part, [&](const glm::ivec3& cell) { _baseLayer = std::min(_baseLayer, _way * cell[_up]); });
    for (const BuildingStep& step : steps)
    {
        const std::string place = name + ", step " + std::to_string(&step - steps.data() + 1);
        const std::size_t size = step.parts.size() + 2 * step.submodels.size();
        const auto isKnown = [&](std::uint32_t part)
        { return std::binary_search(_plan.getUnheldParts().begin(), _plan.getUnheldParts().end(), part); };
        const std::vector<std::uint32_t> placed = _plan.getPlacedParts(step);
        const bool isUnheld = isKnown(placed.front());
        const bool isLast = &step == &steps.back() || isKnown(_plan.getPlacedParts(*(&step + 1)).front());
        if (size < 5 && !isLast && !isUnheld && step.submodels.empty())
            _short.push_back(place + ": " + std::to_string(size));
        if (size > 12 || size == 0) _long.push_back(place + ": " + std::to_string(size));
        if (step.isFromBelow != steps.front().isFromBelow) _unheld.push_back(place + " turns the model over");
        for (std::size_t first = 0; first < step.parts.size();)
        {
            const PartList inHand = findInHand(std::span(step.parts).subspan(first));
            this->place(inHand, place + ", part " + std::to_string(inHand.front()));
            first += inHand.size();
        }
        for (const std::uint32_t submodel : step.submodels)
        {
            BuildingStep attached;
            attached.submodels = {submodel};
            this->place(_plan.getPlacedParts(attached), place + ", submodel " + std::to_string(submodel));
        }
    }
}

/** The first of some parts, and those that hang from it and are placed with it. */
PlanCheck::PartList PlanCheck::findInHand(std::span<const std::uint32_t> parts)
{
    constexpr std::size_t MOST = 3;
    glm::ivec3 above(0);
    above[_up] = _way;
    PartList inHand{parts.front()};
    std::vector<glm::ivec3> cells;
    std::vector<glm::ivec3> hanging;
    visitCells(parts.front(), [&](const glm::ivec3& cell) { cells.push_back(cell); });
    for (const std::uint32_t part : parts.subspan(1).first(std::min(parts.size(), MOST) - 1))
    {
        bool isJoined = false; // below a part in the hand, or on one that hangs
        std::vector<glm::ivec3> own;
        visitCells(part,
                   [&](const glm::ivec3& cell)
                   {
                       isJoined = isJoined || std::find(cells.begin(), cells.end(), cell + above) != cells.end() ||
                                  std::find(hanging.begin(), hanging.end(), cell - above) != hanging.end();
                       own.push_back(cell);
                   });
        if (!isJoined) break;
        inHand.push_back(part);
        for (auto* list : {&cells, &hanging})
            list->insert(list->end(), own.begin(), own.end());
    }
    return inHand;
}

void PlanCheck::place(const PartList& parts, const std::string& name)
{
    glm::ivec3 below(0);
    below[_up] = -_way;
    bool isHeld = false;
    bool isReachable = true;
    bool isPressedOn = false;
    bool hasRoomBelow = true;
    for (const std::uint32_t part : parts)
        visitCells(part,
                   [&](const glm::ivec3& cell)
                   {
                       isHeld = isHeld || _way * cell[_up] == _baseLayer || isCovered(cell + below);
                       isPressedOn = isPressedOn || isCovered(cell - below);
                       hasRoomBelow = hasRoomBelow && !isCovered(cell + below);
                       for (glm::ivec3 above = cell - below;
                            above[_up] >= 0 && above[_up] < _model.getGrid().dimensions[_up]; above -= below)
                           isReachable = isReachable && !isCovered(above);
                   });
    const std::vector<std::uint32_t>& known = _plan.getUnheldParts();
    if (!std::binary_search(known.begin(), known.end(), parts.front()))
    {
        if (!isHeld && !isPressedOn) _unheld.push_back(name + " is not held");
        if (!isHeld && isPressedOn) _numPressedOn += parts.size();
        if (!isReachable && !(isPressedOn && hasRoomBelow))
            _unreachable.push_back(name + " is placed below other parts");
    }
    if (!isConnected(parts)) _disconnected.push_back(name + " is in several pieces");
    for (const std::uint32_t part : parts)
        visitCells(part, [&](const glm::ivec3& cell) { _isPlaced[toIndex(cell)] = true; });
}

bool PlanCheck::isConnected(const PartList& parts) const
{
    PartList rest = parts;
    PartList reached{rest.back()};
    rest.pop_back();
    const auto areJointed = [&](std::uint32_t a, std::uint32_t b)
    {
        const Part& first = _model.getParts()[a];
        const Part& second = _model.getParts()[b];
        const glm::ivec3 overlap = glm::min(first.getCell() + first.getSize(), second.getCell() + second.getSize()) -
                                   glm::max(first.getCell(), second.getCell());
        glm::ivec3 needed(1);
        needed[_up] = 0;
        return overlap[_up] == 0 && glm::all(glm::greaterThanEqual(overlap, needed));
    };
    while (!reached.empty())
    {
        const std::uint32_t part = reached.back();
        reached.pop_back();
        const auto loose =
            std::partition(rest.begin(), rest.end(), [&](std::uint32_t other) { return !areJointed(part, other); });
        reached.insert(reached.end(), loose, rest.end());
        rest.erase(loose, rest.end());
    }
    return rest.empty();
}

std::string PlanCheck::toString() const
{
    std::string text;
    for (const auto* list : {&_unheld, &_unreachable, &_disconnected, &_short, &_long})
        for (const std::string& line : *list)
            text += line + "\n";
    return text;
}

osg::ref_ptr<const BrickModel> selectParts(const BrickModel& model, const std::vector<std::uint32_t>& parts)
{
    std::vector<Part> selected;
    for (const std::uint32_t part : parts)
        selected.push_back(model.getParts()[part]);
    return BrickModel::createOfParts(model.getGrid(), std::move(selected));
}

} // namespace osgLego::test
