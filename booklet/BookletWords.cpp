#include "BookletWords.h"

#include "BookletText.h"
#include "PlacedBox.h"

#include <common/NumberText.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

constexpr int BRICK_PLATES = 3; // the height of a brick in plates

/** "column 3", or "columns 3 to 4". */
std::string formatRange(const char* name, int first, int last)
{
    return first == last ? fmt::format("{} {}", name, first) : fmt::format("{}s {} to {}", name, first, last);
}

/** How far an edge is from another one, such as "2 studs right of". */
std::string formatWay(int way, const char* forwards, const char* backwards)
{
    if (way == 0) return "level with";
    return fmt::format("{} {}", countOf(static_cast<std::size_t>(std::abs(way)), "stud"),
                       way > 0 ? forwards : backwards);
}

bool areAbove(const glm::ivec3& first, const glm::ivec3& last, const glm::ivec3& otherFirst,
              const glm::ivec3& otherLast)
{
    return first.x <= otherLast.x && otherFirst.x <= last.x && first.y <= otherLast.y && otherFirst.y <= last.y;
}

/** A sentence on the steps that are written; empty if all are. */
std::string formatSteps(std::size_t first, std::size_t end, std::size_t number)
{
    if (first == 0 && end == number) return {};
    return fmt::format("Only {} {}.\n", formatRange("step", static_cast<int>(first) + 1, static_cast<int>(end)),
                       first + 1 == end ? "follows" : "follow");
}

/** The quarter turns of a model, 0 to 3, counter-clockwise from above, after which the side nearest to a view is in
 * front. */
int countTurns(const BuildingView& view)
{
    constexpr double QUARTER = 90.0; // degrees, to the right, which is clockwise
    constexpr int NUM_TURNS = SubmodelTurn::NUM_TURNS;
    const auto turns = static_cast<int>(std::fmod(-std::round(view.azimuth / QUARTER), NUM_TURNS));
    return (turns + NUM_TURNS) % NUM_TURNS;
}

/** The height of a layer in cells: that of a brick, if all parts are bricks and lie in layers of bricks. */
int findLayerHeight(const BrickModel& model)
{
    std::vector<PlacedBox> boxes;
    int lowest = std::numeric_limits<int>::max();
    for (const Part& part : model.getParts())
    {
        boxes.push_back(PlacedBox::create(model.getGrid(), part));
        lowest = std::min(lowest, boxes.back().lower.z);
    }
    const bool areBricks = std::all_of(
        boxes.begin(), boxes.end(),
        [&](const PlacedBox& box) { return box.size.z == BRICK_PLATES && (box.lower.z - lowest) % BRICK_PLATES == 0; });
    return areBricks ? BRICK_PLATES : 1;
}

} // namespace

BookletWords::BookletWords(const BookletModel& model, const BuildingView& view) :
    _model(model), _turns(countTurns(view)), _layerHeight(findLayerHeight(*model.getMainChapter().model)),
    _endStep(model.getMainChapter().steps.size())
{
}

void BookletWords::setSteps(std::size_t first, std::size_t end)
{
    _firstStep = first;
    _endStep = end;
}

void BookletWords::write(std::ostream& stream, const std::string& title)
{
    _stream = &stream;
    writeIntroduction(title);
    writeChapter(0);
    if (_endStep == _model.getMainChapter().steps.size()) *_stream << "\nThe model is finished.\n";
}

