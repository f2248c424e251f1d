#include "ForgedBytes.h"

#include <bit>

namespace osgLego::test
{

std::uint32_t checkSumOf(const std::string& bytes)
{
    std::uint32_t sum = ~0u;
    for (const char byte : bytes)
    {
        sum ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0u);
    }
    return ~sum;
}

std::string forge(std::string bytes, std::size_t place, const std::string& replacement)
{
    bytes.replace(place, replacement.size(), replacement);
    const std::uint32_t sum = checkSumOf(bytes.substr(0, 4) + bytes.substr(8));
    for (std::size_t byte = 0; byte < 4; ++byte)
        bytes[4 + byte] = static_cast<char>(sum >> (8 * byte));
    return bytes;
}

std::string toBytes(std::uint64_t number)
{
    std::string bytes;
    for (int byte = 0; byte < 8; ++byte)
        bytes += static_cast<char>(number >> (8 * byte));
    return bytes;
}

std::string toBytes(double number)
{
    return toBytes(std::bit_cast<std::uint64_t>(number));
}

} // namespace osgLego::test
