#include "SettingsField.h"

#include <string_view>

namespace
{

constexpr std::string_view DIGITS = "0123456789ABCDEF";

bool isStoredAsIs(char letter)
{
    constexpr std::string_view PLAIN = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789,=.:_/+-";
    return PLAIN.find(letter) != std::string_view::npos;
}

std::string encode(const std::string& text)
{
    std::string encoded;
    for (const char letter : text)
    {
        // OSG replaces two hyphens in XML.
        const bool isSecondHyphen = letter == '-' && !encoded.empty() && encoded.back() == '-';
        if (isStoredAsIs(letter) && !isSecondHyphen)
        {
            encoded += letter;
            continue;
        }
        const auto byte = static_cast<unsigned char>(letter);
        encoded += {'%', DIGITS[byte / 16u], DIGITS[byte % 16u]};
    }
    return encoded;
}

std::string decode(const std::string& encoded)
{
    std::string text;
    for (std::size_t place = 0; place < encoded.size(); ++place)
    {
        const bool isCode = encoded[place] == '%' && place + 2 < encoded.size();
        const std::size_t high = isCode ? DIGITS.find(encoded[place + 1]) : std::string_view::npos;
        const std::size_t low = isCode ? DIGITS.find(encoded[place + 2]) : std::string_view::npos;
        if (high == std::string_view::npos || low == std::string_view::npos)
        {
            text += encoded[place];
            continue;
        }
        text += static_cast<char>(16 * high + low);
        place += 2;
    }
    return text;
}

} // namespace

void writeSettingsField(osgDB::OutputStream& stream, const std::string& text)
{
    stream.writeWrappedString(encode(text));
    stream << std::endl;
}

std::string readSettingsField(osgDB::InputStream& stream)
{
    std::string text;
    stream >> text;
    const bool isQuoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return decode(isQuoted ? text.substr(1, text.size() - 2) : text);
}
