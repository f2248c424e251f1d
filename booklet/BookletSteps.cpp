#include "BookletSteps.h"

#include "BookletText.h"
#include "SheetMeasures.h"

#include <common/NumberText.h>

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

/** Join words, as in "a, b and c". */
std::string joinWords(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t word = 0; word < words.size(); ++word)
        text += (word == 0 ? "" : word + 1 < words.size() ? ", " : " and ") + words[word];
    return text;
}

std::string nameSubmodel(const BookletChapter& chapter)
{
    return "submodel-" + osgDB::convertToLowerCase(chapter.letter);
}

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

/** The place of a block on its sheet, for the style sheet. */
std::string formatPlace(const PlacedBlock& place)
{
    return fmt::format(R"( style="--block:{:.2f};--space:{:.2f};--scale:{:.3f}")", place.height / place.scale,
                       place.space / place.scale, place.scale);
}

std::string nameStep(const BookletStep& step)
{
    return "step-" + osgDB::convertToLowerCase(step.name);
}

} // namespace

BookletSteps::BookletSteps(const BookletModel& model, BookletPictureSource& pictures,
                           const std::function<void(const std::string&)>& progress, BookletMarkup& markup) :
    _model(model),
    _pictures(pictures), _progress(progress), _markup(markup), _similarColors(model), _isWhole(findWhole()),
    _blocks(model, _isWhole), _bags(createBags(_blocks.getBlocks())), _submodelSizes(model.getChapters().size())
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
        isWhole.push_back(chapter > 0 && isOneStep && !hasSubmodels && _pictures.showsAllParts(chapter));
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

/** Write blocks on sheets of their own. @param bag null without one. */
void BookletSteps::writeSection(std::span<const BookletBlock> blocks, const BookletBag* bag)
{
    const SheetMeasures measures(_model, _pictures, _markup, _isWhole);
    std::vector<SheetBlock> sizes;
    sizes.reserve(blocks.size());
    const std::size_t main = findMainChapter(blocks);
    for (const BookletBlock& block : blocks)
        sizes.push_back(block.isContents ? measures.measureSubmodel(block.chapter)
                                         : measures.measureStep(block.chapter, block.step, block.chapter == main));
    const SheetHeader header = bag ? measures.measureHeader(bag->items) : SheetHeader();
    const SheetArrangement arrangement(sizes, header.height);
    for (const Sheet& sheet : arrangement.getSheets())
    {
        _markup.getStream() << "<div class=\"sheet\">\n";
        if (bag && &sheet == &arrangement.getSheets().front()) writeBag(*bag, header.scale);
        writeSheet(blocks, sheet);
        _markup.getStream() << "</div>\n";
    }
}

void BookletSteps::writeSheet(std::span<const BookletBlock> blocks, const Sheet& sheet)
{
    if (sheet.columns.empty()) return; // below the header of a bag
    std::size_t numParts = 0;
    std::set<std::size_t> kinds;
    _markup.getStream() << "<div class=\"columns\" style=\"--columns:" << sheet.numColumns << "\">\n";
    for (const SheetColumn& column : sheet.columns)
    {
        _markup.getStream() << "<div class=\"column\">\n";
        for (const PlacedBlock& place : column)
        {
            writeBlock(blocks[place.block], place);
            numParts += sumQuantities(blocks[place.block].placed);
            addKinds(blocks[place.block], kinds);
        }
        _markup.getStream() << "</div>\n";
    }
    _markup.getStream() << "</div>\n";
    writeLastLine(numParts, kinds);
}

/** Write the line below the steps of a sheet: names of similar colours, and the number of parts. */
void BookletSteps::writeLastLine(std::size_t numParts, const std::set<std::size_t>& kinds)
{
    _markup.getStream() << "<footer class=\"last-line\">";
    if (const std::vector<std::size_t> chosen = _similarColors.chooseKinds(kinds); !chosen.empty())
    {
        std::vector<std::string> names(chosen.size());
        std::transform(chosen.begin(), chosen.end(), names.begin(),
                       [this](std::size_t kind) { return _markup.nameColorOf(kind); });
        _markup.getStream() << fmt::format(R"(<ul class="colors" aria-label="Similar colours" style="--scale:{:.3f}">)",
                                           SheetMeasures::findScaleOfColors(names));
        for (const std::size_t kind : chosen)
        {
            _markup.getStream() << "<li>";
            _markup.writeSwatch(kind);
            _markup.getStream() << "</li>";
        }
        _markup.getStream() << "</ul>";
    }
    _markup.getStream() << "<p class=\"sheet-parts\">" << countOf(numParts, "part") << " in these steps</p></footer>\n";
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
    if (block.isContents && !own.isListed()) return;
    if (block.isContents) return add(own.items);
    add(own.steps[block.step].items);
    for (const std::size_t submodel : own.steps[block.step].submodels)
        if (_model.getChapters()[submodel].isCallout()) add(_model.getChapters()[submodel].items);
}

