#include <osgLego/model/CpuBricks.h>

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/flattening/KeptLattice.h>

#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <osg/Timer>

namespace osgLego
{

namespace
{

/** The cells of an earlier layout, if the settings are the same and the grid is one of a lattice, which may begin
 * elsewhere. A grid that is fitted to the source has other cells whenever its extent changes. */
std::optional<PreviousCells> findPreviousCells(const PreviousLayout* previous, const LegoSource& source)
{
    if (!previous || !previous->cells || !source.settings.grid.cellPitch) return std::nullopt;
    if (!previous->settings.givesSameBricks(source.settings)) return std::nullopt;
    const BrickGrid& grid = source.triangles->getGrid();
    return PreviousCells(*previous->cells,
                         glm::ivec3(glm::round((grid.origin - previous->grid.origin) / grid.cellSize)));
}

const PreviousLayout* getShown(const CpuBricksWork& work)
{
    return work.shown ? work.shown : work.previous;
}

/** Lay parts with little effort, and show them. */
void showDraft(const LegoSource& source, const BrickModel& cells, CpuBricksWork& work)
{
    const LegoSettings settings = createDraftSettings(source.settings);
    PreviousLayout layout;
    // Its parts may have been laid with more effort.
    const PreviousLayout* const shown = getShown(work);
    if (shown && shown->settings.givesSameBricks(source.settings)) layout = *shown;
    layout.settings = settings;
    ModelBuilder builder(settings, source.lookup);
    builder.setCancellation(work.isCancelled);
    builder.setPrevious(layout);
    builder.setGreedy(work.isDraftGreedy);
    const osg::ref_ptr<const BrickModel> draft = builder.build(cells);
    if (!draft) return;
    work.measureLayout = builder.getMeasurement();
    layout.settings = source.settings;
    layout.cells = &cells;
    work.showDraft(*draft, std::move(layout));
}

} // namespace

LegoSettings createDraftSettings(LegoSettings settings)
{
    settings.parts.effort = Effort::INSTANT;
    settings.parts.connect = false;
    settings.parts.support = false;
    return settings;
}

osg::ref_ptr<const LegoSource> createFirstSource(const SceneTriangles& triangles, const LegoSettings& settings,
                                                 std::string& error)
{
    const LegoSettings applied = KeptLattice().apply(triangles.getBounds(), settings);
    error = BrickGrid::findObstacle(triangles.getBounds(), applied);
    return error.empty() ? LegoSource::create(triangles, applied, error) : nullptr;
}

osg::ref_ptr<const BrickModel> makeBricksOnCpu(const LegoSource& source, CpuBricksWork& work)
{
    const osg::Timer_t start = osg::Timer::instance()->tick();
    const std::optional<PreviousCells> previous = findPreviousCells(getShown(work), source);
    const osg::ref_ptr<const BrickModel> cells =
        voxelizeOnCpu(*source.triangles, source.lookup.hasPalette() ? CellColor::DOMINANT : CellColor::MEAN,
                      previous ? &*previous : nullptr);
    if (work.isCancelled && work.isCancelled()) return nullptr;
    work.statistics = {};
    work.statistics.isFromCpu = true;
    work.statistics.numTriangles = source.triangles->getNumTriangles();
    work.statistics.flattening = source.flattening;
    work.statistics.voxelization = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());

    if (work.showDraft) showDraft(source, *cells, work);
    ModelBuilder builder(source.settings, source.lookup);
    builder.setCancellation(work.isCancelled);
    builder.setProgress(work.progress);
    if (work.previous) builder.setPrevious(*work.previous);
    osg::ref_ptr<const BrickModel> bricks = builder.build(*cells);
    work.error = builder.getError();
    work.warning = builder.getWarning();
    work.measureLayout = builder.getMeasurement();
    if (bricks && work.previous)
    {
        work.previous->settings = source.settings;
        work.previous->grid = source.triangles->getGrid();
        work.previous->cells = cells;
    }
    return bricks;
}

} // namespace osgLego
