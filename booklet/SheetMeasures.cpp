#include "SheetMeasures.h"

#include "BookletText.h"

#include <common/NumberText.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

// Lengths of Booklet.css, in millimetres.
constexpr double PIXEL = 25.4 / 96.0;
constexpr double PART_SCALE = 0.44; // of pictures of parts, printed
constexpr double BOX_SCALE = 1.2;   // of pictures in boxes, compared with parts
constexpr double PART_PITCH = 20.0; // pixels of CSS, of pictures of parts
constexpr double QUANTITY_HEIGHT = 3.7;
constexpr double QUANTITY_WIDTH = 2.5; // of a character
constexpr double ROUNDING = 0.05;
constexpr double NUMBER_WIDTH = 11.0;
constexpr double NUMBER_CHARACTER = 4.6;
constexpr double COUNT_CHARACTER = 1.3; // of the number of parts below it
constexpr double NUMBER_HEIGHT = 11.0;
constexpr double TURN = 10.0;        // below a number, with the space above
constexpr double SPACE = 2.0;        // between the things of a block
constexpr double NUMBER_SPACE = 1.5; // beside a number
constexpr glm::dvec2 ITEM_SPACE{2.5, 1.0};
constexpr glm::dvec2 CALLOUT_PADDING{2.2, 1.9}; // on each side, with the border
constexpr double BAR = 2.7;                     // beside submodels of many parts
constexpr double LETTER = 6.0;
constexpr double LETTER_PADDING = 3.4;    // beside the letters of a box, on both sides
constexpr double HEADING_CHARACTER = 5.0; // of the letters of a submodel of many parts
constexpr double MORE_PARTS = 5.0;        // the height of a line above the rest of a list
constexpr double MULTIPLIER = 8.0;        // with the space beside it
constexpr double STEP_PADDING = 1.0;      // around a step in a box
constexpr double NOTE_LINE = 4.0;
constexpr double NOTE_PADDING = 4.0;
constexpr double NOTE_CHARACTER = 1.6;
constexpr double CONTENTS_SCALE = 1.5; // of pictures of submodels of many parts, compared with parts
constexpr double HEADING = 17.0;       // of a bag, with the picture of its place
constexpr double LEAST_SCALE = 0.75;   // at which the smallest text of a block has 2 mm
constexpr double LEAST_POSSIBLE_SCALE = 0.01;

/** The size of items in rows of some width. */
glm::dvec2 flow(const std::vector<glm::dvec2>& items, double width, const glm::dvec2& space)
{
    glm::dvec2 size(0.0);
    glm::dvec2 row(0.0);
    const auto end = [&]
    {
        size = {std::max(size.x, row.x), size.y + (size.y > 0.0 ? space.y : 0.0) + row.y};
        row = glm::dvec2(0.0);
    };
    for (const glm::dvec2& item : items)
    {
        if (row.x > 0.0 && row.x + space.x + item.x > width) end();
        row = {row.x + (row.x > 0.0 ? space.x : 0.0) + item.x, std::max(row.y, item.y)};
    }
    if (row.x > 0.0) end();
    return size;
}

/** Whether no item is wider than a list. */
bool fit(const std::vector<glm::dvec2>& items, double width)
{
    constexpr double TOLERANCE = 1e-9;
    return std::all_of(items.begin(), items.end(),
                       [width](const glm::dvec2& item) { return item.x <= width + TOLERANCE; });
}

/** The height of a list in its frame; SheetFilling::IMPOSSIBLE if an item is too wide. Items are never shrunk, so that
 * parts can be told apart by their length. */
double measureList(const std::vector<glm::dvec2>& items, double width)
{
    const double inner = width - 2.0 * CALLOUT_PADDING.x;
    if (!fit(items, inner)) return SheetFilling::IMPOSSIBLE;
    return flow(items, inner, ITEM_SPACE).y + 2.0 * CALLOUT_PADDING.y;
}

/** The largest scale at which something is low enough, down to a least one. */
double findScale(const std::function<double(double)>& measure, double width, double most, double least)
{
    constexpr double STEP = 0.95;
    double scale = 1.0;
    while (scale * measure(width / scale) > most && STEP * scale >= least)
        scale *= STEP;
    return scale;
}

glm::dvec2 shrink(const glm::dvec2& picture, double most)
{
    return picture * std::min(1.0, most / picture.x);
}

