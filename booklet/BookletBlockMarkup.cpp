#include "BookletBlockMarkup.h"

#include "BookletText.h"
#include "SheetMeasures.h"

#include <common/NumberText.h>

#include <algorithm>

#include <fmt/format.h>
#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

std::string nameSubmodel(const BookletChapter& chapter)
{
    return "submodel-" + osgDB::convertToLowerCase(chapter.letter);
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

BookletBlockMarkup::BookletBlockMarkup(const BookletModel& model, BookletPictureSource& pictures,
                                       const std::function<void(const std::string&)>& progress, BookletMarkup& markup,
                                       const std::vector<bool>& isWhole) :
    _model(model),
    _pictures(pictures), _progress(progress), _markup(markup), _isWhole(isWhole)
{
}

void BookletBlockMarkup::write(const BookletBlock& block, const PlacedBlock& place)
{
    if (block.isContents)
        writeContents(block, place);
    else
    {
        if (block.isSubmodel) drawSubmodel(block.chapter);
        writeStep(block.chapter, block.step, place);
    }
}

/** Draw a finished submodel, as a symbol that the page uses several times. */
void BookletBlockMarkup::drawSubmodel(std::size_t chapter)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    _progress("submodel " + own.letter);
    const BookletPicture picture = _pictures.drawFinished(chapter);
    _markup.getStream() << "<svg class=\"symbols\" aria-hidden=\"true\">";
    _markup.writeSymbol(nameSubmodel(own) + "-picture", picture);
    _markup.getStream() << "</svg>\n";
}

/** Write the parts of a submodel of many parts, unless they are too many, and how it looks when it is finished. */
void BookletBlockMarkup::writeContents(const BookletBlock& block, const PlacedBlock& place)
{
    const std::size_t chapter = block.chapter;
    const BookletChapter& own = _model.getChapters()[chapter];
    if (block.isContinued) return writeMoreContents(block, place);
    drawSubmodel(chapter);
    _markup.getStream() << "<section class=\"submodel\" id=\"" << nameSubmodel(own) << "\" data-stop=\"Submodel "
                        << own.letter << "\"" << formatPlace(place) << ">\n<header><h3>" << own.letter
                        << "<span class=\"hidden\">: submodel</span></h3>\n";
    writeList(block.submodels, block.items);
    const double width = SheetMeasures(_model, _pictures, _markup, _isWhole).measureContents(chapter).x;
    _markup.getStream() << "</header>\n<figure style=\"--print:" << fmt::format("{:.2f}", width) << "\">";
    writeUseOfSubmodel(chapter, _isWhole[chapter] ? describeStep(own, own.steps.front())
                                                  : "Submodel " + own.letter + ", finished");
    writeMultiplier(own);
    _markup.getStream() << "</figure>\n</section>\n";
}

/** Write the rest of a list of parts that is too long for one sheet. */
void BookletBlockMarkup::writeMoreContents(const BookletBlock& block, const PlacedBlock& place)
{
    const BookletChapter& own = _model.getChapters()[block.chapter];
    _markup.getStream() << "<section class=\"submodel continued\" data-of=\"" << nameSubmodel(own) << "\""
                        << formatPlace(place) << ">\n<p>More parts of " << own.letter << "</p>\n<header>";
    writeList({}, block.items);
    _markup.getStream() << "</header>\n</section>\n";
}

/** List submodels of many parts, whose symbols may follow, and parts. */
void BookletBlockMarkup::writeList(const std::vector<std::size_t>& submodels, const std::vector<BookletItem>& items)
{
    if (submodels.empty() && items.empty()) return;
    _markup.getStream() << "<ul class=\"callout\">\n";
    for (const std::size_t submodel : submodels)
    {
        const BookletChapter& own = _model.getChapters()[submodel];
        _markup.getStream() << "<li class=\"attached\">";
        writeUseOfSubmodel(submodel, "Submodel " + own.letter);
        _markup.getStream() << "<span class=\"letter\" aria-hidden=\"true\">" << own.letter << "</span>";
        writeMultiplier(own);
        _markup.getStream() << "</li>\n";
    }
    _markup.writeItems(items);
    _markup.getStream() << "</ul>\n";
}

/** Write the submodels of few parts that a step attaches, each in a box. */
void BookletBlockMarkup::writeBoxes(const BookletStep& step)
{
    std::vector<std::size_t> small = _model.getOriginals(step);
    std::erase_if(small, [this](std::size_t submodel) { return !_model.getChapters()[submodel].isCallout(); });
    if (small.empty()) return;
    _markup.getStream() << "<div class=\"boxes\">\n";
    for (const std::size_t submodel : small)
        writeBox(submodel);
    _markup.getStream() << "</div>\n";
}

void BookletBlockMarkup::writeBox(std::size_t chapter)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    drawSubmodel(chapter);
    _markup.getStream() << "<section class=\"box\" id=\"" << nameSubmodel(own) << "\">\n<header><h4>" << own.letter
                        << "<span class=\"hidden\">: submodel</span></h4>\n<ul class=\"items\">\n";
    _markup.writeItems(own.items);
    _markup.getStream() << "</ul></header>\n";
    for (std::size_t step = 0; step < own.steps.size() && !_isWhole[chapter]; ++step)
        writeSmallStep(chapter, step);
    _markup.getStream() << "<figure>";
    writeUseOfSubmodel(chapter, "Submodel " + own.letter + ", finished");
    writeMultiplier(own);
    _markup.getStream() << "</figure>\n</section>\n";
}

