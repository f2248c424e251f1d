#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/Export.h>
#include <osgLego/LayoutStatistics.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/StabilityReport.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** A model of a mesh that designModel() tried. */
struct OSGLEGO_EXPORT DesignCandidate
{
    LegoSettings settings;                //!< with these, legolizeOnCpu() makes the same model
    osg::ref_ptr<const BrickModel> model; //!< made of parts
    LayoutStatistics layout;              //!< the figures of its parts
    StabilityReport stability;            //!< on the base of DesignOptions
    std::size_t numPieces = 0;            //!< of the layout; a base plate joins those that stand on it
    static constexpr std::size_t MOST_PLANNED_PARTS = 2000; //!< of models whose building is planned

    /** The order of building on that base, for the view of DesignOptions; null if it was not planned, as for candidates
     * that can't become the best. */
    osg::ref_ptr<const BuildingPlan> plan;
    /** The distance between the outer sides of bricks and the mesh: the root of the mean square over their area, as a
     * share of the longest side of the mesh. */
    double surfaceError = 0.0;
    /** The mean difference (CIEDE2000) between the outer sides of bricks and the nearest place of the mesh. */
    double colorError = 0.0;
    /** The share of the outer surface of the mesh that the model does not show, since bricks close the gap in which it
     * is, such as that between two legs, or the grid cuts it off: more than one and a quarter of the longest edge of a
     * cell from all outer sides of bricks, 0 to 1. */
    double lostSurface = 0.0;

    /** The unlikeness of the model to the mesh, by which candidates are compared: `surfaceError` in percent, a tenth of
     * `colorError`, and a quarter of `lostSurface` in percent. */
    double getError() const { return 100.0 * surfaceError + 0.1 * colorError + 25.0 * lostSurface; }
    /** Whether the model is one piece, with its base plate if that is the base. */
    bool isWhole() const { return numPieces == 1; }
    /** Whether the model can be built and stays up: it is one piece and stands. */
    bool isSound() const { return isWhole() && stability.stands; }
    /** Whether the building is beyond the limits of BuildingPlan; true for large models, whose building is not planned.
     */
    bool exceedsLimits() const { return plan ? !plan->keepsLimits() : layout.numParts > MOST_PLANNED_PARTS; }
};

/** The models of a mesh that were compared, and the one that was chosen. */
struct OSGLEGO_EXPORT ModelDesign
{
    /** The best first: sound models before others, those that have few enough parts, those whose building keeps the
     * limits of BuildingPlan, and those more like the mesh before those less like it. Not empty. */
    std::vector<DesignCandidate> candidates;
    /** The number of other settings, by which no models were made, since their drafts were clearly less like the mesh
     * than the best one. */
    std::size_t numOthers = 0;
    /** The number of parts that models should not exceed; unset if the options gave a size and no number. */
    std::optional<std::size_t> mostParts = std::nullopt;

    const DesignCandidate& getBest() const { return candidates.front(); }
    /** The settings, the size, the figures and the defects of the best model in a few lines of English, and why it was
     * chosen: a table of all candidates. */
    std::string toString() const;
};

} // namespace osgLego
