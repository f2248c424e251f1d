#include "BookletPage.h"

#include "Base64.h"
#include "BookletText.h"

#include <common/MarkupText.h>
#include <common/NumberText.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <osgDB/FileNameUtils>

namespace osgLego
{

/** Booklet.css, Booklet.js and Booklet.svg, the symbols, embedded at build time. */
const std::map<std::string_view, std::string_view>& getBookletTexts();

namespace
{

constexpr double BRICKS_PER_MINUTE_SLOW = 3.0;
constexpr double BRICKS_PER_MINUTE_FAST = 10.0;

std::string dataOf(const std::string& mediaType, const std::string& bytes)
{
    return "data:" + mediaType + ";base64," + toBase64(bytes);
}

/** Format a time in minutes or, from two hours on, in hours. */
std::string formatMinutes(double minutes)
{
    constexpr double HOUR = 60.0;
    return minutes < 2.0 * HOUR ? fmt::format("{:.0f} min", std::max(1.0, minutes))
                                : fmt::format("{:.0f} h", minutes / HOUR);
}

std::string formatTime(std::size_t numParts)
{
    const auto number = static_cast<double>(numParts);
    const std::string fast = formatMinutes(number / BRICKS_PER_MINUTE_FAST);
    const std::string slow = formatMinutes(number / BRICKS_PER_MINUTE_SLOW);
    return fast == slow ? fast : fast + " to " + slow;
}

std::string formatMass(double grams)
{
    return grams < 1000.0 ? fmt::format("{:.0f} g", std::max(1.0, grams)) : fmt::format("{:.2f} kg", 0.001 * grams);
}

/** Join words, as in "a, b and c". */
std::string joinWords(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t word = 0; word < words.size(); ++word)
        text += (word == 0 ? "" : word + 1 < words.size() ? ", " : " and ") + words[word];
    return text;
}

/** Whether the picture of a finished submodel shows its only step. */
bool isShort(const BookletChapter& chapter)
{
    return chapter.steps.size() == 1 && chapter.steps.front().submodels.empty() && !chapter.steps.front().isUpsideDown;
}

/** An arrow as a path of SVG: a shaft and a head, as wide as three shafts. */
std::string drawArrow(const BookletArrow& arrow)
{
    const glm::dvec2 along = glm::normalize(arrow.tip - arrow.tail);
    const glm::dvec2 across = glm::dvec2(-along.y, along.x) * (0.5 * arrow.width);
    const glm::dvec2 neck = arrow.tip - along * (2.0 * arrow.width);
    std::string path;
    for (const glm::dvec2& corner : {arrow.tail + across, neck + across, neck + 3.0 * across, arrow.tip,
                                     neck - 3.0 * across, neck - across, arrow.tail - across})
        path += fmt::format("{}{:.0f} {:.0f}", path.empty() ? "M" : "L", corner.x, corner.y);
    return path + "Z";
}

} // namespace

BookletPage::BookletPage(const BookletModel& model, const BookletFacts& facts, BookletPictureSource& pictures,
                         std::function<void(const std::string&)> progress) :
    _model(model),
    _facts(facts), _pictures(pictures), _progress(std::move(progress)), _submodelSizes(model.getChapters().size())
{
}

void BookletPage::write(std::ostream& stream)
{
    _stream = &stream;
    writeHead();
    writeCover();
    writePartsList();
    writeSteps();
    writeFinished();
    stream << "</main>\n<script>\n" << getBookletTexts().at("Booklet.js") << "</script>\n</body>\n</html>\n";
}

std::size_t BookletPage::countPictures() const
{
    constexpr std::size_t COVER_AND_END = 2;
    return COVER_AND_END + _model.getKinds().size() + (_model.getBasePlate() ? 1 : 0) +
           countStepPictures(_model.getMainChapter(), _facts.firstStep, _facts.endStep);
}

std::size_t BookletPage::countStepPictures(const BookletChapter& chapter, std::size_t first, std::size_t end) const
{
    std::size_t number = end - first;
    for (std::size_t step = first; step < end; ++step)
        for (const std::size_t submodel : chapter.steps[step].submodels)
        {
            const BookletChapter& own = _model.getChapters()[submodel];
            number += 1 + (isShort(own) ? 0 : countStepPictures(own, 0, own.steps.size()));
        }
    return number;
}

void BookletPage::writeHead()
{
    *_stream << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             << "<meta name=\"generator\" content=\"osgLego\">\n<title>" << escapedForMarkup(_facts.title)
             << ": building instructions</title>\n<style>\n"
             << getBookletTexts().at("Booklet.css") << "</style>\n</head>\n<body>\n"
             << "<svg class=\"symbols\" aria-hidden=\"true\">" << getBookletTexts().at("Booklet.svg")
             << "</svg>\n<main>\n";
}

