#include "Base64.h"

#include <cstdint>

namespace osgLego
{

std::string toBase64(std::string_view bytes)
{
    constexpr std::string_view DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t place = 0; place < bytes.size(); place += 3)
    {
        const std::string_view group = bytes.substr(place, 3);
        std::uint32_t bits = 0;
        for (std::size_t byte = 0; byte < 3; ++byte)
            bits = bits << 8 | (byte < group.size() ? static_cast<std::uint8_t>(group[byte]) : 0u);
        for (std::size_t digit = 0; digit < 4; ++digit)
            text += digit <= group.size() ? DIGITS[bits >> (18 - 6 * digit) & 63] : '=';
    }
    return text;
}

} // namespace osgLego
