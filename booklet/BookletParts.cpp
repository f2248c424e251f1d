#include "BookletParts.h"

#include "BookletText.h"
#include "SheetArrangement.h"
#include "TrueSizePicture.h"

#include <common/ColorName.h>
#include <common/MarkupText.h>
#include <common/NumberText.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

// Lengths of Booklet.css, in millimetres on A5.
constexpr std::size_t LIST_COLUMNS = 4;
constexpr double LIST_COLUMN_WIDTH = 29.0;
constexpr double LIST_PIXEL = 25.4 / 96.0;
constexpr double LIST_PART_SCALE = 0.6;
constexpr double LIST_LINE = 3.8;
constexpr double LIST_QUANTITY = 5.4;
constexpr double LIST_CHARACTER = 1.65;
constexpr double LIST_HEADER = 15.0;
constexpr double LIST_PLATE_HEIGHT = 20.0; // of the picture of a base plate

double measureText(const std::string& text)
{
    return LIST_LINE * std::ceil(static_cast<double>(text.size()) * LIST_CHARACTER / LIST_COLUMN_WIDTH);
}

std::string formatListPlace(const PlacedBlock& place)
{
    return fmt::format(R"( style="--block:{:.2f};--space:{:.2f}")", place.height, place.space);
}

} // namespace

BookletParts::BookletParts(const BookletModel& model, BookletPictureSource& pictures,
                           const std::function<void(const std::string&)>& progress, BookletMarkup& markup) :
    _model(model),
    _pictures(pictures), _progress(progress), _markup(markup)
{
}

std::size_t BookletParts::countPictures() const
{
    return countItems();
}

/** The number of kinds, and the base plate. */
std::size_t BookletParts::countItems() const
{
    return _model.getKinds().size() + (_model.getBasePlate() ? 1 : 0);
}

void BookletParts::write()
{
    writeSymbols();
    const std::size_t numRows = (countItems() + LIST_COLUMNS - 1) / LIST_COLUMNS;
    std::vector<SheetBlock> rows(numRows + 1); // and the picture in true size
    for (std::size_t item = 0; item < countItems(); ++item)
    {
        double& height = rows[item / LIST_COLUMNS].heads[0];
        height = std::max(height, measureItem(item));
    }
    rows.back().heads[0] = measureTrueSize(findLongest());
    std::ostream& stream = _markup.getStream();
    stream << "<section class=\"section\" id=\"parts\" data-stop=\"Parts\">\n<div class=\"parts-list\">\n";
    const SheetArrangement arrangement(rows, LIST_HEADER, 1);
    for (const Sheet& sheet : arrangement.getSheets())
    {
        _markup.beginSheet();
        if (&sheet == &arrangement.getSheets().front())
            stream << "<header><h2>Parts</h2>\n<p class=\"subtitle\">" << countOf(_model.getNumParts(), "part")
                   << " of " << countOf(_model.getKinds().size(), "kind") << "</p></header>\n";
        for (const PlacedBlock& place : sheet.columns.front())
            if (place.block < numRows)
            {
                stream << "<ul class=\"parts\"" << formatListPlace(place) << ">\n";
                writeRow(place.block);
                stream << "</ul>\n";
            }
            else
            {
                stream << "<figure class=\"true-size\"" << formatListPlace(place) << ">\n";
                writeTrueSize();
                stream << "</figure>\n";
            }
        stream << "</div>\n";
    }
    stream << "</div>\n</section>\n";
}

void BookletParts::writeSymbols()
{
    const std::size_t number = _model.getKinds().size();
    _markup.getStream() << "<svg class=\"symbols\" aria-hidden=\"true\">\n";
    for (std::size_t kind = 0; kind < number; ++kind)
    {
        _progress(fmt::format("kind of part {} of {}", kind + 1, number));
        _markup.writeKind(kind, _pictures.drawKind(kind));
    }
    _markup.getStream() << "</svg>\n";
    if (!_model.getBasePlate()) return;
    _progress("base plate");
    _basePlate = _pictures.drawBasePlate();
}

