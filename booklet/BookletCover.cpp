#include "BookletCover.h"

#include "BookletText.h"

#include <common/NumberText.h>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

/** "steps 3, 7 and B2", for example, or only how many they are. */
std::string nameSteps(const std::vector<std::string>& names)
{
    constexpr std::size_t MOST_NAMES = 10;
    if (names.size() == 1) return "step " + names.front();
    return names.size() > MOST_NAMES ? countOf(names.size(), "step") : "steps " + joinWords(names);
}

} // namespace

std::vector<std::string> createWarnings(const BookletModel& model, const std::optional<StabilityReport>& stability,
                                        const BuildingPlan& plan, BuildingBase base)
{
    std::vector<std::string> warnings;
    const std::string place = base == BuildingBase::TABLE ? "a table" : "a base plate";
    if (!stability)
        warnings.push_back("It was not computed whether this model stands, since it has so many parts.");
    else if (!stability->stands && !stability->falls())
        warnings.push_back("It is unknown whether this model stands on " + place + ": the forces between " +
                           countOf(stability->unknown.size(), "part") + " can't be computed precisely enough.");
    else if (stability->tips())
        warnings.push_back("This model tips over on " + place +
                           ": its centre of mass is not above its foot. Build it on a base plate, or lean it against "
                           "something.");
    else if (!stability->stands)
        warnings.push_back("This model does not stand on " + place + ": " + countOf(stability->falling.size(), "part") +
                           " would fall. Support it from below, or make it with support=on.");
    else if (stability->tipsEasily())
        warnings.push_back(
            fmt::format("This model stands, but tips over easily, on a table that is tilted by {:.1f} degrees: "
                        "lean it against something, or build it on a base plate.",
                        *stability->tippingAngle));
    else if (!stability->safe)
        warnings.push_back("This model stands, but parts that are worn may not hold it: handle it with care.");
    if (const std::size_t unheld = model.getNumUnheld())
        warnings.push_back("This model can't be built as it is: nothing holds " + countOf(unheld, "part") + " when " +
                           (unheld == 1 ? "it is" : "they are") + " placed.");
    if (model.getNumPieces() > 1)
        warnings.push_back(
            fmt::format("This model consists of {} that no stud connects.", countOf(model.getNumPieces(), "piece")));
    if (const std::vector<std::string> falling = model.getFallingSteps(); !falling.empty())
        warnings.push_back(fmt::format("After {}, the model, or a submodel, does not stand by itself: hold it there.",
                                       nameSteps(falling)));
    if (const std::size_t numUnchecked = plan.getNumUnchecked())
        warnings.push_back(fmt::format("Of {}, it was not computed whether the model stands after {}.",
                                       countOf(numUnchecked, "step"), numUnchecked == 1 ? "it" : "them"));
    for (const std::string& warning :
         {model.getPartsList().describeNeverMade(), model.getPartsList().describeWithoutNumber()})
        if (!warning.empty()) warnings.push_back("Parts " + warning + ".");
    return warnings;
}

} // namespace osgLego
