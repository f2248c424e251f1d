#include <osgLego/design/DesignSearch.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/PieceCount.h>
#include <osgLego/Stability.h>
#include <osgLego/design/ResolutionSearch.h>
#include <osgLego/model/CpuBricks.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <osg/BoundingBox>
#include <tbb/parallel_for.h>

namespace osgLego
{

namespace
{

constexpr double STUD_PITCH = 8.0; // millimetres
// Cells of the surface that models are compared to, along the longest side.
constexpr unsigned int REFERENCE_RESOLUTION = 256;
constexpr unsigned int FEW_COLORS = 8;
constexpr double SHARE_OF_MODELS = 0.6; // of the work; the rest is for support and plans
constexpr double SHARE_OF_PLANS = 0.2;

bool haveSameParts(const BrickModel& a, const BrickModel& b)
{
    return a.getGrid() == b.getGrid() && a.getParts() == b.getParts();
}

/** Settings of a model of parts whose others can be chosen. */
LegoSettings createFreeSettings()
{
    LegoSettings settings;
    settings.parts.set = PartSet::BRICKS;
    settings.parts.connect = true;
    settings.grid.proportions = Proportions::BRICK;
    return settings;
}

/** Replace the settings in a text. @return false, with a sentence in `error`, if they are bad. */
bool replace(const std::string& text, LegoSettings& settings, std::string& error)
{
    return text.empty() || LegoSettings::parse(text, settings, error);
}

} // namespace

DesignSearch::DesignSearch(const osg::Node& node, const DesignOptions& options) : _node(node), _options(options) {}

std::size_t DesignSearch::getMostParts() const
{
    return _options.numParts.value_or(DesignOptions::USUAL_PARTS);
}

DesignRanking DesignSearch::createRanking() const
{
    return DesignRanking(canChooseSize() ? std::numeric_limits<std::size_t>::max()
                                         : _options.numParts.value_or(std::numeric_limits<std::size_t>::max()));
}

/** Throws Failure if settings ask for no parts. */
void DesignSearch::checkParts() const
{
    LegoSettings settings = createFreeSettings();
    settings.parts.connect = false; // which needs parts
    std::string error;
    if (replace(_options.settings, settings, error) && settings.parts.set == PartSet::NONE)
        throw Failure("parts=none gives no parts; expected parts=bricks");
}

/** Whether settings determine the size of cells, so that nothing of it can be chosen. */
bool DesignSearch::determineSize() const
{
    const auto readWith = [&](unsigned int resolution)
    {
        LegoSettings settings = createFreeSettings();
        settings.grid.resolution = resolution;
        std::string error;
        if (!replace(_options.settings, settings, error)) throw Failure(error);
        return settings.grid;
    };
    return readWith(1) == readWith(2);
}

/** Whether settings determine that pieces are joined. */
bool DesignSearch::isConnectionGiven() const
{
    LegoSettings settings = createFreeSettings();
    settings.parts.connect = false;
    std::string error;
    return replace(_options.settings, settings, error) && settings.parts.connect;
}

ModelDesign DesignSearch::run()
{
    checkParts();
    _isSizeGiven = determineSize();
    if (_isSizeGiven && _options.length)
        throw Failure("a length can't be combined with a resolution or a cell; expected either");
    _isConnectionGiven = isConnectionGiven();
    const std::vector<LegoSettings> settings = listSettings();
    readSurface(settings.front().grid.upAxis);
    makeCandidates(settings);
    tryLowerResolutions();
    supportBetter();
    planBest();
    report(1.0);
    return {std::move(_candidates)};
}

std::vector<LegoSettings> DesignSearch::listSettings() const
{
    std::vector<LegoSettings> list;
    std::string error;
    for (const Proportions proportions : {Proportions::BRICK, Proportions::PLATE})
        for (const Fill fill : {Fill::SURFACE, Fill::SHELL, Fill::SOLID})
            for (const bool hasFewColors : {false, true})
            {
                LegoSettings settings = createFreeSettings();
                settings.grid.proportions = proportions;
                settings.parts.fill = fill;
                if (hasFewColors) settings.colors.count = FEW_COLORS;
                // Some settings that are kept exclude others, as that of no palette excludes few colours.
                const bool isPossible = replace(_options.settings, settings, error);
                if (isPossible && std::find(list.begin(), list.end(), settings) == list.end()) list.push_back(settings);
            }
    if (list.empty()) throw Failure(error);
    return list;
}

void DesignSearch::readSurface(UpAxis upAxis)
{
    _triangles = SceneTriangles::create(_node);
    _triangles->warnOfTexts(_node);
    if (_triangles->getNumTriangles() == 0)
        throw Failure("'" + _node.getName() + "' has no visible triangles to legolize");
    const osg::BoundingBoxd& bounds = _triangles->getBounds();
    _longestSide =
        std::max({bounds.xMax() - bounds.xMin(), bounds.yMax() - bounds.yMin(), bounds.zMax() - bounds.zMin()});
    LegoSettings settings;
    settings.grid.resolution = REFERENCE_RESOLUTION;
    settings.grid.upAxis = upAxis;
    _surface = std::make_unique<SurfaceReference>(*lay(settings).model);
}

DesignSearch::Laid DesignSearch::lay(const LegoSettings& settings) const
{
    checkCancelled();
    std::string error;
    const osg::ref_ptr<const LegoSource> source = createFirstSource(*_triangles, settings, error);
    if (!source) throw Failure(error);
    CpuBricksWork work;
    work.isCancelled = _options.isCancelled;
    Laid laid{settings, makeBricksOnCpu(*source, work), {}};
    checkCancelled();
    if (!laid.model) throw Failure(work.error);
    if (work.measureLayout) laid.layout = work.measureLayout();
    return laid;
}

/** Make a model, and join its pieces unless they stand on a base plate that joins them. */
DesignSearch::Laid DesignSearch::layJoined(const LegoSettings& settings) const
{
    if (_options.base == BuildingBase::PLATE && settings.parts.connect && !_isConnectionGiven)
    {
        LegoSettings apart = settings;
        apart.parts.connect = false;
        Laid laid = lay(apart);
        if (countPieces(*laid.model, _options.base) == 1) return laid;
    }
    return lay(settings);
}

std::size_t DesignSearch::countDraftParts(const LegoSettings& settings) const
{
    return lay(createDraftSettings(settings)).model->getParts().size();
}

unsigned int DesignSearch::findResolution(LegoSettings settings) const
{
    constexpr unsigned int FIRST_RESOLUTION = 24;
    ResolutionSearch search(getMostParts(), FIRST_RESOLUTION);
    while (const std::optional<unsigned int> resolution = search.getNext())
    {
        settings.grid.resolution = *resolution;
        search.add(*resolution, countDraftParts(settings));
    }
    return search.getBest();
}

DesignCandidate DesignSearch::makeLargest(LegoSettings settings) const
{
    if (_isSizeGiven) return measure(layJoined(settings));
    if (_options.length)
    {
        settings.grid.resolution = static_cast<unsigned int>(std::lround(*_options.length / STUD_PITCH));
        return measure(layJoined(settings));
    }
    settings.grid.resolution = findResolution(settings);
    ResolutionSearch search(getMostParts(), settings.grid.resolution);
    Laid best;
    while (const std::optional<unsigned int> resolution = search.getNext())
    {
        settings.grid.resolution = *resolution;
        const Laid laid = layJoined(settings);
        search.add(*resolution, laid.layout.numParts);
        if (search.getBest() == *resolution) best = laid;
    }
    return measure(best);
}

DesignCandidate DesignSearch::makeSupported(LegoSettings settings) const
{
    constexpr int MOST_TRIES = 3; // each is slow
    settings.parts.support = true;
    Laid laid = lay(settings);
    for (int tries = 1; canChooseSize() && tries < MOST_TRIES; ++tries)
    {
        if (laid.layout.numParts <= getMostParts() || settings.grid.resolution == 1) break;
        --settings.grid.resolution;
        laid = lay(settings);
    }
    return measure(laid);
}

DesignCandidate DesignSearch::measure(const Laid& laid) const
{
    if (laid.model->getParts().empty()) throw Failure("the grid misses the model; expected another origin or size");
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
void DesignSearch::setDifference(const BrickModel& model, DesignCandidate& candidate) const
{
    const SurfaceDifference difference = _surface->compare(model);
    candidate.surfaceError = difference.distance / _longestSide;
    candidate.colorError = difference.color;
}

void DesignSearch::makeCandidates(const std::vector<LegoSettings>& settings)
{
    std::vector<DesignCandidate> made(settings.size());
    tbb::parallel_for(std::size_t(0), settings.size(),
                      [&](std::size_t index)
                      {
                          made[index] = makeLargest(settings[index]);
                          report(SHARE_OF_MODELS / static_cast<double>(settings.size()));
                      });
    for (DesignCandidate& candidate : made)
        addCandidate(std::move(candidate));
}

void DesignSearch::addCandidate(DesignCandidate candidate)
{
    const auto isSame = [&](const DesignCandidate& other) { return haveSameParts(*other.model, *candidate.model); };
    if (std::any_of(_candidates.begin(), _candidates.end(), isSame)) return;
    const auto isBetter = [ranking = createRanking()](const DesignCandidate& a, const DesignCandidate& b)
    { return ranking.isBetter(a, b); };
    const auto place = std::upper_bound(_candidates.begin(), _candidates.end(), candidate, isBetter);
    _candidates.insert(place, std::move(candidate));
}

/** Make the best model again with the lower resolution whose cells fit the mesh best, if they fit it clearly better.
 * The highest resolution is not always the best one: it may leave thin cells at the borders of colours and shapes that
 * others fill. */
void DesignSearch::tryLowerResolutions()
{
    constexpr double LOWEST = 0.7;
    constexpr unsigned int MOST_TRIED = 12;
    constexpr double CLEARLY = 0.9;
    if (!canChooseSize()) return;
    LegoSettings settings = _candidates.front().settings;
    const unsigned int highest = settings.grid.resolution;
    const auto lowest = static_cast<unsigned int>(std::ceil(LOWEST * highest));
    const unsigned int stride = std::max(1u, (highest - lowest + MOST_TRIED - 1) / MOST_TRIED);
    std::vector<unsigned int> resolutions;
    for (unsigned int resolution = highest; resolution >= std::max(lowest, 1u); resolution -= stride)
    {
        resolutions.push_back(resolution);
        if (resolution <= stride) break;
    }
    std::vector<double> errors(resolutions.size());
    tbb::parallel_for(std::size_t(0), errors.size(),
                      [&](std::size_t index) { errors[index] = measureDraft(settings, resolutions[index]); });
    const auto best = std::min_element(errors.begin(), errors.end());
    if (*best > CLEARLY * errors.front()) return;
    settings.grid.resolution = resolutions[static_cast<std::size_t>(best - errors.begin())];
    addCandidate(measure(layJoined(settings)));
}

/** The unlikeness of a draft. */
double DesignSearch::measureDraft(LegoSettings settings, unsigned int resolution) const
{
    settings.grid.resolution = resolution;
    const Laid laid = lay(createDraftSettings(settings));
    if (laid.model->getBricks().empty()) return std::numeric_limits<double>::max();
    DesignCandidate draft;
    setDifference(*laid.model, draft);
    return draft.getError();
}

void DesignSearch::supportBetter()
{
    constexpr std::size_t AT_ONCE = 2; // each takes longer than all other work
    constexpr std::size_t MOST_SUPPORTED = 6;
    std::vector<LegoSettings> falling;
    for (const DesignCandidate* candidate : DesignRanking::listFallingBetter(_candidates))
        falling.push_back(candidate->settings);
    falling.resize(std::min(falling.size(), MOST_SUPPORTED));
    for (std::size_t first = 0; first < falling.size(); first += AT_ONCE)
    {
        std::vector<DesignCandidate> made(std::min(AT_ONCE, falling.size() - first));
        tbb::parallel_for(std::size_t(0), made.size(),
                          [&](std::size_t index) { made[index] = makeSupported(falling[first + index]); });
        for (DesignCandidate& candidate : made)
            addCandidate(std::move(candidate));
        report((1.0 - SHARE_OF_MODELS - SHARE_OF_PLANS) * static_cast<double>(AT_ONCE) /
               static_cast<double>(MOST_SUPPORTED));
        if (DesignRanking::standsSafely(_candidates.front())) return;
    }
}

/** Plan how the best model is built. While submodels exceed the limits, support the model, which may change that, and
 * go on with the next one that stands as well. */
void DesignSearch::planBest()
{
    const double share = SHARE_OF_PLANS / static_cast<double>(_candidates.size());
    while (!_candidates.front().plan && _candidates.front().isSound() &&
           _candidates.front().layout.numParts <= DesignCandidate::MOST_PLANNED_PARTS)
    {
        DesignCandidate candidate = std::move(_candidates.front());
        _candidates.erase(_candidates.begin());
        planBuildingOf(candidate);
        if (candidate.exceedsLimits() && !candidate.settings.parts.support)
        {
            DesignCandidate supported = makeSupported(candidate.settings);
            planBuildingOf(supported);
            // If both exceed the limits, the one that is more like the mesh would be better.
            const bool isHelped = supported.exceedsLimits() && supported.isSound() &&
                                  DesignRanking::rankStability(supported.stability) <=
                                      DesignRanking::rankStability(candidate.stability) &&
                                  supported.plan->exceedsLimitsLessThan(*candidate.plan);
            if (isHelped) candidate = supported;
            addCandidate(std::move(supported));
        }
        addCandidate(std::move(candidate));
        report(share);
    }
}

void DesignSearch::planBuildingOf(DesignCandidate& candidate) const
{
    PlanningOptions options;
    options.base = _options.base;
    options.view = _options.view;
    options.isCancelled = _options.isCancelled;
    candidate.plan = planBuilding(*candidate.model, options);
    checkCancelled();
}

void DesignSearch::checkCancelled() const
{
    if (_options.isCancelled && _options.isCancelled()) throw Failure("");
}

void DesignSearch::report(double share)
{
    if (!_options.progress) return;
    const std::lock_guard lock(_reporting);
    _progress = std::min(1.0, _progress + share);
    _options.progress(_progress);
}

} // namespace osgLego
