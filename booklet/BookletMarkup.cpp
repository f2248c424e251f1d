#include "BookletMarkup.h"

#include "Base64.h"
#include "BookletText.h"

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
