#pragma once

#include <osgLego/Export.h>
#include <osgLego/ModelDesign.h>
#include <osgLego/PlanningOptions.h>
#include <osgLego/StabilityReport.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include <osg/Node>

namespace osgLego
{

/** The goals of designModel(). */
struct DesignOptions
{
    static constexpr std::size_t MOST_PARTS = 10000;
    static constexpr std::size_t USUAL_PARTS = 500;
    static constexpr double SHORTEST = 8.0;   //!< millimetres: a stud
    static constexpr double LONGEST = 8192.0; //!< millimetres: LegoSettings::MAXIMUM_RESOLUTION studs

    /** Settings in their text form that are kept, such as `up=y`; all others may be chosen. */
    std::string settings;
    /** The most parts that the model should have, 1 to MOST_PARTS. A model that has to be supported, or whose size is
     * given by `settings` or `length`, may have more if none with few enough is as sound. Unset: USUAL_PARTS, or any
     * number if the size is given. */
    std::optional<std::size_t> numParts;
    /** The longest side of the model in millimetres, SHORTEST to LONGEST; unset: as long as `numParts` allow. */
    std::optional<double> length;
    BuildingBase base = BuildingBase::TABLE; //!< on which the model has to stand
    BuildingView view;                       //!< for which DesignCandidate::plan is made; BuildingView::isValid()
    /** Called regularly, from any thread; designModel() ends soon after it returns true. May be empty. */
    std::function<bool()> isCancelled;
    /** Called with the share of the work that is done, 0 to 1, from any thread, one call at a time. May be empty. */
    std::function<void(double)> progress;
};

/** Find the settings that make the best model of a mesh: as like the mesh as the number of parts allows, in one piece,
 * and standing.
 *
 * Tries combinations of LegoSettings::Grid::proportions, LegoSettings::Parts::fill and LegoSettings::Colors::count,
 * each with the highest resolution whose model has few enough parts. Those whose drafts are clearly less like the mesh
 * than the best one make a model only if no other is good, or if the best one that is easy to build is less like it
 * than they are. Models are joined to one piece (LegoSettings::Parts::connect) unless the base plate joins them
 * already. Lower resolutions of the best combination are tried, too, if their cells fit the mesh clearly better, as
 * those of a chessboard do with whole cells for each square. Models that fall but are more like the mesh than all that
 * stand are changed to stand (LegoSettings::Parts::support), unless the settings keep pieces apart. So are some if the
 * BuildingPlan of all that stand exceeds the limits, and the best one has at most DesignCandidate::MOST_PLANNED_PARTS
 * parts. docs/design.md has the comparison.
 *
 * Preconditions:
 * 1. No other thread changes the node during the call.
 * 2. Several threads may call DesignOptions::isCancelled at once.
 *
 * Usage:
 *
 *     osgLego::DesignOptions options;
 *     options.settings = "up=y";
 *     options.numParts = 300;
 *     std::string error;
 *     const std::optional<osgLego::ModelDesign> design = osgLego::designModel(*node, options, error);
 *     if (design) lego->setStoredBricks(design->getBest().model);
 *
 * Uses no GL. May be called from any thread, and by several at a time; uses all threads that oneTBB gives the caller,
 * and the result does not depend on their number.
 * @return nothing if it was cancelled, with an empty `error`; or with one sentence in `error` if the settings are bad
 * or give no parts, a value is out of range, or the node has no triangles that can be made of bricks.
 * @throws std::bad_alloc if there is not enough memory. */
OSGLEGO_EXPORT std::optional<ModelDesign> designModel(const osg::Node& node, const DesignOptions& options,
                                                      std::string& error);

} // namespace osgLego
