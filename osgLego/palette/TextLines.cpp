#include <osgLego/palette/TextLines.h>

#include <osgLego/text/SettingsText.h>

#include <algorithm>

namespace osgLego
{

TextLines::TextLines(std::string_view text) : _rest(text)
{
    constexpr std::string_view BYTE_ORDER_MARK = "\xef\xbb\xbf";
    if (_rest.starts_with(BYTE_ORDER_MARK)) _rest.remove_prefix(BYTE_ORDER_MARK.size());
}

bool TextLines::next()
{
    if (_rest.empty()) return false;
    const auto end = std::min(_rest.find('\n'), _rest.size());
    _line = trimmed(_rest.substr(0, end));
    _rest.remove_prefix(std::min(end + 1, _rest.size()));
    ++_number;
    return true;
}

std::string TextLines::expected(const std::string& wanted, std::string_view found) const
{
    return "line " + std::to_string(_number) + ": expected " + wanted + ", found " + quoteForMessage(found);
}

} // namespace osgLego