void BookletPage::writeCover()
{
    _progress("cover");
    *_stream << "<section class=\"cover\" id=\"cover\" data-stop=\"Cover\">\n<h1>" << escapedForMarkup(_facts.title)
             << "</h1>\n<p class=\"subtitle\">Building instructions"
             << (_facts.author.empty() ? std::string() : " by " + escapedForMarkup(_facts.author))
             << "</p>\n<figure class=\"picture\">";
    writeImage(_pictures.drawFinished(0), "The finished model: " + _facts.title);
    *_stream << "</figure>\n";
    if (!_facts.warnings.empty())
    {
        *_stream << "<ul class=\"warnings\">\n";
        for (const std::string& warning : _facts.warnings)
            *_stream << "<li>" << escapedForMarkup(warning) << "</li>\n";
        *_stream << "</ul>\n";
    }
    writeFacts();
    *_stream << "</section>\n";
}

void BookletPage::writeFacts()
{
    const glm::dvec3 size = _model.getSize();
    constexpr double PITCH = 8.0;
    const std::size_t numSteps = _model.getMainChapter().steps.size();
    std::string steps = formatNumber(_model.getNumSteps());
    if (_model.getNumSteps() > numSteps)
        steps += fmt::format(", {} of them in submodels", formatNumber(_model.getNumSteps() - numSteps));
    if (_facts.endStep - _facts.firstStep < numSteps)
        steps = fmt::format("{} to {} of {}", _facts.firstStep + 1, _facts.endStep, formatNumber(numSteps));
    const std::vector<std::pair<std::string, std::string>> rows{
        {"Parts", formatNumber(_model.getNumParts())},
        {"Pieces", formatNumber(_model.getNumPieces())},
        {"Steps", steps},
        {"Footprint", fmt::format("{:.0f} × {:.0f} studs", size.x / PITCH, size.y / PITCH)},
        {"Size", fmt::format("{:.1f} × {:.1f} × {:.1f} cm", 0.1 * size.x, 0.1 * size.y, 0.1 * size.z)},
        {"Mass", formatMass(_model.getMass())},
        {"Building time", formatTime(_model.getNumParts())}};
    *_stream << "<dl class=\"facts\">\n";
    for (const auto& [name, value] : rows)
        *_stream << "<div><dt>" << name << "</dt><dd>" << value << "</dd></div>\n";
    *_stream << "</dl>\n";
}

void BookletPage::writePartsList()
{
    const std::vector<PartsList::Row>& kinds = _model.getKinds();
    *_stream << "<svg class=\"symbols\" aria-hidden=\"true\">\n";
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    {
        _progress(fmt::format("part {} of {}", kind + 1, kinds.size()));
        const BookletPicture picture = _pictures.drawKind(kind);
        writeSymbol("part-" + std::to_string(kind + 1), picture);
        _kindSizes.push_back(glm::dvec2(picture.width, picture.height) / picture.density);
    }
    *_stream << "</svg>\n<section class=\"section\" id=\"parts\" data-stop=\"Parts\">\n<h2>Parts</h2>\n"
             << "<p class=\"subtitle\">" << countOf(_model.getNumParts(), "part") << " of "
             << countOf(kinds.size(), "kind") << "</p>\n<ul class=\"parts\">\n";
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    {
        const PartsList::Row& row = kinds[kind];
        *_stream << "<li>";
        writeUse("part-" + std::to_string(kind + 1), describeParts(row, row.quantity), _kindSizes[kind]);
        writeDetails(row);
        *_stream << "</li>\n";
    }
    if (_model.getBasePlate()) writeBasePlate();
    *_stream << "</ul>\n</section>\n";
}

/** The base plate at the end of the parts, none of which it is. */
void BookletPage::writeBasePlate()
{
    const BasePlate& plate = *_model.getBasePlate();
    _progress("base plate");
    const BookletPicture picture = _pictures.drawBasePlate();
    *_stream << "<li class=\"base-plate\">";
    writeImage(picture, fmt::format("{} in green", plate.getName()));
    *_stream << "<p><span class=\"quantity\">" << plate.getQuantity() << "×</span> <span><span class=\"name\">"
             << plate.getName() << "</span> <span class=\"code\">" << plate.getNumber()
             << "</span></span> <span>Green, drawn smaller</span> <span class=\"code\"><span>BrickLink\u00a06</span> "
             << "<span>LDraw\u00a02</span></span></p></li>\n";
}

