#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LayoutStatistics.h>
#include <osgLego/LegoProgress.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/layout/CellFill.h>
#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/palette/PaletteLookup.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** A layout that the next one of the same source may resemble, if the settings are the same. Without parts, only the
 * settings, the grid and the cells are set. */
struct PreviousLayout
{
    LegoSettings settings;
    LaidParts parts;
    std::vector<PaletteColor> colors; //!< those of the parts
    BrickGrid grid;
    osg::ref_ptr<const BrickModel> cells; //!< in the colours of the surface
};

/** Turns the covered cells of a mesh into bricks by the settings: looks up their colours in a palette,
 * fills the interior, and lays parts.
 *
 * Usage:
 *
 *     ModelBuilder builder(settings, PaletteLookup(palette));
 *     const osg::ref_ptr<const BrickModel> model = builder.build(*cells);
 *     if (!model) ... // builder.getError(), or cancelled
 *
 * Uses no GL, and all threads that oneTBB gives the caller. One thread at a time.
 */
class ModelBuilder
{
public:
    /** @param lookup the colours that bricks may have. */
    ModelBuilder(const LegoSettings& settings, const PaletteLookup& lookup);

    /** Let a function end build() early by returning true; it is called from any thread. */
    void setCancellation(std::function<bool()> isCancelled) { _isCancelled = std::move(isCancelled); }
    /** Let a function be called with the stages of build(), from LegoProgress::Stage::PARTS on, in its thread. */
    void setProgress(std::function<void(const LegoProgress&)> progress) { _progress = std::move(progress); }
    /** Keep parts of an earlier layout where the cells have not changed; the result, apart from the cells, is left here
     * for the next one. */
    void setPrevious(PreviousLayout& previous) { _previous = &previous; }

    /** Lay parts greedily, without a search for better ones. */
    void setGreedy(bool isGreedy) { _isGreedy = isGreedy; }

    /** Build the bricks of covered cells.
     * @return `cells` if there is nothing to do; null if it was cancelled, or with a sentence in getError() if there
     * would be too many cells. @throws std::bad_alloc if there is not enough memory. */
    osg::ref_ptr<const BrickModel> build(const BrickModel& cells);

    const std::string& getError() const { return _error; }
    /** A sentence on a setting that had no effect in the last build(); empty if all had. */
    const std::string& getWarning() const { return _warning; }
    /** Computes the figures of the parts that the last build() has laid, which takes longer than laying them with
     * Effort::INSTANT; empty without parts. May be kept, and called from any thread. */
    const std::function<LayoutStatistics()>& getMeasurement() const { return _measureLayout; }

private:
    bool isCancelled() const { return _isCancelled && _isCancelled(); }
    std::function<void(double)> reportStage(LegoProgress::Stage stage) const;
    osg::ref_ptr<const BrickModel> lay(const FilledCells& cells, const BrickModel& surface,
                                       LayoutStatistics& statistics);

    LegoSettings _settings;
    PaletteLookup _lookup;
    std::function<bool()> _isCancelled;
    std::function<void(const LegoProgress&)> _progress;
    PreviousLayout* _previous = nullptr;
    bool _isGreedy = false;
    std::string _error;
    std::string _warning;
    std::function<LayoutStatistics()> _measureLayout;
};

} // namespace osgLego