/** @param scale of its texts and lists. */
void BookletSteps::writeBag(const BookletBag& bag, double scale)
{
    const auto number = &bag - _bags.data() + 1;
    _markup.getStream() << fmt::format("<header class=\"bag\" id=\"bag-{0}\" data-stop=\"Bag {0} of {1}\" "
                                       "style=\"--scale:{4:.3f}\">\n<h2>Bag {0} <span>of {1}</span></h2>\n<p>{2} of "
                                       "{3}</p>\n<ul class=\"callout\">\n",
                                       number, _bags.size(), countOf(bag.countParts(), "part"),
                                       countOf(bag.items.size(), "kind"), scale);
    _markup.writeItems(bag.items);
    _markup.getStream() << "</ul>\n</header>\n";
}

void BookletSteps::writeBlock(const BookletBlock& block, const PlacedBlock& place)
{
    if (block.isContents)
        writeContents(block.chapter, place);
    else
        writeStep(block.chapter, block.step, place);
}

std::size_t BookletSteps::countPictures(std::size_t first, std::size_t end) const
{
    return countPictures(_model.getMainChapter(), first, end);
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

/** Draw a finished submodel, as a symbol that the page uses several times. */
void BookletSteps::drawSubmodel(std::size_t chapter)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    _progress("submodel " + own.letter);
    const BookletPicture picture = _pictures.drawFinished(chapter);
    _submodelSizes[chapter] = glm::dvec2(picture.width, picture.height) / picture.density;
    _markup.getStream() << "<svg class=\"symbols\" aria-hidden=\"true\">";
    _markup.writeSymbol(nameSubmodel(own) + "-picture", picture);
    _markup.getStream() << "</svg>\n";
}

/** Write the parts of a submodel of many parts, unless they are too many, and how it looks when it is finished. */
void BookletSteps::writeContents(std::size_t chapter, const PlacedBlock& place)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    drawSubmodel(chapter);
    _markup.getStream() << "<section class=\"submodel\" id=\"" << nameSubmodel(own) << "\" data-stop=\"Submodel "
                        << own.letter << "\"" << formatPlace(place) << ">\n<header><h3>" << own.letter
                        << "<span class=\"hidden\">: submodel</span></h3>\n";
    writeMultiplier(own);
    if (own.isListed())
    {
        _markup.getStream() << "<ul class=\"callout\">\n";
        _markup.writeItems(own.items);
        _markup.getStream() << "</ul>";
    }
    const double width = SheetMeasures(_model, _pictures, _markup, _isWhole).measureContents(chapter).x;
    _markup.getStream() << "</header>\n<figure style=\"--print:" << fmt::format("{:.2f}", width) << "\">";
    writeUseOfSubmodel(chapter, _isWhole[chapter] ? describeStep(own, own.steps.front())
                                                  : "Submodel " + own.letter + ", finished");
    _markup.getStream() << "</figure>\n</section>\n";
}

/** Write the submodels of few parts that a step attaches, each in a box. */
void BookletSteps::writeBoxes(const BookletStep& step)
{
    std::vector<std::size_t> small = _model.getOriginals(step);
    std::erase_if(small, [this](std::size_t submodel) { return !_model.getChapters()[submodel].isCallout(); });
    if (small.empty()) return;
    _markup.getStream() << "<div class=\"boxes\">\n";
    for (const std::size_t submodel : small)
        writeBox(submodel);
    _markup.getStream() << "</div>\n";
}

void BookletSteps::writeBox(std::size_t chapter)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    drawSubmodel(chapter);
    _markup.getStream() << "<section class=\"box\" id=\"" << nameSubmodel(own) << "\">\n<header><h4>" << own.letter
                        << "<span class=\"hidden\">: submodel</span></h4>\n";
    writeMultiplier(own);
    _markup.getStream() << "<ul class=\"items\">\n";
    _markup.writeItems(own.items);
    _markup.getStream() << "</ul></header>\n";
    for (std::size_t step = 0; step < own.steps.size() && !_isWhole[chapter]; ++step)
        writeSmallStep(chapter, step);
    _markup.getStream() << "<figure>";
    writeUseOfSubmodel(chapter, "Submodel " + own.letter + ", finished");
    _markup.getStream() << "</figure>\n</section>\n";
}

/** Write a step of a submodel of few parts: the box lists them, and the step shows where they are. */
void BookletSteps::writeSmallStep(std::size_t chapter, std::size_t index)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& step = own.steps[index];
    writeBoxes(step);
    _progress(fmt::format("step {} of {}", step.name, own.steps.size()));
    const BookletPicture picture = _pictures.drawStep(chapter, index);
    _markup.getStream() << "<div class=\"small-step\" id=\"" << nameStep(step) << "\"><h5>" << step.name << "</h5>";
    writeTurn(step);
    writeFrame(chapter, step, picture, SheetMeasures::toBox(glm::dvec2(picture.width / picture.pitch)).x);
    _markup.getStream() << "</div>\n";
}