void BookletWords::writeIntroduction(const std::string& title)
{
    const std::vector<Place> places = findPlaces(0);
    glm::ivec3 size(0);
    for (const Place& place : places)
        size = glm::max(size, place.last);
    std::string steps = countOf(_model.getNumSteps(), "step");
    if (const std::size_t number = _model.getNumStepsOfSubmodels())
        steps += ", and " + countOf(number, "step") + " in submodels";
    *_stream
        << title << "\nBuilding instructions in words\n\n"
        << fmt::format("The model is {} wide, {} deep and {} high. It has {} in {}.\n",
                       countOf(static_cast<std::size_t>(size.x), "stud"),
                       countOf(static_cast<std::size_t>(size.y), "stud"),
                       countOf(static_cast<std::size_t>(size.z), "layer"), countOf(_model.getNumParts(), "part"), steps)
        << formatSteps(_firstStep, _endStep, _model.getMainChapter().steps.size())
        << "Columns count from left to right, rows from the front to the back, and layers from the bottom up. "
           "A layer is as high as a "
        << (getCellPlates(_model.getMainChapter().model->getGrid()) * _layerHeight == BRICK_PLATES ? "brick" : "plate")
        << ".\n"
        << "The front is the side towards you. Keep the front towards you. Lengths and edges are in studs.\n"
        << "A part has the number of its step and its number in this step: 2.3 is the third part of step 2.\n"
        << "A part that is only below others hangs from them: press it on from below, or, if both are new, join them "
           "before you place them.\n"
        << "A submodel has a letter. Build it apart, and count its own columns, rows and layers from its left, "
           "front and lowest end. Copies of a submodel are equal, but may be attached turned.\n\nParts\n";
    for (const PartsList::Row& row : _model.getKinds())
        *_stream << describeParts(row, row.quantity) << ".\n";
    if (_model.getBasePlate()) writeBasePlate(*_model.getBasePlate(), glm::ivec2(size));
}

/** @param size of the model, in columns and rows. */
void BookletWords::writeBasePlate(const BasePlate& plate, const glm::ivec2& size)
{
    const std::size_t quantity = plate.getQuantity();
    std::string name = osgDB::convertToLowerCase(plate.getName());
    if (quantity > 1) name.insert(name.find("plate") + 5, "s");
    const glm::ivec2 footprint = _turns % 2 == 0 ? size : glm::ivec2(size.y, size.x);
    const PlacedBox model = PlacedBox{{plate.getMargin(), 0}, {footprint, 1}}.turn(_turns);
    const PlacedBox plates = PlacedBox{glm::ivec3(0), {plate.getSize(), 1}}.turn(_turns);
    const glm::ivec3 first = model.lower - plates.lower + 1;
    const glm::ivec3 last = first + model.size - 1;
    *_stream << formatNumber(quantity) << " green " << name << (quantity == 1 ? "" : ", side by side") << ".\n\n"
             << (quantity == 1 ? "The model stands on the base plate"
                               : "The model stands on the base plates, which are counted together")
             << fmt::format(": on its {} and {}.\n", formatRange("column", first.x, last.x),
                            formatRange("row", first.y, last.y));
}

/** The names of the parts of an attached submodel, in the order of building: those of the original, with the number of
 * the copy if there are several. */
std::vector<std::string> BookletWords::findNamesOfCopy(const BookletChapter& copy) const
{
    const BookletChapter& original = _model.getChapters()[copy.original];
    const std::vector<std::string> names = findNames(copy.original);
    if (original.quantity == 1) return names;
    std::vector<std::string> own;
    for (const std::uint32_t part : copy.plan->getOrder())
    {
        const std::uint32_t equal = copy.copy == 1 ? part : copy.turn.equal[part];
        own.push_back(fmt::format("{} of copy {}", names[original.plan->getRanks()[equal]], copy.copy));
    }
    return own;
}

/** The names of the parts of a chapter, in the order of building. */
std::vector<std::string> BookletWords::findNames(std::size_t chapter) const
{
    std::vector<std::string> names;
    for (const BookletStep& step : _model.getChapters()[chapter].steps)
    {
        for (std::size_t part = 1; part <= step.numDirect; ++part)
            names.push_back(fmt::format("{}.{}", step.name, part));
        for (const std::size_t submodel : step.submodels)
        {
            const std::vector<std::string> inner = findNamesOfCopy(_model.getChapters()[submodel]);
            names.insert(names.end(), inner.begin(), inner.end());
        }
    }
    return names;
}