/** The width of the letter of a submodel in a list or a box. */
double measureLetter(const BookletChapter& chapter)
{
    return LETTER_PADDING + QUANTITY_WIDTH * static_cast<double>(chapter.letter.size());
}

/** The width of the number of equal submodels; 0 without one. */
double measureMultiplier(const BookletChapter& chapter)
{
    return chapter.quantity > 1 ? MULTIPLIER : 0.0;
}

void append(std::vector<glm::dvec2>& sizes, const std::vector<glm::dvec2>& others)
{
    sizes.insert(sizes.end(), others.begin(), others.end());
}

} // namespace

SheetMeasures::SheetMeasures(const BookletModel& model, const BookletPictureSource& pictures,
                             const BookletMarkup& markup, const std::vector<bool>& isWhole) :
    _model(model),
    _pictures(pictures), _markup(markup), _isWhole(isWhole)
{
}

glm::dvec2 SheetMeasures::toBox(const glm::dvec2& studs)
{
    return studs * (PART_PITCH * PIXEL * PART_SCALE * BOX_SCALE);
}

glm::dvec2 SheetMeasures::measureItem(const BookletItem& item) const
{
    const glm::dvec2 picture = _markup.getKindSize(item.kind) * (PIXEL * PART_SCALE);
    const double text = QUANTITY_WIDTH * (1.0 + static_cast<double>(std::to_string(item.quantity).size()));
    return {std::max(picture.x, text) + ROUNDING, picture.y + QUANTITY_HEIGHT};
}

SheetMeasures::Sizes SheetMeasures::measureItems(const std::vector<BookletItem>& items) const
{
    Sizes sizes;
    for (const BookletItem& item : items)
        sizes.push_back(measureItem(item));
    return sizes;
}

/** The picture of a finished submodel, with its letter and its multiplier below. @param most width. */
glm::dvec2 SheetMeasures::measureUse(std::size_t chapter, double most) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const glm::dvec2 picture = shrink(_pictures.measureFinished(chapter) * (PIXEL * PART_SCALE), most);
    return {std::max(picture.x, measureLetter(own) + measureMultiplier(own)), picture.y + LETTER};
}

/** The entries of a list of submodels and parts. @param most width of pictures of submodels. */
SheetMeasures::Sizes SheetMeasures::measureEntries(const std::vector<std::size_t>& submodels,
                                                   const std::vector<BookletItem>& items, double most) const
{
    Sizes sizes;
    for (const std::size_t submodel : submodels)
        sizes.push_back(measureUse(submodel, most));
    append(sizes, measureItems(items));
    return sizes;
}

/** The height of the list of parts and submodels that a step adds. */
double SheetMeasures::measureCallout(const BookletStep& step, double width) const
{
    std::vector<std::size_t> large = _model.getOriginals(step);
    std::erase_if(large, [this](std::size_t submodel) { return _model.getChapters()[submodel].isCallout(); });
    const Sizes sizes = measureEntries(large, step.items, width - 2.0 * CALLOUT_PADDING.x);
    return sizes.empty() ? 0.0 : measureList(sizes, width);
}

glm::dvec2 SheetMeasures::measureBox(std::size_t chapter, double width) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const double inner = width - 2.0 * CALLOUT_PADDING.x;
    Sizes sizes{{measureLetter(own), LETTER}};
    const Sizes items = measureItems(own.items);
    if (!fit(items, inner)) return {width, SheetFilling::IMPOSSIBLE};
    append(sizes, items);
    for (std::size_t step = 0; step < own.steps.size() && !_isWhole[chapter]; ++step)
    {
        // Boxes within a box are a row across it.
        if (const Sizes boxes = measureBoxes(own.steps[step], inner); !boxes.empty())
            sizes.push_back({inner, flow(boxes, inner, glm::dvec2(SPACE)).y});
        const glm::dvec2 picture = toBox(_pictures.measureStep(chapter, step));
        const glm::dvec2 number(LETTER, own.steps[step].isTurned ? 2.0 * LETTER : LETTER);
        sizes.push_back(glm::dvec2(number.x + picture.x, std::max(number.y, picture.y)) + 2.0 * STEP_PADDING);
    }
    const double multiplier = measureMultiplier(own);
    const glm::dvec2 finished =
        shrink(_pictures.measureFinished(chapter) * (PIXEL * PART_SCALE * BOX_SCALE), inner - multiplier);
    sizes.push_back({finished.x + multiplier, std::max(finished.y, LETTER)});
    return flow(sizes, inner, ITEM_SPACE) + 2.0 * CALLOUT_PADDING;
}

