#include "BookletSteps.h"

#include "BookletText.h"
#include "SheetMeasures.h"

#include <common/NumberText.h>

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

/** The chapter with most steps among blocks, the main model if there are several. */
std::size_t findMainChapter(std::span<const BookletBlock> blocks)
{
    std::map<std::size_t, std::size_t> numSteps;
    for (const BookletBlock& block : blocks)
        numSteps[block.chapter] += block.isContents ? 0 : 1;
    return std::max_element(numSteps.begin(), numSteps.end(),
                            [](const auto& chapter, const auto& other) { return chapter.second < other.second; })
        ->first;
}

} // namespace

BookletSteps::BookletSteps(const BookletModel& model, BookletPictureSource& pictures,
                           const std::function<void(const std::string&)>& progress, BookletMarkup& markup) :
    _model(model),
    _pictures(pictures), _progress(progress), _markup(markup), _similarColors(model), _isWhole(findWhole()),
    _blocks(model, _isWhole), _bags(createBags(_blocks.getBlocks())),
    _blockMarkup(model, pictures, progress, markup, _isWhole)
{
}

std::vector<bool> BookletSteps::findWhole() const
{
    std::vector<bool> isWhole;
    for (std::size_t chapter = 0; chapter < _model.getChapters().size(); ++chapter)
    {
        const BookletChapter& own = _model.getChapters()[chapter];
        const bool hasSubmodels = std::any_of(own.steps.begin(), own.steps.end(),
                                              [](const BookletStep& step) { return !step.submodels.empty(); });
        // A few parts are put together in any order, and in any direction.
        const bool isOneStep = own.isCallout() || (own.steps.size() == 1 && !own.steps.front().isUpsideDown);
        const bool hasNotes =
            std::any_of(own.steps.begin(), own.steps.end(),
                        [&](const BookletStep& step) { return !describeNotes(_model, own, step).empty(); });
        isWhole.push_back(chapter > 0 && isOneStep && !hasSubmodels && !hasNotes && _pictures.replacesSteps(chapter));
    }
    return isWhole;
}

void BookletSteps::write(std::size_t first, std::size_t end)
{
    _markup.getStream() << "<section class=\"steps\" id=\"steps\">\n<h2 class=\"hidden\">Steps</h2>\n";
    if (_bags.empty()) writeSection(_blocks.select(0, _blocks.getBlocks().size(), first, end), nullptr);
    for (const BookletBag& bag : _bags)
        if (const auto blocks = _blocks.select(bag.firstBlock, bag.endBlock, first, end); !blocks.empty())
            writeSection(blocks, &bag);
    _markup.getStream() << "</section>\n";
}

/** Divide lists that are too long for one sheet. */
std::vector<BookletBlock> BookletSteps::divide(std::span<const BookletBlock> blocks,
                                               const SheetMeasures& measures) const
{
    std::vector<BookletBlock> divided;
    for (const BookletBlock& block : blocks)
    {
        divided.push_back(block);
        if (!block.isContents) continue;
        const std::vector<std::vector<BookletItem>> lists = measures.divideContents(block);
        divided.back().items = lists.front();
        for (std::size_t list = 1; list < lists.size(); ++list)
        {
            divided.push_back(block);
            divided.back().items = lists[list];
            divided.back().isContinued = true;
            divided.back().submodels.clear();
            divided.back().placed.clear();
        }
    }
    return divided;
}

/** Write blocks on sheets of their own. @param bag null without one. */
void BookletSteps::writeSection(std::span<const BookletBlock> undivided, const BookletBag* bag)
{
    if (bag) _pictures.setSection(findMainChapter(undivided), undivided);
    const SheetMeasures measures(_model, _pictures, _markup, _isWhole);
    const std::vector<BookletBlock> blocks = divide(undivided, measures);
    std::vector<SheetBlock> sizes;
    sizes.reserve(blocks.size());
    const std::size_t main = findMainChapter(blocks);
    for (const BookletBlock& block : blocks)
        sizes.push_back(block.isContents ? measures.measureSubmodel(block)
                                         : measures.measureStep(block.chapter, block.step, block.chapter == main));
    const std::vector<SheetHeader> headers = bag ? measures.measureHeaders(bag->items) : std::vector<SheetHeader>(1);
    for (std::size_t header = 0; header + 1 < headers.size(); ++header)
    {
        _markup.beginSheet();
        writeBag(*bag, headers[header], header > 0 ? std::span<const BookletBlock>() : undivided);
        _markup.getStream() << "</div>\n";
    }
    const SheetArrangement arrangement(
        sizes, headers.back().height, SheetBlock::MOST_COLUMNS,
        [&](std::size_t first, std::size_t end)
        { return SheetMeasures::measureColors(nameColors(std::span(blocks).subspan(first, end - first))).more; });
    for (const Sheet& sheet : arrangement.getSheets())
    {
        _markup.beginSheet();
        if (bag && &sheet == &arrangement.getSheets().front())
            writeBag(*bag, headers.back(), headers.size() > 1 ? std::span<const BookletBlock>() : undivided);
        writeSheet(blocks, sheet);
        _markup.getStream() << "</div>\n";
    }
}