/** The text below the picture of a part: all that is needed to order it. */
void BookletPage::writeDetails(const PartsList::Row& row)
{
    const std::string name = nameColor(row.color);
    const std::string brickLinkName = nameBrickLinkColor(row.color);
    std::vector<std::string> codes;
    if (row.color.brickLink >= 0) codes.push_back("BrickLink\u00a0" + std::to_string(row.color.brickLink));
    if (row.color.code != Part::NO_CODE)
        codes.push_back("LDraw\u00a0" + std::to_string(row.color.code) +
                        (name == brickLinkName ? std::string() : " " + name));
    std::string text;
    for (const std::string& code : codes)
        text += (text.empty() ? "<span>" : " <span>") + escapedForMarkup(code) + "</span>";
    *_stream << "<p><span class=\"quantity\">" << formatNumber(row.quantity) << "×</span> <span><span class=\"name\">"
             << escapedForMarkup(nameType(*row.type)) << "</span> <span class=\"code\">" << row.type->number
             << "</span></span> <span>" << escapedForMarkup(brickLinkName.empty() ? name : brickLinkName)
             << "</span> <span class=\"code\">" << text << "</span></p>";
}

void BookletPage::writeSteps()
{
    *_stream << "<section class=\"steps\" id=\"steps\">\n<h2 class=\"hidden\">Steps</h2>\n";
    for (std::size_t step = _facts.firstStep; step < _facts.endStep; ++step)
        writeStep(0, step);
    *_stream << "</section>\n";
}

void BookletPage::writeSubmodels(const BookletStep& step)
{
    for (const std::size_t submodel : step.submodels)
        writeSubmodel(submodel);
}

void BookletPage::writeSubmodel(std::size_t chapter)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const std::string id = "submodel-" + osgDB::convertToLowerCase(own.letter);
    _progress("submodel " + own.letter);
    const BookletPicture picture = _pictures.drawFinished(chapter);
    _submodelSizes[chapter] = glm::dvec2(picture.width, picture.height) / picture.density;
    *_stream << "<svg class=\"symbols\" aria-hidden=\"true\">";
    writeSymbol(id + "-picture", picture);
    *_stream << "</svg>\n<section class=\"submodel\" id=\"" << id << "\">\n<div class=\"intro\" data-stop=\"Submodel "
             << own.letter << "\">\n<header><h3>" << own.letter << "<span class=\"hidden\">: submodel</span></h3>\n"
             << "<ul class=\"callout\">\n";
    writeItems(own.items);
    *_stream << "</ul></header>\n<figure>";
    const bool isWhole = isShort(own);
    writeUse(id + "-picture", isWhole ? describeStep(own, own.steps.front()) : "Submodel " + own.letter + ", finished",
             _submodelSizes[chapter]);
    *_stream << "</figure></div>\n";
    for (std::size_t step = 0; step < own.steps.size() && !isWhole; ++step)
        writeStep(chapter, step);
    *_stream << "</section>\n";
}

void BookletPage::writeStep(std::size_t chapter, std::size_t index)
{
    const BookletChapter& own = _model.getChapters()[chapter];
    const BookletStep& step = own.steps[index];
    writeSubmodels(step);
    _progress(fmt::format("step {} of {}", step.name, own.steps.size()));
    const BookletPicture picture = _pictures.drawStep(chapter, index);
    *_stream << "<section class=\"step\" id=\"step-" << osgDB::convertToLowerCase(step.name) << "\" data-stop=\"Step "
             << step.name << " of " << own.steps.size() << "\">\n<header><h3><span class=\"hidden\">Step </span>"
             << step.name << "</h3>\n";
    writeCallout(step);
    if (step.isTurned)
        *_stream << "<svg class=\"turn\" role=\"img\" aria-label=\"Turn the model"
                 << (step.isUpsideDown ? " upside down" : "") << "\"><use href=\""
                 << (step.isUpsideDown ? "#turn-over" : "#turn") << "\"/></svg>\n";
    *_stream << "</header>\n";
    writeNote(step);
    *_stream << "<figure class=\"model\">"
             << fmt::format(R"(<div class="frame" style="--aspect:{:.4f};--width:{:.0f}px">)",
                            _pictures.getAspect(chapter), picture.width / picture.density);
    writeImage(picture, describeStep(own, step));
    writeArrows(step, picture);
    *_stream << "</div></figure>\n</section>\n";
}