SheetMeasures::Sizes SheetMeasures::measureBoxes(const BookletStep& step, double width) const
{
    Sizes sizes;
    for (const std::size_t submodel : _model.getOriginals(step))
        if (_model.getChapters()[submodel].isCallout()) sizes.push_back(measureBox(submodel, width));
    return sizes;
}

SheetBlock SheetMeasures::measureStep(std::size_t chapter, std::size_t step, bool hasScale) const
{
    const BookletStep& own = _model.getChapters()[chapter].steps[step];
    SheetBlock block;
    block.studs = _pictures.measureStep(chapter, step);
    block.hasScale = hasScale;
    if (!hasScale)
    {
        constexpr double MOST_HEIGHT = 0.4 * SheetArrangement::HEIGHT;
        block.mostPitch = std::min(SheetArrangement::LARGE_PITCH, MOST_HEIGHT / block.studs.y);
    }
    if (chapter > 0) block.lostWidth = BAR;
    findScales([&](double width) { return measureHead(_model.getChapters()[chapter], own, width - block.lostWidth); },
               SheetArrangement::MOST_HEAD, block);
    return block;
}

/** The height of all but the picture of a step. */
double SheetMeasures::measureHead(const BookletChapter& chapter, const BookletStep& step, double width) const
{
    const std::string count = describeCount(_model, step);
    const double number = std::max({NUMBER_WIDTH, NUMBER_CHARACTER * static_cast<double>(step.name.size()),
                                    COUNT_CHARACTER * static_cast<double>(count.size())});
    double head =
        std::max(measureCallout(step, width - number - NUMBER_SPACE), NUMBER_HEIGHT + (step.isTurned ? TURN : 0.0));
    if (const Sizes boxes = measureBoxes(step, width); !boxes.empty())
        head += flow(boxes, width, glm::dvec2(SPACE)).y + SPACE;
    if (const std::string note = describeNotes(_model, chapter, step); !note.empty())
        head += NOTE_PADDING +
                NOTE_LINE * std::ceil(static_cast<double>(note.size()) * NOTE_CHARACTER / (width - NOTE_PADDING));
    return head;
}

glm::dvec2 SheetMeasures::measureContents(std::size_t chapter) const
{
    constexpr double LARGEST = 30.0; // along each side
    const glm::dvec2 size = _pictures.measureFinished(chapter) * (PIXEL * PART_SCALE * CONTENTS_SCALE);
    const double widest = LARGEST - measureMultiplier(_model.getChapters()[chapter]);
    return size * std::min({1.0, widest / size.x, LARGEST / size.y});
}

SheetBlock SheetMeasures::measureSubmodel(const BookletBlock& block) const
{
    SheetBlock size;
    size.hasScale = false;
    size.isHeading = !_isWhole[block.chapter];
    findScales([&](double width) { return measureSubmodel(block, width - BAR - SPACE); }, SheetArrangement::MOST_BODY,
               size);
    return size;
}

/** The height of the contents of a submodel. */
double SheetMeasures::measureSubmodel(const BookletBlock& block, double width) const
{
    const BookletChapter& own = _model.getChapters()[block.chapter];
    if (block.isContinued) return MORE_PARTS + SPACE + measureList(measureItems(block.items), width) + 2.0 * SPACE;
    const double letter = std::max(LETTER, HEADING_CHARACTER * static_cast<double>(own.letter.size())) + SPACE;
    constexpr double UNLIMITED = 1e9;
    const double natural = letter + 2.0 * CALLOUT_PADDING.x +
                           flow(measureEntries(block.submodels, block.items, UNLIMITED), UNLIMITED, ITEM_SPACE).x;
    const Sizes entries = measureEntries(block.submodels, block.items, width - letter - 2.0 * CALLOUT_PADDING.x);
    const double list = entries.empty() ? LETTER : measureList(entries, width - letter);
    const glm::dvec2 picture = measureContents(block.chapter) + glm::dvec2(measureMultiplier(own), 0.0);
    const bool isBeside = natural + SPACE + picture.x <= width;
    return (isBeside ? std::max(list, picture.y) : list + SPACE + picture.y) + 2.0 * SPACE;
}

