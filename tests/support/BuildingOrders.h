#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego::test
{

/** A plan that places parts in the given order, one in each step. */
inline osg::ref_ptr<const BuildingPlan> createPlan(const std::vector<std::uint32_t>& order)
{
    std::vector<BuildingStep> steps;
    for (const std::uint32_t part : order)
        steps.emplace_back().parts = {part};
    return BuildingPlan::create(order.size(), steps);
}

/** All parts of a model in a random order. */
inline std::vector<std::uint32_t> createRandomOrder(const BrickModel& model, std::uint32_t seed)
{
    std::vector<std::uint32_t> order(model.getParts().size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    return order;
}

/** A model that consists of the first parts of an order. */
inline osg::ref_ptr<const BrickModel> createPlacedModel(const BrickModel& model,
                                                        const std::vector<std::uint32_t>& order, std::size_t numPlaced)
{
    std::vector<Part> parts;
    for (std::size_t place = 0; place < numPlaced; ++place)
        parts.push_back(model.getParts()[order[place]]);
    return BrickModel::createOfParts(model.getGrid(), parts);
}

} // namespace osgLego::test