void BookletPage::writeCallout(const BookletStep& step)
{
    *_stream << "<ul class=\"callout\">\n";
    for (const std::size_t submodel : step.submodels)
    {
        const std::string& letter = _model.getChapters()[submodel].letter;
        *_stream << "<li>";
        writeUse("submodel-" + osgDB::convertToLowerCase(letter) + "-picture", "Submodel " + letter,
                 _submodelSizes[submodel]);
        *_stream << "<span class=\"letter\" aria-hidden=\"true\">" << letter << "</span></li>\n";
    }
    writeItems(step.items);
    *_stream << "</ul>\n";
}

/** Say whether the builder must hold something. */
void BookletPage::writeNote(const BookletStep& step)
{
    if (step.numUnheld > 0)
        *_stream << "<p class=\"note\">Nothing holds " << countOf(step.numUnheld, "part") << " of this step.</p>\n";
    else if (step.falls())
        *_stream << "<p class=\"note\">Hold the model after this step: it does not stand by itself yet.</p>\n";
}

void BookletPage::writeArrows(const BookletStep& step, const BookletPicture& picture)
{
    if (picture.arrows.empty()) return;
    *_stream << fmt::format(R"(<svg class="arrows" aria-hidden="true" viewBox="0 0 {} {}">)", picture.width,
                            picture.height);
    for (std::size_t index = 0; index < picture.arrows.size(); ++index)
    {
        const BookletArrow& arrow = picture.arrows[index];
        *_stream << "<path d=\"" << drawArrow(arrow) << "\"/>";
        if (step.submodels.size() > 1 && index < step.submodels.size())
            *_stream << fmt::format(R"(<text x="{:.0f}" y="{:.0f}" font-size="{:.0f}">{}</text>)",
                                    arrow.tail.x + arrow.width, arrow.tail.y + 2.0 * arrow.width, 3.0 * arrow.width,
                                    _model.getChapters()[step.submodels[index]].letter);
    }
    *_stream << "</svg>";
}

void BookletPage::writeItems(const std::vector<BookletItem>& items)
{
    for (const BookletItem& item : items)
        writeItem(item);
}

void BookletPage::writeItem(const BookletItem& item)
{
    *_stream << "<li>";
    writeUse("part-" + std::to_string(item.kind + 1), describeParts(_model.getKinds()[item.kind], item.quantity),
             _kindSizes[item.kind]);
    *_stream << "<span class=\"quantity\" aria-hidden=\"true\">" << item.quantity << "×</span></li>\n";
}

void BookletPage::writeFinished()
{
    _progress("finished model");
    *_stream << "<section class=\"finished\" id=\"finished\" data-stop=\"Finished\">\n<h2>Finished</h2>\n"
             << "<figure class=\"picture\">";
    writeImage(_pictures.drawFinished(0), "The finished model");
    *_stream << "</figure>\n<ul class=\"downloads\">\n";
    for (const BookletDownload& download : _facts.downloads)
        *_stream << "<li><a download=\"" << escapedForMarkup(download.fileName) << "\" href=\""
                 << dataOf(download.mediaType, download.content) << "\">" << escapedForMarkup(download.label)
                 << "</a></li>\n";
    *_stream << "</ul>\n</section>\n";
}

void BookletPage::writeSymbol(const std::string& id, const BookletPicture& picture)
{
    *_stream << fmt::format(R"(<symbol id="{0}" viewBox="0 0 {1} {2}"><image width="{1}" height="{2}" href=")", id,
                            picture.width, picture.height)
             << dataOf(picture.mediaType, picture.bytes) << "\"/></symbol>\n";
}

void BookletPage::writeUse(const std::string& id, const std::string& text, const glm::dvec2& size)
{
    *_stream << fmt::format(
        R"(<svg role="img" aria-label="{0}" style="--w:{2:.0f}px" viewBox="0 0 {2:.0f} {3:.0f}"><use href="#{1}"/></svg>)",
        escapedForMarkup(text), id, size.x, size.y);
}

void BookletPage::writeImage(const BookletPicture& picture, const std::string& text)
{
    *_stream << fmt::format(R"(<img alt="{}" width="{:.0f}" height="{:.0f}" src=")", escapedForMarkup(text),
                            picture.width / picture.density, picture.height / picture.density)
             << dataOf(picture.mediaType, picture.bytes) << "\">";
}

std::string BookletPage::describeStep(const BookletChapter& chapter, const BookletStep& step) const
{
    std::vector<std::string> added;
    for (const BookletItem& item : step.items)
        added.push_back(describeParts(_model.getKinds()[item.kind], item.quantity));
    for (const std::size_t submodel : step.submodels)
        added.push_back("submodel " + _model.getChapters()[submodel].letter);
    return fmt::format("Step {} of {}: adds {}", step.name, chapter.steps.size(), joinWords(added));
}

} // namespace osgLego