/** The parts of a chapter, in the order of building. */
std::vector<BookletWords::Place> BookletWords::findPlaces(std::size_t chapter) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const std::vector<std::size_t> rows = _model.getPartsList().findRows(*own.model);
    const std::vector<std::string> names = findNames(own.original);
    std::vector<Place> places;
    glm::ivec3 lowest(std::numeric_limits<int>::max());
    for (const std::uint32_t part : own.plan->getOrder())
    {
        Place& place = places.emplace_back();
        place.name = names[places.size() - 1];
        place.type = describeParts(_model.getKinds()[rows[part]], 1).substr(2);
        const PlacedBox box = PlacedBox::create(own.model->getGrid(), own.model->getParts()[part]).turn(_turns);
        place.first = box.lower;
        place.last = box.lower + box.size - 1;
        lowest = glm::min(lowest, place.first);
    }
    for (Place& place : places)
    {
        place.first -= lowest;
        place.last -= lowest;
        place.first.z /= _layerHeight;
        place.last.z /= _layerHeight;
        place.first += 1;
        place.last += 1;
    }
    return places;
}

void BookletWords::writeChapter(std::size_t chapter)
{
    const std::vector<Place> places = findPlaces(chapter);
    const BookletChapter& own = _model.getChapters()[chapter];
    for (std::size_t index = 0; index < own.steps.size(); ++index)
    {
        if (chapter == 0 && (index < _firstStep || index >= _endStep)) continue;
        const BookletStep& step = own.steps[index];
        for (const std::size_t submodel : _model.getOriginals(step))
        {
            const BookletChapter& inner = _model.getChapters()[submodel];
            *_stream << fmt::format("\nSubmodel {}, of {}. Build it apart{}.\n", inner.letter,
                                    countOf(inner.model->getParts().size(), "part"),
                                    inner.quantity == 1 ? "" : ", " + countOf(inner.quantity, "time"));
            if (inner.steps.front().isUpsideDown)
                *_stream << "Build it upside down, from its highest layer to its lowest one. Its places are those when "
                            "its studs are up.\n";
            writeChapter(submodel);
            *_stream << fmt::format("Submodel {} is finished.\n", inner.letter);
        }
        writeStep(own, step, places);
    }
}

void BookletWords::writeStep(const BookletChapter& chapter, const BookletStep& step, const std::vector<Place>& places)
{
    *_stream << fmt::format("\nStep {} of {}. Add {}.\n", step.name, chapter.steps.size(),
                            countOf(step.numNew, "part"));
    const bool isOnPlate = !chapter.isSubmodel && _model.getBasePlate();
    std::size_t part = step.numPlaced - step.numNew;
    for (const std::size_t end = part + step.numDirect; part < end; ++part)
        writePart(places, part, step.isUpsideDown, isOnPlate);
    for (const std::size_t submodel : step.submodels)
    {
        writeSubmodel(submodel, places, part, step.isUpsideDown, isOnPlate);
        part += _model.getChapters()[submodel].model->getParts().size();
    }
    const std::string pieces = describePieces(chapter, step, "keep to their columns and rows.");
    if (!pieces.empty()) *_stream << pieces << "\n";
    if (!chapter.isCallout() && step.falls())
        *_stream << "Hold the " << nameBuilt(chapter) << ", it does not stand by itself yet.\n";
}

