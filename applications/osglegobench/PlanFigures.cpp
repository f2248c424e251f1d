#include "PlanFigures.h"

#include "JoinedParts.h"

#include <osgLego/Stability.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/ContactFinder.h>

#include <algorithm>
#include <set>
#include <utility>

namespace osgLego
{

namespace
{

/** The number of pieces with parts that fall if only some parts of a model are in place. */
std::size_t countFallingPieces(const BrickModel& model, std::vector<std::uint32_t> placed)
{
    std::sort(placed.begin(), placed.end()); // parts of all models are sorted by their cells
    std::vector<Part> parts;
    parts.reserve(placed.size());
    for (const std::uint32_t part : placed)
        parts.push_back(model.getParts()[part]);
    const osg::ref_ptr<const BrickModel> partial = BrickModel::createOfParts(model.getGrid(), std::move(parts));
    UnionFind sets;
    sets.reset(placed.size());
    for (const Contact& contact : findContacts(*partial))
        if (contact.kind == Contact::STUDS)
            sets.join(static_cast<std::int32_t>(contact.lower), static_cast<std::int32_t>(contact.upper));
    std::set<std::int32_t> pieces;
    const std::optional<StabilityReport> report = computeStability(*partial);
    for (const std::uint32_t part : report->falling)
        pieces.insert(sets.find(static_cast<std::int32_t>(part)));
    return pieces.size();
}

} // namespace

PlanFigures::PlanFigures(const BrickModel& model, const BuildingPlan& plan) : _joined(findJoinedParts(model))
{
    addSteps(model, plan, plan.getSteps(), 0);
}

/** Whether a part will be joined to others, none of which is in place. */
bool PlanFigures::isLoose(std::uint32_t part, const std::vector<bool>& isPlaced) const
{
    return !_joined[part].empty() && std::none_of(_joined[part].begin(), _joined[part].end(),
                                                  [&isPlaced](std::uint32_t other) { return isPlaced[other]; });
}

void PlanFigures::addSteps(const BrickModel& model, const BuildingPlan& plan, const std::vector<BuildingStep>& steps,
                           std::size_t depth)
{
    PartList placed;
    std::vector<bool> isPlaced(_joined.size(), false);
    const PartList& unheld = plan.getUnheldParts();
    for (const BuildingStep& step : steps)
    {
        for (const std::uint32_t submodel : step.submodels)
            addSteps(model, plan, plan.getSubmodels()[submodel].steps, depth + 1);
        const PartList added = plan.getPlacedParts(step);
        for (const std::uint32_t part : added)
            isPlaced[part] = true;
        for (const std::uint32_t part : added)
            if (!std::binary_search(unheld.begin(), unheld.end(), part)) placed.push_back(part);
        const auto numLoose =
            std::count_if(placed.begin(), placed.end(), [&](std::uint32_t part) { return isLoose(part, isPlaced); });
        mostLooseParts = std::max(mostLooseParts, static_cast<std::size_t>(numLoose));
        if (!step.stands && !step.isFromBelow && !placed.empty())
            numFallingPieces = std::max(numFallingPieces, countFallingPieces(model, placed));
    }
    if (depth > 0 && placed.size() == 2) ++numPairs;
}

} // namespace osgLego
