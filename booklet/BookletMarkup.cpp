#include "BookletMarkup.h"

#include "Base64.h"
#include "BookletText.h"

#include <common/ColorName.h>
#include <common/MarkupText.h>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

std::string nameSymbol(std::size_t kind)
{
    return "part-" + std::to_string(kind + 1);
}

/** An arrow as a path of SVG. */
std::string drawArrow(const BookletArrow& arrow)
{
    std::string path;
    for (const glm::dvec2& corner : arrow.getCorners())
        path += fmt::format("{}{:.0f} {:.0f}", path.empty() ? "M" : "L", corner.x, corner.y);
    return path + "Z";
}

} // namespace

std::string BookletMarkup::toData(const std::string& mediaType, const std::string& bytes)
{
    return "data:" + mediaType + ";base64," + toBase64(bytes);
}

void BookletMarkup::writeSymbol(const std::string& id, const BookletPicture& picture)
{
    *_stream << fmt::format(R"(<symbol id="{0}" viewBox="0 0 {1} {2}"><image width="{1}" height="{2}" href=")", id,
                            picture.width, picture.height)
             << toData(picture.mediaType, picture.bytes) << "\"/></symbol>\n";
}

void BookletMarkup::writeUse(const std::string& id, const std::string& text, const glm::dvec2& size)
{
    *_stream << fmt::format(
        R"(<svg role="img" aria-label="{0}" style="--w:{2:.0f}" viewBox="0 0 {2:.0f} {3:.0f}"><use href="#{1}"/></svg>)",
        escapedForMarkup(text), id, size.x, size.y);
}

void BookletMarkup::writeImage(const BookletPicture& picture, const std::string& text)
{
    *_stream << fmt::format(R"(<img alt="{}" width="{:.0f}" height="{:.0f}" src=")", escapedForMarkup(text),
                            picture.width / picture.density, picture.height / picture.density)
             << toData(picture.mediaType, picture.bytes) << "\">";
}

void BookletMarkup::writeKind(std::size_t kind, const BookletPicture& picture)
{
    writeSymbol(nameSymbol(kind), picture);
    _kindSizes[kind] = glm::dvec2(picture.width, picture.height) / picture.density;
}

void BookletMarkup::writeUseOfKind(const BookletItem& item)
{
    writeUse(nameSymbol(item.kind), describeParts(_model.getKinds()[item.kind], item.quantity), _kindSizes[item.kind]);
}

std::string BookletMarkup::nameColorOf(std::size_t kind) const
{
    const PaletteColor& color = _model.getKinds()[kind].color;
    const std::string brickLinkName = nameBrickLinkColor(color);
    return brickLinkName.empty() ? nameColor(color) : brickLinkName;
}

void BookletMarkup::beginSheet()
{
    *_stream << "<div class=\"sheet\">\n";
    ++_numSheets;
}

void BookletMarkup::writeSwatch(std::size_t kind)
{
    const glm::dvec2& size = _kindSizes[kind];
    *_stream << fmt::format(R"(<svg aria-hidden="true" viewBox="0 0 {:.0f} {:.0f}"><use href="#{}"/></svg>{})", size.x,
                            size.y, nameSymbol(kind), escapedForMarkup(nameColorOf(kind)));
}

void BookletMarkup::writeArrows(const BookletPicture& picture, const std::vector<std::string>& letters)
{
    if (picture.arrows.empty()) return;
    // Half of the line around each is outside of it.
    *_stream << fmt::format(R"(<svg class="arrows" aria-hidden="true" viewBox="0 0 {} {}" stroke-width="{:.1f}">)",
                            picture.width, picture.height, 2.0 * BookletArrow::HALO * picture.arrows.front().width);
    for (std::size_t index = 0; index < picture.arrows.size(); ++index)
    {
        const BookletArrow& arrow = picture.arrows[index];
        *_stream << "<path d=\"" << drawArrow(arrow) << "\"/>";
        if (index < letters.size())
            *_stream << fmt::format(R"(<text x="{:.0f}" y="{:.0f}" font-size="{:.0f}">{}</text>)", arrow.letter.x,
                                    arrow.letter.y, BookletArrow::LETTER_SIZE * arrow.width, letters[index]);
    }
    *_stream << "</svg>";
}

void BookletMarkup::writeItems(const std::vector<BookletItem>& items)
{
    for (const BookletItem& item : items)
    {
        *_stream << "<li>";
        writeUseOfKind(item);
        *_stream << "<span class=\"quantity\" aria-hidden=\"true\">" << item.quantity << "×</span></li>\n";
    }
}

} // namespace osgLego
