#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** How easily a plan can be followed. */
struct PlanFigures
{
    std::size_t numPairs = 0;         //!< submodels of two parts
    std::size_t mostLooseParts = 0;   //!< after a step, parts joined to no other, though one to come joins them
    std::size_t numFallingPieces = 0; //!< most pieces that joints connect, with parts that fall after a step

    PlanFigures(const BrickModel& model, const BuildingPlan& plan);

private:
    using PartList = std::vector<std::uint32_t>;

    bool isLoose(std::uint32_t part, const std::vector<bool>& isPlaced) const;
    void addSteps(const BrickModel& model, const BuildingPlan& plan, const std::vector<BuildingStep>& steps,
                  std::size_t depth);

    std::vector<PartList> _joined; // for each part, the others
};

} // namespace osgLego
