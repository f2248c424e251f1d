#include "StepFrames.h"

#include "HiddenParts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr double LARGEST_STEP_WIDTH = 1200;  // pixels
constexpr double LARGEST_STEP_HEIGHT = 1050; // pixels
constexpr double LARGEST_STEP_PITCH = 90;    // pixels; larger bricks would look odd beside those of the parts lists
constexpr double STEP_MARGIN = 0.15;         // pitches around a model, for outlines and rounding
constexpr double ARROW_WIDTH = 0.45;         // pitches, of the shafts of arrows
constexpr double ARROW_SHARE = 1.0 / 90;     // likewise, at least, of the width of the picture: for readable letters

/** The parts that a step puts in place, those of submodels included. */
std::span<const std::uint32_t> getNewParts(const BookletChapter& chapter, const BookletStep& step)
{
    return std::span(chapter.plan->getOrder()).first(step.numPlaced).last(step.numNew);
}

} // namespace

StepFrames::StepFrames(const BookletModel& model, const BrickModel* plate, const BuildingView& front) :
    _model(model), _plate(plate), _front(front), _cuts(model.getChapters().size())
{
    for (std::size_t chapter = 0; chapter < model.getChapters().size(); ++chapter)
    {
        Steps steps(model.getChapters()[chapter].steps.size());
        std::iota(steps.begin(), steps.end(), std::size_t{0});
        _scalesOfChapters.push_back(findScale(chapter, steps));
    }
    _scales = _scalesOfChapters;
}

void StepFrames::setSection(std::size_t chapter, std::span<const BookletBlock> blocks)
{
    std::fill(_cuts.begin(), _cuts.end(), Cuts());
    _scales = _scalesOfChapters;
    Steps steps;
    for (const BookletBlock& block : blocks)
        if (block.chapter == chapter && !block.isContents) steps.push_back(block.step);
    if (steps.empty()) return;
    _cuts[chapter] = findCuts(chapter, steps);
    _scales[chapter] = findScale(chapter, steps);
    // Pictures have no more pixels than without a section.
    const Scale& whole = _scalesOfChapters[chapter];
    double& pixels = _scales[chapter].pixels;
    pixels = std::min(pixels, whole.pixels * std::sqrt(whole.size.y / _scales[chapter].size.y));
}

bool StepFrames::isOnPlate(const BookletChapter& chapter) const
{
    return _plate && &chapter == &_model.getMainChapter();
}

BookletCamera StepFrames::createCamera(const BookletChapter& chapter, const BookletStep& step) const
{
    return {chapter.model->getGrid(), {step.turns, step.isUpsideDown, _front}};
}

BookletFrame StepFrames::findWhole(const BookletChapter& chapter, const BookletCamera& camera) const
{
    const BookletFrame frame = camera.findFrame(*chapter.model);
    return isOnPlate(chapter) ? frame.unite(camera.findFrame(*_plate)) : frame;
}

/** The part of the picture with the parts in place: as wide as the finished model, so that the model stays where it is
 * from step to step. */
BookletFrame StepFrames::findPlaced(const BookletChapter& chapter, const BookletStep& step,
                                    const BookletCamera& camera) const
{
    std::vector<Part> placed;
    for (std::size_t rank = 0; rank < step.numPlaced; ++rank)
        placed.push_back(chapter.model->getParts()[chapter.plan->getOrder()[rank]]);
    const BookletFrame whole = findWhole(chapter, camera);
    BookletFrame frame = camera.findFrame(placed);
    if (isOnPlate(chapter)) frame = frame.unite(camera.findFrame(*_plate));
    frame.lowest.x = whole.lowest.x;
    frame.highest.x = whole.highest.x;
    return frame;
}

/** The parts in place and the arrows of a step, with the model in the middle. */
BookletFrame StepFrames::findUncut(std::size_t chapter, std::size_t step) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletFrame placed = findPlaced(own, own.steps[step], createCamera(own, own.steps[step]));
    const std::optional<BookletFrame>& arrows = findArrows(chapter, step).getFrame();
    if (!arrows) return placed.addMargin(STEP_MARGIN);
    BookletFrame frame = placed.unite(*arrows);
    const double beside = std::max(placed.lowest.x - frame.lowest.x, frame.highest.x - placed.highest.x);
    frame.lowest.x = placed.lowest.x - beside;
    frame.highest.x = placed.highest.x + beside;
    return frame.addMargin(STEP_MARGIN);
}

BookletFrame StepFrames::findCut(std::size_t chapter, std::size_t step, const Cuts& cuts) const
{
    BookletFrame frame = findUncut(chapter, step);
    const auto cut = cuts.find(getView(_model.getChapters()[chapter].steps[step]));
    if (cut != cuts.end()) frame.lowest.y = std::max(frame.lowest.y, std::min(cut->second, findLowest(chapter, step)));
    return frame;
}

