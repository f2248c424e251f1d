#include "BookletPage.h"

#include "Base64.h"

#include <common/MarkupText.h>
#include <common/NumberText.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

/** Booklet.css, Booklet.js and Booklet.svg, the symbols, embedded at build time, and the hashes of the first two. */
const std::map<std::string_view, std::string_view>& getBookletTexts();

namespace
{

constexpr double BRICKS_PER_MINUTE_SLOW = 3.0;
constexpr double BRICKS_PER_MINUTE_FAST = 10.0;

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

/** The source of an embedded text, in a Content-Security-Policy: its hash, of which browsers expect base64. */
std::string toPolicySource(std::string_view name)
{
    constexpr std::size_t DIGITS_OF_BYTE = 2;
    constexpr int HEXADECIMAL = 16;
    const std::string digits(getBookletTexts().at(std::string(name) + ".sha256"));
    std::string hash;
    for (std::size_t place = 0; place < digits.size(); place += DIGITS_OF_BYTE)
        hash += static_cast<char>(std::stoi(digits.substr(place, DIGITS_OF_BYTE), nullptr, HEXADECIMAL));
    return "'sha256-" + toBase64(hash) + "'";
}

/** Forbid everything that the page does not use, so that a text or a file in it can do no harm, even if it were not
 * escaped. Attributes of style differ for each picture, so that they have no common hash; browsers that do not know
 * them apart from the style sheet use `style-src`. */
std::string describePolicy()
{
    return "default-src 'none'; script-src " + toPolicySource("Booklet.js") + "; style-src-elem " +
           toPolicySource("Booklet.css") +
           "; style-src-attr 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action "
           "'none'";
}

} // namespace

BookletPage::BookletPage(const BookletModel& model, const BookletFacts& facts, BookletPictureSource& pictures,
                         std::function<void(const std::string&)> progress) :
    _model(model),
    _facts(facts), _pictures(pictures), _progress(std::move(progress)), _markup(model),
    _parts(model, pictures, _progress, _markup), _steps(model, pictures, _progress, _markup)
{
}

void BookletPage::write(std::ostream& stream)
{
    _stream = &stream;
    _markup.setStream(stream);
    writeHead();
    writeCover();
    _parts.write();
    _steps.write(_facts.firstStep, _facts.endStep);
    writeFinished();
    stream << "</main>\n<script>" << getBookletTexts().at("Booklet.js") << "</script>\n</body>\n</html>\n";
}

std::size_t BookletPage::countPictures() const
{
    constexpr std::size_t COVER_AND_END = 2;
    return COVER_AND_END + _parts.countPictures() + _steps.countPictures(_facts.firstStep, _facts.endStep);
}

void BookletPage::writeHead()
{
    *_stream << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             << "<meta http-equiv=\"Content-Security-Policy\" content=\"" << describePolicy() << "\">\n"
             << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             << "<meta name=\"generator\" content=\"osgLego\">\n<title>" << escapedForMarkup(_facts.title)
             << ": building instructions</title>\n<style>" << getBookletTexts().at("Booklet.css")
             << "</style>\n</head>\n<body>\n"
             << "<svg class=\"symbols\" aria-hidden=\"true\">" << getBookletTexts().at("Booklet.svg")
             << "</svg>\n<main>\n";
}

void BookletPage::writeCover()
{
    _progress("cover");
    constexpr std::size_t LONG_TITLE = 40; // bytes, which fill three lines of A5 in large letters
    *_stream << "<section class=\"cover\" id=\"cover\" data-stop=\"Cover\">\n<h1"
             << (_facts.title.size() > LONG_TITLE ? " class=\"long\">" : ">") << escapedForMarkup(_facts.title)
             << "</h1>\n<p class=\"subtitle\">Building instructions"
             << (_facts.author.empty() ? std::string() : " by " + escapedForMarkup(_facts.author))
             << "</p>\n<figure class=\"picture\">";
    _markup.writeImage(_pictures.drawFinished(0), "The finished model: " + _facts.title);
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
    const std::size_t numSteps = _model.getNumSteps();
    std::string steps = formatNumber(numSteps);
    if (const std::size_t number = _model.getNumStepsOfSubmodels())
        steps += fmt::format(", and {} in submodels", formatNumber(number));
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

void BookletPage::writeFinished()
{
    _progress("finished model");
    // On paper with two sheets a page, the last one may leave half a page.
    const bool isBeside = _markup.getNumSheets() % 2 == 1;
    *_stream << "<section class=\"finished" << (isBeside ? " beside" : "")
             << "\" id=\"finished\" data-stop=\"Finished\">\n<h2>Finished</h2>\n"
             << "<figure class=\"picture\">";
    _markup.writeImage(_pictures.drawFinished(0), "The finished model");
    *_stream << "</figure>\n<ul class=\"downloads\">\n";
    for (const BookletDownload& download : _facts.downloads)
        *_stream << "<li><a download=\"" << escapedForMarkup(download.fileName) << "\" href=\""
                 << BookletMarkup::toData(download.mediaType, download.content) << "\">"
                 << escapedForMarkup(download.label) << "</a></li>\n";
    *_stream << "</ul>\n</section>\n";
}

} // namespace osgLego
