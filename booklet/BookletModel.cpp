#include "BookletModel.h"

#include <osgLego/PieceCount.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

/** A letter for a submodel: A to Z, then AA, AB and so on, without I and O, which look like digits beside those of
 * steps. */
std::string letterOf(std::size_t index)
{
    constexpr std::string_view LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ";
    std::string letters;
    for (std::size_t rest = index + 1; rest > 0; rest = (rest - 1) / LETTERS.size())
        letters.insert(letters.begin(), LETTERS[(rest - 1) % LETTERS.size()]);
    return letters;
}

/** Set whether the view of each step differs from that of the step before. The first step of a submodel that is turned
 * or built upside down differs from its finished picture. */
void markTurns(std::vector<BookletStep>& steps)
{
    steps.front().isTurnedOver = steps.front().isUpsideDown;
    steps.front().isTurned = steps.front().isUpsideDown || steps.front().turns != 0;
    for (std::size_t step = 1; step < steps.size(); ++step)
        steps[step].isTurned = steps[step].turns != steps[step - 1].turns;
}

/** Whether one part is on top of another, with studs between them. */
bool isOn(const Part& upper, const Part& lower, int up)
{
    if (lower.getCell()[up] + lower.getSize()[up] != upper.getCell()[up]) return false;
    const glm::ivec3 low = glm::max(upper.getCell(), lower.getCell());
    const glm::ivec3 high = glm::min(upper.getCell() + upper.getSize(), lower.getCell() + lower.getSize());
    return low.x < high.x && low[3 - up] < high[3 - up];
}

/** The height of the side on which a part is placed: the lower one or, upside down, the upper one, counted downwards.
 */
int findHeight(const Part& part, int up, bool isFromBelow)
{
    return isFromBelow ? -part.getCell()[up] - part.getSize()[up] : part.getCell()[up];
}

/** Parts of a step that are on no others, but below some. */
struct HangingParts
{
    std::vector<std::uint32_t> pressed; // on from below: below parts in place
    std::vector<std::uint32_t> joined;  // in a hand with others of the step, from which they hang
};

/** @param placed the parts in place before. @param base the least height of all parts: those on the base don't hang
 * from others of the step. */
HangingParts findHanging(const BrickModel& model, const BuildingStep& step, std::span<const std::uint32_t> placed,
                         int base)
{
    const int up = model.getGrid().getUpIndex();
    const auto touchesAny = [&](const Part& own, std::span<const std::uint32_t> others, bool isOwnUpper)
    {
        return std::any_of(others.begin(), others.end(),
                           [&](std::uint32_t other)
                           {
                               const Part& part = model.getParts()[other];
                               return isOwnUpper != step.isFromBelow ? isOn(own, part, up) : isOn(part, own, up);
                           });
    };
    HangingParts hanging;
    for (const std::uint32_t part : step.parts)
    {
        const Part& own = model.getParts()[part];
        if (touchesAny(own, placed, true) || touchesAny(own, step.parts, true)) continue;
        if (touchesAny(own, placed, false))
            hanging.pressed.push_back(part);
        else if (findHeight(own, up, step.isFromBelow) != base && touchesAny(own, step.parts, false))
            hanging.joined.push_back(part);
    }
    return hanging;
}

/** The model of some parts of another, and for each of these its index there. */
osg::ref_ptr<const BrickModel> createPartialModel(const BrickModel& model, const std::vector<std::uint32_t>& parts,
                                                  std::map<std::uint32_t, std::uint32_t>& indices)
{
    // Parts of all models are sorted by their cells, so that the chosen ones keep their order.
    for (const std::uint32_t part : parts)
        indices[part] = 0;
    std::vector<Part> chosen;
    for (auto& [part, index] : indices)
    {
        index = static_cast<std::uint32_t>(chosen.size());
        chosen.push_back(model.getParts()[part]);
    }
    return BrickModel::createOfParts(model.getGrid(), std::move(chosen));
}