void BookletSteps::writeStep(std::size_t chapter, std::size_t index, const PlacedBlock& place)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& step = own.steps[index];
    _markup.getStream() << "<section class=\"step" << (chapter > 0 ? " of-submodel" : "") << "\" id=\""
                        << nameStep(step) << "\" data-stop=\"Step " << step.name << " of " << own.steps.size() << "\""
                        << formatPlace(place) << ">\n<header>";
    writeNumber(step);
    writeCallout(step);
    writeTurn(step);
    _markup.getStream() << "</header>\n";
    writeBoxes(step);
    writeNote(step);
    _progress(fmt::format("step {} of {}", step.name, own.steps.size()));
    const BookletPicture picture = _pictures.drawStep(chapter, index);
    _markup.getStream() << "<figure class=\"model\">";
    writeFrame(chapter, step, picture, picture.width / picture.pitch * place.pitch / place.scale);
    _markup.getStream() << "</figure>\n</section>\n";
}

void BookletSteps::writeNumber(const BookletStep& step)
{
    _markup.getStream() << "<div class=\"number\"><h3><span class=\"hidden\">Step </span>" << step.name << "</h3><p>"
                        << countOf(step.numNew, "part") << "</p></div>\n";
}

/** List the parts, and the submodels of many parts, that a step adds. */
void BookletSteps::writeCallout(const BookletStep& step)
{
    std::vector<std::size_t> large = _model.getOriginals(step);
    std::erase_if(large, [this](std::size_t submodel) { return _model.getChapters()[submodel].isCallout(); });
    if (large.empty() && step.items.empty()) return;
    _markup.getStream() << "<ul class=\"callout\">\n";
    for (const std::size_t submodel : large)
    {
        const BookletChapter& own = _model.getChapters()[submodel];
        _markup.getStream() << "<li>";
        writeUseOfSubmodel(submodel, "Submodel " + own.letter);
        _markup.getStream() << "<span class=\"letter\" aria-hidden=\"true\">" << own.letter << "</span>";
        writeMultiplier(own);
        _markup.getStream() << "</li>\n";
    }
    _markup.writeItems(step.items);
    _markup.getStream() << "</ul>\n";
}

void BookletSteps::writeTurn(const BookletStep& step)
{
    if (!step.isTurned) return;
    _markup.getStream() << "<svg class=\"turn\" role=\"img\" aria-label=\"Turn the model"
                        << (step.isUpsideDown ? " upside down" : "") << "\"><use href=\""
                        << (step.isUpsideDown ? "#turn-over" : "#turn") << "\"/></svg>\n";
}

/** Say whether the builder must hold something. */
void BookletSteps::writeNote(const BookletStep& step)
{
    if (step.numUnheld > 0)
        _markup.getStream() << "<p class=\"note\">Nothing holds " << countOf(step.numUnheld, "part")
                            << " of this step.</p>\n";
    else if (step.falls())
        _markup.getStream()
            << "<p class=\"note\">Hold the model after this step: it does not stand by itself yet.</p>\n";
}

/** @param width of the picture on a sheet, in millimetres. */
void BookletSteps::writeFrame(std::size_t chapter, const BookletStep& step, const BookletPicture& picture, double width)
{
    _markup.getStream() << fmt::format(
        R"(<div class="frame" style="--aspect:{:.4f};--ratio:{:.4f};--width:{:.0f}px;--print:{:.2f}">)",
        _pictures.getAspect(chapter), static_cast<double>(picture.width) / picture.height,
        picture.width / picture.density, width);
    _markup.writeImage(picture, describeStep(_model.getChapters()[chapter], step));
    std::vector<std::string> letters;
    if (step.hasLetters())
        for (const std::size_t submodel : step.submodels)
            letters.push_back(_model.getChapters()[submodel].letter);
    _markup.writeArrows(picture, letters);
    _markup.getStream() << "</div>";
}

void BookletSteps::writeUseOfSubmodel(std::size_t chapter, const std::string& text)
{
    _markup.writeUse(nameSubmodel(_model.getChapters()[chapter]) + "-picture", text, _submodelSizes[chapter]);
}

/** Say how often a submodel is built, if it is several times. */
void BookletSteps::writeMultiplier(const BookletChapter& chapter)
{
    if (chapter.quantity > 1)
        _markup.getStream() << "<span class=\"multiplier\"><span class=\"hidden\">Build it </span>" << chapter.quantity
                            << "×</span>";
}

std::string BookletSteps::describeSubmodels(std::size_t chapter) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    return own.quantity == 1 ? "submodel " + own.letter : fmt::format("{} submodels {}", own.quantity, own.letter);
}

std::string BookletSteps::describeStep(const BookletChapter& chapter, const BookletStep& step) const
{
    std::vector<std::string> added;
    for (const BookletItem& item : step.items)
        added.push_back(describeParts(_model.getKinds()[item.kind], item.quantity));
    for (const std::size_t submodel : _model.getOriginals(step))
        added.push_back(describeSubmodels(submodel));
    return fmt::format("Step {} of {}: adds {}", step.name, chapter.steps.size(), joinWords(added));
}

} // namespace osgLego
