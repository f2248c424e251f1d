#include <osgLego/design/DesignMaker.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/PieceCount.h>
#include <osgLego/Stability.h>
#include <osgLego/design/DesignFailure.h>
#include <osgLego/model/CpuBricks.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <osg/BoundingBox>

namespace osgLego
{

DesignMaker::DesignMaker(const osg::Node& node, const DesignOptions& options, UpAxis upAxis) :
    _options(options), _triangles(SceneTriangles::create(node))
{
    // Cells of the surface that models are compared to, along the longest side.
    constexpr unsigned int REFERENCE_RESOLUTION = 256;
    _triangles->warnOfTexts(node);
    if (_triangles->getNumTriangles() == 0)
        throw DesignFailure("'" + node.getName() + "' has no visible triangles to legolize");
    const osg::BoundingBoxd& bounds = _triangles->getBounds();
    _longestSide =
        std::max({bounds.xMax() - bounds.xMin(), bounds.yMax() - bounds.yMin(), bounds.zMax() - bounds.zMin()});
    LegoSettings settings;
    settings.grid.resolution = REFERENCE_RESOLUTION;
    settings.grid.upAxis = upAxis;
    _surface = std::make_unique<SurfaceReference>(*lay(settings).model);
}

DesignMaker::Laid DesignMaker::lay(const LegoSettings& settings,
                                   const std::function<void(const LegoProgress&)>& progress) const
{
    checkCancelled();
    std::string error;
    const osg::ref_ptr<const LegoSource> source = createFirstSource(*_triangles, settings, error);
    if (!source) throw DesignFailure(error);
    CpuBricksWork work;
    work.isCancelled = _options.isCancelled;
    work.progress = progress;
    Laid laid{settings, makeBricksOnCpu(*source, work), {}};
    checkCancelled();
    if (!laid.model) throw DesignFailure(work.error);
    if (work.measureLayout) laid.layout = work.measureLayout();
    return laid;
}

osg::ref_ptr<const BrickModel> DesignMaker::layDraft(const LegoSettings& settings) const
{
    return lay(createDraftSettings(settings)).model;
}

double DesignMaker::computeError(const BrickModel& model) const
{
    if (model.getBricks().empty()) return std::numeric_limits<double>::max();
    DesignCandidate measured;
    setDifference(model, measured);
    return measured.getError();
}

DesignCandidate DesignMaker::measure(const Laid& laid) const
{
    if (laid.model->getParts().empty())
        throw DesignFailure("the grid misses the model; expected another origin or size");
    std::optional<StabilityReport> stability = computeStability(*laid.model, {_options.base, _options.isCancelled});
    checkCancelled();
    DesignCandidate candidate;
    candidate.settings = laid.settings;
    candidate.model = laid.model;
    candidate.layout = laid.layout;
    candidate.stability = std::move(*stability);
    candidate.numPieces = countPieces(*laid.model, _options.base);
    setDifference(*laid.model, candidate);
    return candidate;
}

/** Set the errors of a candidate to those of a model. */
void DesignMaker::setDifference(const BrickModel& model, DesignCandidate& candidate) const
{
    const SurfaceDifference difference = _surface->compare(model);
    candidate.surfaceError = difference.distance / _longestSide;
    candidate.colorError = difference.color;
    candidate.lostSurface = difference.lost;
}

void DesignMaker::planBuildingOf(DesignCandidate& candidate) const
{
    PlanningOptions options;
    options.base = _options.base;
    options.view = _options.view;
    options.isCancelled = _options.isCancelled;
    candidate.plan = planBuilding(*candidate.model, options);
    checkCancelled();
}

void DesignMaker::checkCancelled() const
{
    if (_options.isCancelled && _options.isCancelled()) throw DesignFailure("");
}

} // namespace osgLego