/** @param parts of the chapter, as indices in the whole model, in the order of building. @param unheld of these. */
void countPiecesOfSteps(BookletChapter& chapter, const std::vector<std::uint32_t>& parts,
                        const std::vector<std::uint32_t>& unheld, BuildingBase base)
{
    std::vector<std::uint32_t> held;
    std::vector<std::size_t> numHeld; // after each part
    for (std::size_t rank = 0; rank < parts.size(); ++rank)
    {
        if (!std::binary_search(unheld.begin(), unheld.end(), parts[rank]))
            held.push_back(chapter.plan->getOrder()[rank]);
        numHeld.push_back(held.size());
    }
    const std::vector<std::size_t> numPieces = countPiecesInOrder(*chapter.model, held, base);
    for (BookletStep& step : chapter.steps)
    {
        const std::size_t numPlaced = numHeld[step.numPlaced - 1];
        step.numPieces = numPlaced > 0 ? numPieces[numPlaced - 1] : 0;
    }
}

} // namespace

BookletModel::BookletModel(const BrickModel& model, const BuildingPlan& plan, std::span<const PaletteColor> palette,
                           BuildingBase base) :
    _model(&model),
    _numPieces(countPieces(model, base)), _numUnheld(plan.getUnheldParts().size())
{
    if (base == BuildingBase::PLATE) addBasePlate(model);
    _list.add(model, palette);
    _kinds = _list.getRows();
    _kindOfPart = _list.findRows(model);
    _chapters.push_back(createChapter(plan, plan.getSteps(), base));
    for (const Submodel& submodel : plan.getSubmodels())
    {
        _chapters.push_back(createChapter(plan, submodel.steps, BuildingBase::TABLE));
        _chapters.back().isSubmodel = true;
    }
    for (std::size_t chapter = 0; chapter < _chapters.size(); ++chapter)
        _chapters[chapter].original = chapter;
    for (const BookletChapter& chapter : _chapters)
        for (const BookletStep& step : chapter.steps)
            findCopies(step);
    std::size_t numNamed = 0;
    nameSteps(_chapters.front(), numNamed);
}

BookletChapter BookletModel::createChapter(const BuildingPlan& plan, const std::vector<BuildingStep>& steps,
                                           BuildingBase base) const
{
    BookletChapter chapter;
    std::vector<std::vector<std::uint32_t>> placed;
    std::vector<std::uint32_t> all;
    for (const BuildingStep& step : steps)
    {
        placed.push_back(plan.getPlacedParts(step));
        all.insert(all.end(), placed.back().begin(), placed.back().end());
    }
    const int up = _model->getGrid().getUpIndex();
    int least = std::numeric_limits<int>::max();
    for (const std::uint32_t part : all)
        least = std::min(least, findHeight(_model->getParts()[part], up, steps.front().isFromBelow));
    std::size_t numPlaced = 0;
    for (std::size_t index = 0; index < steps.size(); ++index)
    {
        const BuildingStep& step = steps[index];
        BookletStep& own = chapter.steps.emplace_back();
        own.items = countKinds(step.parts);
        const HangingParts hanging = findHanging(*_model, step, std::span(all).first(numPlaced), least);
        own.pressed = countKinds(hanging.pressed);
        own.joined = countKinds(hanging.joined);
        for (const std::uint32_t submodel : step.submodels)
            own.submodels.push_back(submodel + 1);
        own.turns = step.turns;
        own.isUpsideDown = step.isFromBelow;
        own.stands = step.stands;
        const std::vector<std::uint32_t>& unheld = plan.getUnheldParts();
        own.numUnheld = static_cast<std::size_t>(std::count_if(
            placed[index].begin(), placed[index].end(),
            [&unheld](std::uint32_t part) { return std::binary_search(unheld.begin(), unheld.end(), part); }));
        own.numDirect = step.parts.size();
        own.numNew = placed[index].size();
        own.numPlaced = numPlaced += own.numNew;
    }
    markTurns(chapter.steps);
    chapter.items = countKinds(all);

    std::map<std::uint32_t, std::uint32_t> indices;
    chapter.model = createPartialModel(*_model, all, indices);
    std::vector<BuildingStep> flat;
    for (std::size_t step = 0; step < steps.size(); ++step)
    {
        flat.push_back(steps[step]);
        flat.back().submodels.clear();
        flat.back().parts.clear();
        flat.back().isFromBelow = false; // the chapter's step knows it
        for (const std::uint32_t part : placed[step])
            flat.back().parts.push_back(indices[part]);
    }
    chapter.plan = BuildingPlan::create(all.size(), std::move(flat));
    countPiecesOfSteps(chapter, all, plan.getUnheldParts(), base);
    return chapter;
}

