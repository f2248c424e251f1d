#include "BookletModels.h"

#include <PartModels.h>

#include <utility>

namespace osgLego::test
{

namespace
{

constexpr std::array<std::uint8_t, 3> RED{180, 0, 0};
constexpr std::array<std::uint8_t, 3> BLUE{30, 90, 168};
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

} // namespace osgLego::test