std::vector<std::vector<BookletItem>> SheetMeasures::divideContents(const BookletBlock& contents) const
{
    return divide(contents.items,
                  [&](const std::vector<BookletItem>& part)
                  {
                      BookletBlock block = contents;
                      block.items = part;
                      return measureSubmodel(block).scales[0] >= LEAST_SCALE;
                  });
}

std::vector<SheetHeader> SheetMeasures::measureHeaders(const std::vector<BookletItem>& items) const
{
    const auto fits = [this](const std::vector<BookletItem>& part) { return measureHeader(part).scale >= LEAST_SCALE; };
    std::vector<SheetHeader> headers;
    for (const std::vector<BookletItem>& part : divide(items, fits))
        headers.push_back(measureHeader(part));
    return headers;
}

/** Divide a list into as few lists as fit, nearly equally long. */
std::vector<std::vector<BookletItem>>
SheetMeasures::divide(const std::vector<BookletItem>& items,
                      const std::function<bool(const std::vector<BookletItem>&)>& fits)
{
    for (std::size_t number = 1;; ++number)
    {
        std::vector<std::vector<BookletItem>> lists;
        for (std::size_t list = 0; list < number; ++list)
        {
            const auto place = [&](std::size_t index)
            { return items.begin() + static_cast<std::ptrdiff_t>(items.size() * index / number); };
            lists.emplace_back(place(list), place(list + 1));
        }
        if (number >= items.size() || std::all_of(lists.begin(), lists.end(), fits)) return lists;
    }
}

SheetHeader SheetMeasures::measureHeader(const std::vector<BookletItem>& items) const
{
    const Sizes sizes = measureItems(items);
    const auto measure = [&sizes](double width)
    {
        return HEADING + flow(sizes, width - 2.0 * CALLOUT_PADDING.x, ITEM_SPACE).y + 2.0 * CALLOUT_PADDING.y +
               SheetArrangement::BLOCK_SPACE;
    };
    SheetHeader header;
    header.items = items;
    header.scale = findScale(measure, SheetArrangement::WIDTH, SheetArrangement::HEIGHT, LEAST_POSSIBLE_SCALE);
    header.height = header.scale * measure(SheetArrangement::WIDTH / header.scale);
    return header;
}

SheetFoot SheetMeasures::measureColors(const std::vector<std::string>& names)
{
    constexpr double HEIGHT = 5.0;                                     // of a foot of one line
    constexpr double WIDTH_OF_COLORS = SheetArrangement::WIDTH - 35.0; // without the number of parts
    constexpr double SWATCH = 3.6;
    constexpr double CHARACTER = 1.45;
    constexpr double LINE = 2.5;
    constexpr double COLOR_SPACE = 2.5;
    constexpr double LEAST_SCALE_OF_COLORS = 0.84; // at which the names have 2 mm
    Sizes sizes;
    for (const std::string& name : names)
        sizes.push_back({SWATCH + CHARACTER * static_cast<double>(name.size()), LINE});
    const auto measure = [&sizes](double width) { return flow(sizes, width, {COLOR_SPACE, 0.0}).y; };
    SheetFoot foot;
    foot.scale = findScale(measure, WIDTH_OF_COLORS, HEIGHT, LEAST_SCALE_OF_COLORS);
    if (foot.scale * measure(WIDTH_OF_COLORS / foot.scale) > HEIGHT + SheetArrangement::MOST_FOOT)
        foot.scale = findScale(measure, WIDTH_OF_COLORS, HEIGHT + SheetArrangement::MOST_FOOT, LEAST_POSSIBLE_SCALE);
    foot.more = std::max(0.0, foot.scale * measure(WIDTH_OF_COLORS / foot.scale) - HEIGHT);
    return foot;
}

/** Find the heads of a block, and the scales at which they are low enough. Only the boxes of dozens of submodels in a
 * step do not fit even without columns unless they are too small to read. */
void SheetMeasures::findScales(const HeightFunction& measure, double most, SheetBlock& block)
{
    for (std::size_t numColumns = 1; numColumns <= SheetBlock::MOST_COLUMNS; ++numColumns)
    {
        const double width = SheetArrangement::getColumnWidth(numColumns);
        const double scale = findScale(measure, width, most, numColumns == 1 ? LEAST_POSSIBLE_SCALE : LEAST_SCALE);
        const double head = scale * measure(width / scale);
        block.scales[numColumns - 1] = scale;
        block.heads[numColumns - 1] = head <= most ? head : SheetFilling::IMPOSSIBLE;
    }
}

} // namespace osgLego
