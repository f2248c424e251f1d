#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace osgLego
{

/** Appends numbers to a string of bytes, in the same format on every machine. ByteReader reads them. */
class ByteWriter
{
public:
    /** Append all bytes of a number, lowest first. */
    template <std::unsigned_integral Number>
    void writeNumber(Number number)
    {
        for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
            _bytes += static_cast<char>(number >> (8 * byte));
    }

    void writeDouble(double number) { writeNumber(std::bit_cast<std::uint64_t>(number)); }

    /** Append a number that is probably small: 7 bits in each byte, the lowest first, and whether more follow. */
    void writeShort(std::uint64_t number)
    {
        for (; number >= 0x80; number >>= 7)
            _bytes += static_cast<char>(number | 0x80);
        _bytes += static_cast<char>(number);
    }

    const std::string& getBytes() const { return _bytes; }

private:
    std::string _bytes;
};

} // namespace osgLego
