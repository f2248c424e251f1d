#include <osgLego/design/DesignSearch.h>

#include <osgLego/PieceCount.h>
#include <osgLego/design/ResolutionSearch.h>
#include <osgLego/model/CpuBricks.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include <tbb/parallel_for.h>

namespace osgLego
{

namespace
{

constexpr double ANY_ERROR = std::numeric_limits<double>::infinity();
// Of the work; the rest is for support.
constexpr double SHARE_OF_DRAFTS = 0.1;
constexpr double SHARE_OF_MODELS = 0.5;
constexpr double SHARE_OF_PLANS = 0.2;

/** The progress of making a supported model in one or more tries, each a part of the whole. */
class SupportProgress
{
public:
    /** @param report is called with the shares of the work, 0 to 1, that have been done since the last call. */
    explicit SupportProgress(std::function<void(double)> report) : _report(std::move(report)) {}

    void operator()(const LegoProgress& progress)
    {
        if (progress.stage == LegoProgress::Stage::SUPPORT) // others take hardly any time
            reportUpTo(std::lerp(_first, _last, static_cast<double>(progress.fraction)));
    }

    void beginNextTry()
    {
        _first = _last;
        _last = 0.5 * (1.0 + _last);
    }

    void end() { reportUpTo(1.0); }

private:
    void reportUpTo(double done)
    {
        if (done <= _reported) return;
        _report(done - _reported);
        _reported = done;
    }