/** @param part in the order of building; parts before it are in place. */
void BookletWords::writePart(const std::vector<Place>& places, std::size_t part, bool isUpsideDown, bool isOnPlate)
{
    const Place& own = places[part];
    const glm::ivec3 size = own.last - own.first + 1;
    const char* direction = size.x == size.y ? "" : size.x > size.y ? ", from left to right" : ", from front to back";
    *_stream << fmt::format("{}: {}{}. {}, {}, {}.", own.name, own.type, direction,
                            formatRange("Column", own.first.x, own.last.x), formatRange("row", own.first.y, own.last.y),
                            formatRange("layer", own.first.z, own.last.z));
    const Neighbors neighbors = findNeighbors(places, part, part + 1);
    *_stream << formatNeighbors(neighbors, own.first.z, isUpsideDown, isOnPlate);
    if (!neighbors.above.empty() && !neighbors.below.empty() && !isUpsideDown)
        *_stream << " Join it with the part above before you place both.";
    if (const Place* nearest = neighbors.first)
        *_stream << fmt::format(" Its left edge is {0} that of {2}, its front edge {1} that of {2}.",
                                formatWay(own.first.x - nearest->first.x, "right of", "left of"),
                                formatWay(own.first.y - nearest->first.y, "behind", "in front of"), nearest->name);
    *_stream << "\n";
}

/** The parts in place that parts touch above and below. @param first of these parts in the order of building, and
 * @param end the one after the last. */
BookletWords::Neighbors BookletWords::findNeighbors(const std::vector<Place>& places, std::size_t first,
                                                    std::size_t end) const
{
    Neighbors neighbors;
    for (std::size_t other = 0; other < first; ++other)
    {
        const Place& place = places[other];
        bool isBelow = false;
        bool isAbove = false;
        for (std::size_t part = first; part < end; ++part)
        {
            const Place& own = places[part];
            if (!areAbove(own.first, own.last, place.first, place.last)) continue;
            isBelow = isBelow || place.last.z + 1 == own.first.z;
            isAbove = isAbove || place.first.z == own.last.z + 1;
        }
        if (isBelow) neighbors.below.push_back(place.name);
        if (isAbove) neighbors.above.push_back(place.name);
        if (!neighbors.first && (isBelow || isAbove)) neighbors.first = &place;
    }
    return neighbors;
}

/** Where parts are placed: on which parts, and below which ones. @param layer the lowest one of the parts. */
std::string BookletWords::formatNeighbors(const Neighbors& neighbors, int layer, bool isUpsideDown,
                                          bool isOnPlate) const
{
    std::string text;
    if (!neighbors.below.empty()) text += " On " + joinWords(neighbors.below) + ".";
    if (!neighbors.above.empty()) text += " Below " + joinWords(neighbors.above) + ".";
    if (!text.empty()) return text;
    if (layer > 1 && !isUpsideDown) return " Nothing holds it yet.";
    return isOnPlate ? " On the base plate." : " On the table.";
}

/** Say where a submodel is attached. @param first of its parts, in the order of building. */
void BookletWords::writeSubmodel(std::size_t submodel, const std::vector<Place>& places, std::size_t first,
                                 bool isUpsideDown, bool isOnPlate)
{
    constexpr int QUARTER = 90; // degrees
    const BookletChapter& inner = _model.getChapters()[submodel];
    const glm::ivec3 offset = places[first].first - findPlaces(submodel).front().first + 1;
    const std::size_t end = first + inner.model->getParts().size();
    int lowest = places[first].first.z;
    for (std::size_t part = first; part < end; ++part)
        lowest = std::min(lowest, places[part].first.z);
    const BookletChapter& original = _model.getChapters()[inner.original];
    const std::string copy = original.quantity == 1 ? "" : fmt::format(", copy {}", inner.copy);
    const std::string turn =
        inner.turn.turns == 0
            ? std::string(": its column 1, row 1 and layer 1 come to")
            : fmt::format(", turned by {} degrees counter-clockwise as seen from above: its new front left corner in "
                          "layer 1 comes to",
                          QUARTER * inner.turn.turns);
    *_stream << fmt::format("Submodel {}{}{} column {}, row {}, layer {}.{}\n", inner.letter, copy, turn, offset.x,
                            offset.y, offset.z,
                            formatNeighbors(findNeighbors(places, first, end), lowest, isUpsideDown, isOnPlate));
}

} // namespace osgLego