std::vector<BookletItem> BookletModel::countKinds(const std::vector<std::uint32_t>& parts) const
{
    std::map<std::size_t, std::size_t> quantities;
    for (const std::uint32_t part : parts)
        ++quantities[_kindOfPart[part]];
    std::vector<BookletItem> items;
    items.reserve(quantities.size());
    for (const auto& [kind, quantity] : quantities)
        items.push_back({kind, quantity});
    return items;
}

/** How a submodel is turned from one with parts of the same kinds in the same places relative to each other. */
std::optional<SubmodelTurn> BookletModel::findTurn(const BookletChapter& chapter, const BookletChapter& other) const
{
    return SubmodelTurn::find(*chapter.model, _list.findRows(*chapter.model), *other.model,
                              _list.findRows(*other.model));
}

/** Find the submodels of a step that are equal, so that they are shown once. */
void BookletModel::findCopies(const BookletStep& step)
{
    for (std::size_t place = 0; place < step.submodels.size(); ++place)
        for (std::size_t before = 0; before < place; ++before)
        {
            BookletChapter& own = _chapters[step.submodels[place]];
            BookletChapter& other = _chapters[step.submodels[before]];
            if (other.original != step.submodels[before]) continue;
            const std::optional<SubmodelTurn> turn = findTurn(own, other);
            if (!turn) continue;
            own.turn = *turn;
            own.original = other.original;
            own.copy = ++other.quantity;
            break;
        }
}

std::vector<std::size_t> BookletModel::getOriginals(const BookletStep& step) const
{
    std::vector<std::size_t> originals;
    std::copy_if(step.submodels.begin(), step.submodels.end(), std::back_inserter(originals),
                 [this](std::size_t submodel) { return _chapters[submodel].original == submodel; });
    std::stable_partition(originals.begin(), originals.end(),
                          [this](std::size_t submodel) { return !_chapters[submodel].isCallout(); });
    return originals;
}

/** Number the steps of a chapter, and give letters to its submodels in the order in which they are built. Copies have
 * the letters of their originals, and none for submodels within them, since they are not shown. */
void BookletModel::nameSteps(BookletChapter& chapter, std::size_t& numNamed)
{
    for (std::size_t step = 0; step < chapter.steps.size(); ++step)
    {
        chapter.steps[step].name = chapter.letter + std::to_string(step + 1);
        for (const std::size_t submodel : getOriginals(chapter.steps[step]))
        {
            _chapters[submodel].letter = letterOf(numNamed++);
            nameSteps(_chapters[submodel], numNamed);
        }
        for (const std::size_t submodel : chapter.steps[step].submodels)
            _chapters[submodel].letter = _chapters[_chapters[submodel].original].letter;
    }
}

void BookletModel::addBasePlate(const BrickModel& model)
{
    _basePlate.emplace(model);
    _list.addExtra(_basePlate->createRow());
}

std::vector<std::string> BookletModel::getFallingSteps() const
{
    std::vector<std::string> names;
    for (const BookletChapter& chapter : _chapters)
        for (const BookletStep& step : chapter.steps)
            if (!chapter.isCallout() && step.falls()) names.push_back(step.name);
    return names;
}

std::size_t BookletModel::getNumStepsOfSubmodels() const
{
    return std::accumulate(_chapters.begin() + 1, _chapters.end(), std::size_t{0},
                           [](std::size_t number, const BookletChapter& chapter)
                           { return number + chapter.steps.size(); });
}

std::size_t BookletModel::getNumParts() const
{
    return _model->getParts().size();
}

double BookletModel::getMass() const
{
    return std::accumulate(_kinds.begin(), _kinds.end(), 0.0,
                           [](double mass, const PartsList::Row& row) { return mass + row.getMass(); });
}

glm::dvec3 BookletModel::getSize() const
{
    constexpr double PITCH = 8.0;        // millimetres
    constexpr double PLATE_HEIGHT = 3.2; // millimetres
    const BrickGrid& grid = _model->getGrid();
    glm::ivec3 lowest(grid.dimensions);
    glm::ivec3 end(0);
    for (const Part& part : _model->getParts())
    {
        lowest = glm::min(lowest, part.getCell());
        end = glm::max(end, part.getCell() + part.getSize());
    }
    const glm::dvec3 cells(end - lowest);
    const int up = grid.getUpIndex();
    return {cells.x * PITCH, cells[3 - up] * PITCH, cells[up] * getCellPlates(grid) * PLATE_HEIGHT};
}

} // namespace osgLego
