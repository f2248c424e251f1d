#include <osgLego/ModelDesign.h>

#include <osgLego/data/BuildingLimits.h>
#include <osgLego/text/CountedNoun.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <sstream>

namespace osgLego
{

namespace
{

std::string describeStability(const DesignCandidate& candidate)
{
    const StabilityReport& stability = candidate.stability;
    if (stability.stands && !candidate.isWhole()) return "apart";
    if (stability.stands) return stability.safe ? "safely" : "yes";
    return stability.falls() ? "no" : "unknown";
}

/** Steps after which to hold something; `-` without a plan. */
std::string describeHeld(const DesignCandidate& candidate)
{
    return candidate.plan ? std::to_string(candidate.plan->getNumFalling()) : "-";
}

/** Parts of the largest submodel and how deep submodels are nested, such as `95x2`, or `none`; `-` without a plan. */
std::string describeSubmodels(const DesignCandidate& candidate)
{
    if (!candidate.plan) return "-";
    if (candidate.plan->getSubmodels().empty()) return "none";
    return std::to_string(candidate.plan->getLargestSubmodel()) + "x" +
           std::to_string(candidate.plan->getDeepestSubmodel());
}

/** A row for each candidate, below a header. */
std::string listCandidates(const std::vector<DesignCandidate>& candidates)
{
    std::size_t width = 8;
    for (const DesignCandidate& candidate : candidates)
        width = std::max(width, candidate.settings.toString().size());
    std::ostringstream text;
    text << std::fixed << std::left << std::setw(static_cast<int>(width)) << "settings" << std::right
         << "  parts pieces  stands submodel hold surface  colour   lost unlikeness\n";
    for (const DesignCandidate& candidate : candidates)
        text << std::left << std::setw(static_cast<int>(width)) << candidate.settings.toString() << std::right
             << std::setw(7) << candidate.layout.numParts << std::setw(7) << candidate.numPieces << std::setw(8)
             << describeStability(candidate) << std::setw(9) << describeSubmodels(candidate) << std::setw(5)
             << describeHeld(candidate) << std::setprecision(2) << std::setw(6) << 100.0 * candidate.surfaceError
             << " %" << std::setw(8) << std::setprecision(1) << candidate.colorError << std::setw(5)
             << 100.0 * candidate.lostSurface << " %" << std::setw(11) << std::setprecision(2) << candidate.getError()
             << '\n';
    return text.str();
}

/** Whether most parts are in one submodel, which a builder doesn't hold in a hand. */
bool isMostlySubmodel(const DesignCandidate& candidate)
{
    const std::size_t largest = candidate.plan->getLargestSubmodel();
    return largest > BuildingPlan::MOST_PARTS_HELD && 2 * largest > candidate.layout.numParts;
}

std::string explainChoice(const DesignCandidate& best, std::size_t numCandidates, std::size_t numOthers)
{
    const std::string of = numOthers == 0 ? " of " + std::to_string(numCandidates) + " different models"
                                          : " of " + counted(numCandidates, "model", "models") + " and " +
                                                counted(numOthers, "draft", "drafts");
    if (numCandidates == 1 && numOthers == 0) return "the only model that the settings allow";
    if (!best.isWhole()) return "none" + of + " is one piece; this one is most like the mesh";
    if (!best.stability.stands) return "none" + of + " is one piece and stands; this one is most like the mesh";
    return std::string("most like the mesh") + of + ", among those that are one piece and stand" +
           (best.stability.safe ? " safely" : "") +
           (best.plan && !best.exceedsLimits() && !isMostlySubmodel(best) ? ", and are easy to build" : "");
}

/** Lines on building by hand; empty without a plan. */
std::string explainBuilding(const DesignCandidate& best)
{
    if (!best.plan)
        return best.isSound() ? "building: not planned, since the model has more than " +
                                    std::to_string(DesignCandidate::MOST_PLANNED_PARTS) + " parts\n"
                              : "";
    const BuildingPlan& plan = *best.plan;
    std::size_t numInSubmodels = 0;
    for (const Submodel& submodel : plan.getSubmodels())
        numInSubmodels += submodel.steps.size();
    std::string text = "building: " + counted(plan.getSteps().size(), "step", "steps");
    if (numInSubmodels > 0)
        text += ", and " + counted(numInSubmodels, "step", "steps") + " in " +
                counted(plan.getSubmodels().size(), "submodel", "submodels") + " of up to " +
                counted(plan.getLargestSubmodel(), "part", "parts") + ", nested " +
                std::to_string(plan.getDeepestSubmodel()) + " deep";
    if (plan.getNumFalling() > 0)
        text += "; hold the model or a submodel after " + counted(plan.getNumFalling(), "step", "steps");
    text += '\n';
    if (!best.exceedsLimits() && isMostlySubmodel(best))
        text += "most parts are in one submodel, which is attached to the rest as a whole\n";
    if (best.exceedsLimits())
        text += "hard to build: " +
                describeExcess(plan.getLargestSubmodel(), plan.getDeepestSubmodel(), plan.getNumFalling()) +
                ": no model that stands as well is easier, with columns below it or without\n";
    return text;
}

/** Pieces may lean on each other. */
std::string explainStability(const DesignCandidate& best)
{
    if (best.isWhole() && best.layout.numComponents > 1)
        return "the base plate joins these pieces; " + best.stability.toString();
    if (best.isWhole() || !best.stability.stands) return best.stability.toString();
    return "the model is " + std::to_string(best.numPieces) + " pieces that no part joins: they stand, but not as one";
}

// Of the columns of listCandidates().
constexpr const char* LEGEND = R"(surface: distance of the bricks from the mesh, in percent of its longest side
colour: difference between mesh and bricks there, in CIEDE2000; the colour error above is that of parts and cells
lost: surface of the mesh in gaps that bricks close, in percent
unlikeness: surface, a tenth of colour, and a quarter of lost
submodel: parts of the largest, and how deep submodels are nested, or none, where building was planned
hold: steps after which something has to be held, where building was planned
The first model is the chosen one.
)";

} // namespace

std::string ModelDesign::toString() const
{
    const DesignCandidate& best = getBest();
    return "chosen: " + best.settings.toString() + ": " + explainChoice(best, candidates.size(), numOthers) + "\n" +
           best.layout.toString() + "\n" + explainStability(best) + "\n" + explainBuilding(best) + "\n" + LEGEND +
           listCandidates(candidates) +
           (numOthers > 0 ? "no models were made by " + counted(numOthers, "other setting", "other settings") +
                                ", whose drafts were clearly less like the mesh\n"
                          : "");
}

} // namespace osgLego