    std::function<void(double)> _report;
    double _first = 0.0;
    double _last = 0.7; // of the first try; others have fewer parts
    double _reported = 0.0;
};

bool haveSameParts(const BrickModel& a, const BrickModel& b)
{
    return a.getGrid() == b.getGrid() && a.getParts() == b.getParts();
}

} // namespace

DesignSearch::DesignSearch(const osg::Node& node, const DesignOptions& options) :
    _options(options), _settings(options), _maker(node, options, _settings.getAll().front().grid.upAxis)
{
}

/** The number of parts that models should not exceed; unset if the options give a size and no number. */
std::optional<std::size_t> DesignSearch::getMostParts() const
{
    return _options.numParts || !_settings.canChooseSize() ? _options.numParts : DesignOptions::USUAL_PARTS;
}

DesignRanking DesignSearch::createRanking() const
{
    return DesignRanking(getMostParts().value_or(std::numeric_limits<std::size_t>::max()));
}

ModelDesign DesignSearch::run()
{
    makeBetter(makeDrafts(_settings.getAll()));
    tryLowerResolutions();
    supportBetter();
    planBest();
    report(1.0);
    return {std::move(_candidates), _others.size(), getMostParts()};
}

/** Make a model, and join its pieces unless they stand on a base plate that joins them. */
DesignMaker::Laid DesignSearch::layJoined(const LegoSettings& settings) const
{
    if (_options.base == BuildingBase::PLATE && settings.parts.connect && !_settings.isConnectionGiven())
    {
        LegoSettings apart = settings;
        apart.parts.connect = false;
        Laid laid = _maker.lay(apart);
        if (countPieces(*laid.model, _options.base) == 1) return laid;
    }
    return _maker.lay(settings);
}

/** A draft of a model by some settings, of the size that is given, or of the highest resolution that has few enough
 * parts. */
DesignSearch::Draft DesignSearch::makeDraft(LegoSettings settings) const
{
    constexpr unsigned int FIRST_RESOLUTION = 24;
    if (!_settings.canChooseSize())
    {
        const osg::ref_ptr<const BrickModel> model = _maker.layDraft(settings);
        return {settings, model, nullptr, _maker.computeError(*model)};
    }
    std::map<unsigned int, osg::ref_ptr<const BrickModel>> models;
    const auto layWith = [&](unsigned int resolution)
    {
        osg::ref_ptr<const BrickModel>& model = models[resolution];
        settings.grid.resolution = resolution;
        if (!model) model = _maker.layDraft(settings);
        return model;
    };
    ResolutionSearch search(*getMostParts(), FIRST_RESOLUTION);
    while (const std::optional<unsigned int> resolution = search.getNext())
        search.add(*resolution, layWith(*resolution)->getParts().size());
    const unsigned int best = search.getBest();
    // The final model has fewer parts, and often the next resolution.
    const osg::ref_ptr<const BrickModel> larger = layWith(std::min(best + 1, LegoSettings::MAXIMUM_RESOLUTION));
    const osg::ref_ptr<const BrickModel> model = layWith(best);
    return {settings, model, larger, std::min(_maker.computeError(*model), _maker.computeError(*larger))};
}

/** @param settings with the resolution of their draft. */
DesignCandidate DesignSearch::makeLargest(LegoSettings settings) const
{
    if (!_settings.canChooseSize()) return _maker.measure(layJoined(settings));
    ResolutionSearch search(*getMostParts(), settings.grid.resolution);
    Laid best;
    while (const std::optional<unsigned int> resolution = search.getNext())
    {
        settings.grid.resolution = *resolution;
        const Laid laid = layJoined(settings);
        search.add(*resolution, laid.layout.numParts);
        if (search.getBest() == *resolution) best = laid;
    }
    return _maker.measure(best);
}

/** @param settings of a model without support. @param share of the work. */
DesignCandidate DesignSearch::makeSupported(LegoSettings settings, double share)
{
    constexpr int MOST_TRIES = 3; // each is slow
    constexpr double USUAL_SHARE = 0.95;
    settings.parts.support = true;
    SupportProgress progress([&](double done) { report(share * done); });
    Laid laid = _maker.lay(settings, std::ref(progress));
    for (int tries = 1; _settings.canChooseSize() && tries < MOST_TRIES; ++tries)
    {
        const std::size_t mostParts = *getMostParts();
        if (laid.layout.numParts <= mostParts || settings.grid.resolution == 1) break;
        // The number of parts grows about with the square of the resolution, and that of columns varies.
        const double scale =
            std::sqrt(USUAL_SHARE * static_cast<double>(mostParts) / static_cast<double>(laid.layout.numParts));
        settings.grid.resolution =
            std::clamp(static_cast<unsigned int>(scale * settings.grid.resolution), 1u, settings.grid.resolution - 1);
        progress.beginNextTry();
        laid = _maker.lay(settings, std::ref(progress));
    }
    DesignCandidate candidate = _maker.measure(laid);
    progress.end();
    return candidate;
}

/** Drafts by all settings that give different ones, those most like the mesh first. */
std::vector<DesignSearch::Draft> DesignSearch::makeDrafts(const std::vector<LegoSettings>& settings)
{
    std::vector<Draft> made(settings.size());
    tbb::parallel_for(std::size_t(0), made.size(),
                      [&](std::size_t index)
                      {
                          made[index] = makeDraft(settings[index]);
                          report(SHARE_OF_DRAFTS / static_cast<double>(made.size()));
                      });
    const auto areSame = [](const Draft& a, const Draft& b)
    { return haveSameParts(*a.model, *b.model) && (!a.larger || haveSameParts(*a.larger, *b.larger)); };
    std::vector<Draft> drafts;
    for (Draft& draft : made)
        if (std::none_of(drafts.begin(), drafts.end(), [&](const Draft& other) { return areSame(draft, other); }))
            drafts.push_back(std::move(draft));
    std::stable_sort(drafts.begin(), drafts.end(), [](const Draft& a, const Draft& b) { return a.error < b.error; });
    return drafts;
}

/** Make the models whose drafts are not clearly less like the mesh than the best one, and all others if none of these
 * is good enough. */
void DesignSearch::makeBetter(const std::vector<Draft>& drafts)
{
    constexpr double CLEARLY = 1.05; // models differ by as much from their drafts
    std::vector<LegoSettings> better;
    for (const Draft& draft : drafts)
    {
        if (draft.error <= CLEARLY * drafts.front().error)
            better.push_back(draft.settings);
        else
            _others.push_back(draft);
    }
    const double share = SHARE_OF_MODELS / static_cast<double>(drafts.size());
    makeCandidates(better, share);
    const DesignCandidate& best = _candidates.front();
    if (best.isWhole() && DesignRanking::standsSafely(best) && createRanking().hasFewEnoughParts(best))
        report(share * static_cast<double>(_others.size()));
    else
        makeOthers(share, ANY_ERROR);
}

/** Make the models of settings whose drafts were clearly less like the mesh than the best one.
 * @param share of the work for each. @param mostError of the drafts. @return whether there are any. */
bool DesignSearch::makeOthers(double share, double mostError)
{
    std::vector<LegoSettings> settings;
    for (const Draft& draft : _others)
        if (draft.error <= mostError) settings.push_back(draft.settings);
    std::erase_if(_others, [mostError](const Draft& draft) { return draft.error <= mostError; });
    makeCandidates(settings, share);
    return !settings.empty();
}

void DesignSearch::makeCandidates(const std::vector<LegoSettings>& settings, double share)
{
    std::vector<DesignCandidate> made(settings.size());
    tbb::parallel_for(std::size_t(0), settings.size(),
                      [&](std::size_t index)
                      {
                          made[index] = makeLargest(settings[index]);
                          report(share);
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
    // Every number of squares along a chessboard has a multiple between half the resolution and all of it.
    constexpr double LOWEST = 0.5;
    constexpr unsigned int MOST_TRIED = 24;
    constexpr double CLEARLY = 0.95;
    if (!_settings.canChooseSize()) return;
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
                      [&](std::size_t index)
                      {
                          LegoSettings lower = settings;
                          lower.grid.resolution = resolutions[index];
                          errors[index] = _maker.computeError(*_maker.layDraft(lower));
                      });
    const auto best = std::min_element(errors.begin(), errors.end());
    if (*best > CLEARLY * errors.front()) return;
    settings.grid.resolution = resolutions[static_cast<std::size_t>(best - errors.begin())];
    addCandidate(_maker.measure(layJoined(settings)));
}

void DesignSearch::supportBetter()
{
    constexpr std::size_t AT_ONCE = 2; // each takes longer than all other work
    constexpr std::size_t MOST_SUPPORTED = 6;
    if (!_settings.canJoin()) return;
    std::vector<LegoSettings> falling;
    for (const DesignCandidate* candidate : DesignRanking::listFallingBetter(_candidates))
        falling.push_back(candidate->settings);
    falling.resize(std::min(falling.size(), MOST_SUPPORTED));
    for (std::size_t first = 0; first < falling.size(); first += AT_ONCE)
    {
        constexpr double SHARE = (1.0 - SHARE_OF_DRAFTS - SHARE_OF_MODELS - SHARE_OF_PLANS) / MOST_SUPPORTED;
        std::vector<DesignCandidate> made(std::min(AT_ONCE, falling.size() - first));
        tbb::parallel_for(std::size_t(0), made.size(),
                          [&](std::size_t index) { made[index] = makeSupported(falling[first + index], SHARE); });
        _supported.insert(_supported.end(), falling.begin() + static_cast<std::ptrdiff_t>(first),
                          falling.begin() + static_cast<std::ptrdiff_t>(first + made.size()));
        for (DesignCandidate& candidate : made)
            addCandidate(std::move(candidate));
        if (DesignRanking::standsSafely(_candidates.front())) return;
    }
}

/** Choose a model that is easy to build. Models are supported only if none is so without, or if they are far more like
 * the mesh than that: columns often are in plain view. */
void DesignSearch::planBest()
{
    constexpr double SHARE_OF_FIRST = 0.5 * SHARE_OF_PLANS;
    planBetter(SHARE_OF_FIRST);
    if (!_candidates.front().isSound()) return;
    // The share of the others is reported.
    if (makeOthers(0.0, _candidates.front().exceedsLimits() ? ANY_ERROR : _candidates.front().getError()))
        planBetter(0.0);
    if (_candidates.front().plan && _settings.canJoin()) supportHard(SHARE_OF_PLANS - SHARE_OF_FIRST);
}

/** Plan how the best model is built, and if that exceeds the limits the next one, until the best one keeps them.
 * @param share of the work. */
void DesignSearch::planBetter(double share)
{
    share /= static_cast<double>(_candidates.size());
    while (!_candidates.front().plan && _candidates.front().isSound() &&
           _candidates.front().layout.numParts <= DesignCandidate::MOST_PLANNED_PARTS)
    {
        DesignCandidate candidate = std::move(_candidates.front());
        _candidates.erase(_candidates.begin());
        _maker.planBuildingOf(candidate);
        addCandidate(std::move(candidate));
        report(share);
    }
}

/** Support models that are hard to build, or that fall, until the best one is easy to build; and then one more if it is
 * far more like the mesh than that.
 * @param share of the work. */
void DesignSearch::supportHard(double share)
{
    constexpr double FAR = 0.6;
    constexpr std::size_t MOST_TRIED = 4; // each is slow
    std::vector<LegoSettings> hard = DesignRanking::listHard(_candidates);
    std::erase_if(hard, [this](const LegoSettings& settings)
                  { return std::find(_supported.begin(), _supported.end(), settings) != _supported.end(); });
    hard.resize(std::min(hard.size(), MOST_TRIED));
    bool hasOneMore = true;
    for (const LegoSettings& settings : hard)
    {
        const DesignCandidate& best = _candidates.front();
        const bool isEasy = best.isSound() && !best.exceedsLimits();
        const auto candidate = std::find_if(_candidates.begin(), _candidates.end(),
                                            [&](const DesignCandidate& other) { return other.settings == settings; });
        if (isEasy && candidate->getError() > FAR * best.getError()) continue;
        if (isEasy && !std::exchange(hasOneMore, false)) break;
        supportCandidate(static_cast<std::size_t>(candidate - _candidates.begin()),
                         share / static_cast<double>(hard.size()));
        planBetter(0.0);
    }
}

/** Make a candidate again with support, for a share of the work, and plan how that is built. If both exceed the limits
 * and support helps, only the supported model remains, since the other one is more like the mesh and would come first.
 */
void DesignSearch::supportCandidate(std::size_t index, double share)
{
    const DesignCandidate& candidate = _candidates[index];
    const DesignRanking ranking = createRanking();
    DesignCandidate supported = makeSupported(candidate.settings, share);
    if (supported.isSound() && supported.layout.numParts <= DesignCandidate::MOST_PLANNED_PARTS)
        _maker.planBuildingOf(supported);
    const bool isHelped =
        supported.exceedsLimits() && supported.plan && candidate.plan &&
        DesignRanking::rankStability(supported.stability) <= DesignRanking::rankStability(candidate.stability) &&
        (ranking.hasFewEnoughParts(supported) || !ranking.hasFewEnoughParts(candidate)) &&
        supported.plan->exceedsLimitsLessThan(*candidate.plan);
    if (isHelped) _candidates.erase(_candidates.begin() + static_cast<std::ptrdiff_t>(index));
    addCandidate(std::move(supported));
}

void DesignSearch::report(double share)
{
    if (!_options.progress) return;
    const std::lock_guard lock(_reporting);
    _progress = std::min(1.0, _progress + share);
    _options.progress(_progress);
}

} // namespace osgLego