void BookletSteps::writeSheet(std::span<const BookletBlock> blocks, const Sheet& sheet)
{
    if (sheet.columns.empty()) return; // below the header of a bag
    _markup.getStream() << "<div class=\"columns\" style=\"--columns:" << sheet.numColumns << "\">\n";
    for (const SheetColumn& column : sheet.columns)
    {
        _markup.getStream() << "<div class=\"column\">\n";
        for (const PlacedBlock& place : column)
            _blockMarkup.write(blocks[place.block], place);
        _markup.getStream() << "</div>\n";
    }
    _markup.getStream() << "</div>\n";
    const std::size_t first = sheet.columns.front().front().block;
    writeFoot(blocks.subspan(first, sheet.columns.back().back().block + 1 - first));
}

/** The kinds of parts whose colours the foot of a sheet names. */
std::vector<std::size_t> BookletSteps::chooseKinds(std::span<const BookletBlock> blocks) const
{
    std::set<std::size_t> kinds;
    for (const BookletBlock& block : blocks)
        addKinds(block, kinds);
    return _similarColors.chooseKinds(kinds);
}

std::vector<std::string> BookletSteps::nameColors(std::span<const BookletBlock> blocks) const
{
    std::vector<std::string> names;
    for (const std::size_t kind : chooseKinds(blocks))
        names.push_back(_markup.nameColorOf(kind));
    return names;
}

/** Write the foot of a sheet: names of similar colours, and the number of parts. */
void BookletSteps::writeFoot(std::span<const BookletBlock> blocks)
{
    const SheetFoot foot = SheetMeasures::measureColors(nameColors(blocks));
    _markup.getStream() << fmt::format("<footer class=\"last-line\" style=\"--more:{:.2f}\">", foot.more);
    if (const std::vector<std::size_t> chosen = chooseKinds(blocks); !chosen.empty())
    {
        _markup.getStream() << fmt::format(R"(<ul class="colors" aria-label="Similar colours" style="--scale:{:.3f}">)",
                                           foot.scale);
        for (const std::size_t kind : chosen)
        {
            _markup.getStream() << "<li>";
            _markup.writeSwatch(kind);
            _markup.getStream() << "</li>";
        }
        _markup.getStream() << "</ul>";
    }
    std::size_t numParts = 0;
    for (const BookletBlock& block : blocks)
        numParts += sumQuantities(block.placed);
    if (numParts > 0)
        _markup.getStream() << "<p class=\"sheet-parts\">" << countOf(numParts, "part") << " in these steps</p>";
    _markup.getStream() << "</footer>\n";
}

/** Add the kinds of parts that a block shows. */
void BookletSteps::addKinds(const BookletBlock& block, std::set<std::size_t>& kinds) const
{
    const auto add = [&kinds](const std::vector<BookletItem>& items)
    {
        for (const BookletItem& item : items)
            kinds.insert(item.kind);
    };
    const BookletChapter& own = _model.getChapters()[block.chapter];
    if (block.isContents) return add(block.items);
    add(own.steps[block.step].items);
    for (const std::size_t submodel : own.steps[block.step].submodels)
        if (_model.getChapters()[submodel].isCallout()) add(_model.getChapters()[submodel].items);
}

/** Write the header of a bag, or the rest of one whose list is too long for one sheet.
 * @param blocks of the bag, to show where they are; none in the rest. */
void BookletSteps::writeBag(const BookletBag& bag, const SheetHeader& header, std::span<const BookletBlock> blocks)
{
    const auto number = &bag - _bags.data() + 1;
    const bool isContinued = blocks.empty();
    const std::string names = isContinued
                                  ? fmt::format(R"( continued" data-of="bag-{}")", number)
                                  : fmt::format(R"(" id="bag-{0}" data-stop="Bag {0} of {1}")", number, _bags.size());
    const std::string count =
        isContinued ? "more parts" : countOf(bag.countParts(), "part") + " of " + countOf(bag.items.size(), "kind");
    _markup.getStream() << fmt::format(
        "<header class=\"bag{} style=\"--scale:{:.3f}\">\n<h2>Bag {} <span>of {}</span></h2>"
        "\n<p>{}</p>\n",
        names, header.scale, number, _bags.size(), count);
    if (!isContinued)
    {
        _progress(fmt::format("bag {} of {}", number, _bags.size()));
        _markup.getStream() << "<figure class=\"place\">";
        _markup.writeImage(_pictures.drawPlace(findMainChapter(blocks), blocks), "Where the parts of this bag are");
        _markup.getStream() << "</figure>\n";
    }
    _markup.getStream() << "<ul class=\"callout\">\n";
    _markup.writeItems(header.items);
    _markup.getStream() << "</ul>\n</header>\n";
}

std::size_t BookletSteps::countPictures(std::size_t first, std::size_t end) const
{
    const auto isWritten = [&](const BookletBag& bag)
    { return !_blocks.select(bag.firstBlock, bag.endBlock, first, end).empty(); };
    const auto numBags = static_cast<std::size_t>(std::count_if(_bags.begin(), _bags.end(), isWritten));
    return numBags + countPictures(_model.getMainChapter(), first, end);
}

std::size_t BookletSteps::countPictures(const BookletChapter& chapter, std::size_t first, std::size_t end) const
{
    std::size_t number = end - first;
    for (std::size_t step = first; step < end; ++step)
        for (const std::size_t submodel : _model.getOriginals(chapter.steps[step]))
        {
            const BookletChapter& own = _model.getChapters()[submodel];
            number += 1 + (_isWhole[submodel] ? 0 : countPictures(own, 0, own.steps.size()));
        }
    return number;
}

} // namespace osgLego
