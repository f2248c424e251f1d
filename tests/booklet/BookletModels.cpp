#include "BookletModels.h"

#include <PartModels.h>

#include <utility>

namespace osgLego::test
{

namespace
{

constexpr std::int32_t RED_CODE = 4;
constexpr std::int32_t BLUE_CODE = 1;

} // namespace

BuildingStep createStep(std::vector<std::uint32_t> parts, std::vector<std::uint32_t> submodels)
{
    BuildingStep step;
    step.parts = std::move(parts);
    step.submodels = std::move(submodels);
    return step;
}

BookletModel createTower(const TowerSetting& setting)
{
    const auto model =
        BrickModel::createOfParts(createPartGrid({8, 4, 3}, 1.2), {{{0, 0, 0}, {2, 4, 1}, RED, RED_CODE},
                                                                   {{4, 0, 0}, {2, 4, 1}, RED, RED_CODE},
                                                                   {{1, 0, 1}, {4, 2, 1}, BLUE, BLUE_CODE},
                                                                   {{1, 2, 1}, {4, 2, 1}, RED, RED_CODE},
                                                                   {{1, 1, 2}, {4, 2, 1}, BLUE, BLUE_CODE},
                                                                   {{4, 3, 2}, {1, 1, 1}, RED, RED_CODE}});
    Submodel outer;
    outer.steps = {createStep({2}), createStep({}, {1})};
    std::vector<BuildingStep> steps{createStep({0, 1}), createStep({}, {0}), createStep({4, 5})};
    if (setting.hasTwoSubmodels)
    {
        outer.steps.pop_back();
        steps[1].submodels = {0, 1};
    }
    Submodel inner;
    inner.steps = {createStep({3})};
    inner.steps[0].isFromBelow = setting.isInnerUpsideDown;
    steps[2].turns = setting.turnsOfLastStep;
    for (const std::size_t step : setting.fallingSteps)
        steps[step].stands = false;
    const auto plan = BuildingPlan::create(6, std::move(steps), {outer, inner}, setting.unheldParts);
    return {*model, *plan, Palette::getKnownColors(), setting.base};
}

BookletModel createTwins(bool largeFalls, bool largeIsOneStep)
{
    std::vector<Part> parts{{{0, 0, 0}, {8, 2, 1}, RED, RED_CODE}};
    for (std::uint16_t x = 0; x <= 2; x = static_cast<std::uint16_t>(x + 2))
    {
        parts.push_back({{x, 0, 1}, {2, 2, 1}, RED, RED_CODE});
        parts.push_back({{x, 0, 2}, {2, 2, 1}, BLUE, BLUE_CODE});
    }
    for (std::uint16_t z = 1; z <= 5; ++z)
        parts.push_back({{4, 0, z}, {2, 2, 1}, RED, RED_CODE});
    const auto model = BrickModel::createOfParts(createPartGrid({8, 2, 6}, 1.2), parts);
    const auto find = [&model](int x, int z) {
        return static_cast<std::uint32_t>(model->findPart({x, 0, z}) - model->getParts().data());
    };
    std::vector<Submodel> submodels;
    for (const int x : {0, 2})
        submodels.push_back({{createStep({find(x, 1), find(x, 2)})}});
    submodels.push_back({});
    std::vector<BuildingStep>& steps = submodels.back().steps;
    for (int z = 1; z <= 5; ++z)
        if (largeIsOneStep && z > 1)
            steps.back().parts.push_back(find(4, z));
        else
            steps.push_back(createStep({find(4, z)}));
    if (largeFalls) steps[1].stands = false;
    const auto plan = BuildingPlan::create(
        parts.size(), {createStep({find(0, 0)}), createStep({}, {0, 1}), createStep({}, {2})}, submodels);
    return {*model, *plan, Palette::getKnownColors()};
}

} // namespace osgLego::test