BookletFrame StepFrames::findFrame(std::size_t chapter, std::size_t step) const
{
    BookletFrame frame = findCut(chapter, step, _cuts[chapter]);
    const double beside = 0.5 * (_scales[chapter].size.x - frame.getSize().x);
    frame.lowest.x -= beside;
    frame.highest.x += beside;
    return frame;
}

bool StepFrames::isCut(std::size_t chapter, std::size_t step) const
{
    return findFrame(chapter, step).lowest.y > findUncut(chapter, step).lowest.y;
}

/** Where to cut the pictures of some steps; nowhere if that does not make them much lower. */
StepFrames::Cuts StepFrames::findCuts(std::size_t chapter, const Steps& steps) const
{
    constexpr double MOST_SHARE = 0.8; // of the height of the pictures
    const BookletChapter& own = _model.getChapters()[chapter];
    std::map<View, std::vector<double>> lowest;
    for (const std::size_t step : steps)
        lowest[getView(own.steps[step])].push_back(findLowest(chapter, step));
    // Few steps that add something far below do not lower the cuts of all others.
    Cuts cuts;
    for (auto& [view, heights] : lowest)
    {
        const auto quarter = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 4);
        std::nth_element(heights.begin(), quarter, heights.end());
        cuts[view] = *quarter;
    }
    return sumHeights(chapter, steps, cuts) <= MOST_SHARE * sumHeights(chapter, steps, {}) ? cuts : Cuts();
}

/** The height in the plane of the picture of all that a step needs to show. */
double StepFrames::findLowest(std::size_t chapter, std::size_t step) const
{
    constexpr double CONTEXT = 5.0; // pitches of the model below new parts
    const BookletChapter& own = _model.getChapters()[chapter];
    // The first step shows the whole base plate, so that its studs beside the model can be counted.
    if (isOnPlate(own) && step == 0) return findUncut(chapter, step).lowest.y;
    const BookletCamera camera = createCamera(own, own.steps[step]);
    double lowest = std::numeric_limits<double>::max();
    for (const std::uint32_t part : getNewParts(own, own.steps[step]))
        lowest = std::min(lowest, camera.findFrame(std::span(&own.model->getParts()[part], 1)).lowest.y);
    return lowest - CONTEXT;
}

double StepFrames::sumHeights(std::size_t chapter, const Steps& steps, const Cuts& cuts) const
{
    return std::accumulate(steps.begin(), steps.end(), 0.0,
                           [&](double sum, std::size_t step)
                           { return sum + findCut(chapter, step, cuts).getSize().y; });
}

StepFrames::Scale StepFrames::findScale(std::size_t chapter, const Steps& steps) const
{
    Scale scale;
    for (const std::size_t step : steps)
        scale.size = glm::max(scale.size, findCut(chapter, step, _cuts[chapter]).getSize());
    scale.pixels =
        std::min({LARGEST_STEP_WIDTH / scale.size.x, LARGEST_STEP_HEIGHT / scale.size.y, LARGEST_STEP_PITCH});
    return scale;
}

const ArrowPlacement& StepFrames::findArrows(std::size_t chapter, std::size_t index) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& step = own.steps[index];
    if (const auto known = _arrows.find(&step); known != _arrows.end()) return known->second;
    const BookletCamera camera = createCamera(own, step);
    const BookletFrame area = findPlaced(own, step, camera);
    const double width = std::max(ARROW_WIDTH, ARROW_SHARE * area.getSize().x);
    const auto frameOf = [&camera](const Part& part) { return camera.findFrame(std::span(&part, 1)); };
    std::vector<ArrowTarget> targets;
    std::vector<BookletFrame> shown;
    for (const std::size_t submodel : step.submodels)
    {
        const BookletChapter& attached = _model.getChapters()[submodel];
        const std::vector<Part>& parts = attached.model->getParts();
        const BookletFrame frame = camera.findFrame(parts);
        targets.push_back({{0.5 * (frame.lowest.x + frame.highest.x), frame.highest.y + width},
                           step.hasLetters() ? attached.letter.size() : 0});
        std::transform(parts.begin(), parts.end(), std::back_inserter(shown), frameOf);
    }
    const std::span<const std::uint32_t> direct = getNewParts(own, step).first(step.numDirect);
    const std::vector<std::uint32_t> hidden =
        findHiddenParts(*own.model, std::span(own.plan->getOrder()).first(step.numPlaced), direct, camera.getToEye());
    for (const std::uint32_t part : direct)
    {
        const BookletFrame frame = frameOf(own.model->getParts()[part]);
        if (std::find(hidden.begin(), hidden.end(), part) == hidden.end())
            shown.push_back(frame);
        else
            targets.push_back({0.5 * (frame.lowest + frame.highest)});
    }
    return _arrows.try_emplace(&step, targets, width, area, shown).first->second;
}

} // namespace osgLego