/** The height of a part of the list, with its text. */
double BookletParts::measureItem(std::size_t item) const
{
    constexpr double SPACE = 2.0;
    if (item == _model.getKinds().size()) return LIST_PLATE_HEIGHT + LIST_QUANTITY + 4.0 * LIST_LINE + SPACE;
    const Details details = describe(_model.getKinds()[item]);
    double height = _markup.getKindSize(item).y * (LIST_PIXEL * LIST_PART_SCALE) + SPACE + LIST_QUANTITY + LIST_LINE +
                    measureText(details.color);
    for (const std::string& code : details.codes)
        height += measureText(code);
    return height;
}

void BookletParts::writeRow(std::size_t row)
{
    const std::vector<PartsList::Row>& kinds = _model.getKinds();
    for (std::size_t item = row * LIST_COLUMNS; item < std::min((row + 1) * LIST_COLUMNS, countItems()); ++item)
    {
        if (item == kinds.size())
        {
            writeBasePlate();
            continue;
        }
        _markup.getStream() << "<li>";
        _markup.writeUseOfKind({item, kinds[item].quantity});
        writeDetails(kinds[item]);
        _markup.getStream() << "</li>\n";
    }
}

/** The base plate at the end of the parts, none of which it is. */
void BookletParts::writeBasePlate()
{
    constexpr const char* TIMES = "\u202f×\u202f";
    const BasePlate& plate = *_model.getBasePlate();
    std::ostream& stream = _markup.getStream();
    stream << "<li class=\"base-plate\">";
    _markup.writeImage(_basePlate, fmt::format("{} in green", plate.getName(TIMES)));
    stream << "<p><span class=\"quantity\">" << plate.getQuantity() << "×</span> <span><span class=\"name\">"
           << plate.getName(TIMES) << "</span> <span class=\"code\">" << plate.getNumber()
           << "</span></span> <span>Green, drawn smaller</span> <span class=\"code\"><span>BrickLink\u00a06</span> "
           << "<span>LDraw\u00a02</span></span></p></li>\n";
}

BookletParts::Details BookletParts::describe(const PartsList::Row& row)
{
    const std::string name = nameColor(row.color);
    const std::string brickLinkName = nameBrickLinkColor(row.color);
    Details details;
    details.color = brickLinkName.empty() ? name : brickLinkName;
    if (row.color.brickLink >= 0) details.codes.push_back("BrickLink\u00a0" + std::to_string(row.color.brickLink));
    if (row.color.code != Part::NO_CODE)
        details.codes.push_back("LDraw\u00a0" + std::to_string(row.color.code) +
                                (spellGray(name) == brickLinkName ? std::string() : " " + name));
    return details;
}

/** The text below the picture of a part: all that is needed to order it. */
void BookletParts::writeDetails(const PartsList::Row& row)
{
    const Details details = describe(row);
    std::string codes;
    for (const std::string& code : details.codes)
        codes += (codes.empty() ? "<span>" : " <span>") + escapedForMarkup(code) + "</span>";
    _markup.getStream() << "<p><span class=\"quantity\">" << formatNumber(row.quantity)
                        << "×</span> <span><span class=\"name\">" << escapedForMarkup(nameType(*row.type))
                        << "</span> <span class=\"code\">" << row.type->number << "</span></span> <span>"
                        << escapedForMarkup(details.color) << "</span> <span class=\"code\">" << codes << "</span></p>";
}

/** The longest brick and the longest plate, of those that there are. */
std::vector<const PartType*> BookletParts::findLongest() const
{
    std::vector<const PartType*> longest;
    for (const PartFamily family : {PartFamily::PLATE, PartFamily::BRICK})
    {
        const PartType* best = nullptr;
        for (const PartsList::Row& row : _model.getKinds())
            if (row.type->family == family && (!best || row.type->length > best->length)) best = row.type;
        if (best) longest.push_back(best);
    }
    return longest;
}

void BookletParts::writeTrueSize()
{
    _markup.getStream()
        << "<figcaption>True size if printed at 100 %: the longest parts from their side, to sort others "
           "by length</figcaption>\n"
        << drawTrueSize(findLongest());
}

} // namespace osgLego
