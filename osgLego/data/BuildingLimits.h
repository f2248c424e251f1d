#pragma once

#include <osgLego/BuildingPlan.h>

#include <cstddef>
#include <string>

namespace osgLego
{

/** The limits that a building plan exceeds, such as "its largest submodel has 522 parts, where 150 are easy; something
 * has to be held after 12 steps, where 5 are easy". Empty if it keeps them. */
inline std::string describeExcess(std::size_t largestSubmodel, std::size_t deepestSubmodel, std::size_t numFallingSteps)
{
    std::string text;
    const auto add = [&text](const std::string& begin, std::size_t value, const std::string& end, std::size_t limit)
    {
        if (value > limit)
            text += (text.empty() ? "" : "; ") + begin + std::to_string(value) + end + ", where " +
                    std::to_string(limit) + " are easy";
    };
    add("its largest submodel has ", largestSubmodel, " parts", BuildingPlan::MOST_SUBMODEL_PARTS);
    add("its submodels are nested in ", deepestSubmodel, " levels", BuildingPlan::DEEPEST_SUBMODEL);
    add("something has to be held after ", numFallingSteps, " steps", BuildingPlan::MOST_FALLING_STEPS);
    return text;
}

} // namespace osgLego