/** Write a step of a submodel of few parts: the box lists them, and the step shows where they are. */
void BookletBlockMarkup::writeSmallStep(std::size_t chapter, std::size_t index)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& step = own.steps[index];
    writeBoxes(step);
    _progress(fmt::format("step {} of {}", step.name, own.steps.size()));
    const BookletPicture picture = _pictures.drawStep(chapter, index);
    _markup.getStream() << "<div class=\"small-step\" id=\"" << nameStep(step) << "\"><div class=\"number\"><h5>"
                        << step.name << "</h5>";
    writeTurn(step);
    _markup.getStream() << "</div>";
    writeFrame(chapter, step, picture, SheetMeasures::toBox(glm::dvec2(picture.width / picture.pitch)).x);
    _markup.getStream() << "</div>\n";
}

void BookletBlockMarkup::writeStep(std::size_t chapter, std::size_t index, const PlacedBlock& place)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& step = own.steps[index];
    _markup.getStream() << "<section class=\"step" << (chapter > 0 ? " of-submodel" : "") << "\" id=\""
                        << nameStep(step) << "\" data-stop=\"Step " << step.name << " of " << own.steps.size() << "\""
                        << formatPlace(place) << ">\n<header>";
    writeNumber(step);
    writeCallout(step);
    _markup.getStream() << "</header>\n";
    writeBoxes(step);
    writeNote(own, step);
    _progress(fmt::format("step {} of {}", step.name, own.steps.size()));
    const BookletPicture picture = _pictures.drawStep(chapter, index);
    _markup.getStream() << "<figure class=\"model\">";
    writeFrame(chapter, step, picture, picture.width / picture.pitch * place.pitch / place.scale);
    _markup.getStream() << "</figure>\n</section>\n";
}

void BookletBlockMarkup::writeNumber(const BookletStep& step)
{
    _markup.getStream() << "<div class=\"number\"><h3><span class=\"hidden\">Step </span>" << step.name << "</h3><p>"
                        << describeCount(_model, step) << "</p>";
    writeTurn(step);
    _markup.getStream() << "</div>\n";
}

/** List the parts, and the submodels of many parts, that a step adds. */
void BookletBlockMarkup::writeCallout(const BookletStep& step)
{
    std::vector<std::size_t> large = _model.getOriginals(step);
    std::erase_if(large, [this](std::size_t submodel) { return _model.getChapters()[submodel].isCallout(); });
    writeList(large, step.items);
}

void BookletBlockMarkup::writeTurn(const BookletStep& step)
{
    if (!step.isTurned) return;
    _markup.getStream() << "<svg class=\"turn\" role=\"img\" aria-label=\"Turn the model"
                        << (step.isTurnedOver ? " upside down" : "") << "\"><use href=\""
                        << (step.isTurnedOver ? "#turn-over" : "#turn") << "\"/></svg>";
}

/** Write what the picture of a step does not show, if anything. */
void BookletBlockMarkup::writeNote(const BookletChapter& chapter, const BookletStep& step)
{
    if (const std::string note = describeNotes(_model, chapter, step); !note.empty())
        _markup.getStream() << "<p class=\"note\">" << note << "</p>\n";
}

/** @param width of the picture on a sheet, in millimetres. */
void BookletBlockMarkup::writeFrame(std::size_t chapter, const BookletStep& step, const BookletPicture& picture,
                                    double width)
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

void BookletBlockMarkup::writeUseOfSubmodel(std::size_t chapter, const std::string& text)
{
    _markup.writeUse(nameSubmodel(_model.getChapters()[chapter]) + "-picture", text,
                     _pictures.measureFinished(chapter));
}

/** Say how often a submodel is built, if it is several times. */
void BookletBlockMarkup::writeMultiplier(const BookletChapter& chapter)
{
    if (chapter.quantity > 1)
        _markup.getStream() << "<span class=\"multiplier\"><span class=\"hidden\">Build it </span>" << chapter.quantity
                            << "×</span>";
}

std::string BookletBlockMarkup::describeSubmodels(std::size_t chapter) const
{
    const BookletChapter& own = _model.getChapters()[chapter];
    return own.quantity == 1 ? "submodel " + own.letter : fmt::format("{} submodels {}", own.quantity, own.letter);
}

std::string BookletBlockMarkup::describeStep(const BookletChapter& chapter, const BookletStep& step) const
{
    std::vector<std::string> added;
    for (const BookletItem& item : step.items)
        added.push_back(describeParts(_model.getKinds()[item.kind], item.quantity));
    for (const std::size_t submodel : _model.getOriginals(step))
        added.push_back(describeSubmodels(submodel));
    return fmt::format("Step {} of {}: adds {}", step.name, chapter.steps.size(), joinWords(added));
}

} // namespace osgLego
