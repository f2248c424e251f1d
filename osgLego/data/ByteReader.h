#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <utility>

namespace osgLego
{

/** Reads numbers that a ByteWriter wrote. Beyond the end, it reads zeros and fails. */
class ByteReader
{
public:
    /** @param bytes must remain valid while this reader is used. */
    explicit ByteReader(std::string_view bytes) : _bytes(bytes) {}

    template <std::unsigned_integral Number>
    Number readNumber()
    {
        Number number = 0;
        for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
            number = static_cast<Number>(number | Number(readByte()) << (8 * byte));
        return number;
    }

    double readDouble() { return std::bit_cast<double>(readNumber<std::uint64_t>()); }

    /** Read a number from ByteWriter::writeShort(). */
    std::uint64_t readShort()
    {
        std::uint64_t number = 0;
        for (unsigned int shift = 0; shift < 64; shift += 7)
        {
            const std::uint8_t byte = readByte();
            number |= std::uint64_t(byte & 0x7f) << shift;
            if (byte < 0x80) return number;
        }
        _hasFailed = true;
        return 0;
    }

    /** Read all bytes that have not been read. */
    std::string_view readRest() { return std::exchange(_bytes, std::string_view()); }

    /** Whether there were fewer bytes than were read, or a number was too long. */
    bool hasFailed() const { return _hasFailed; }

private:
    std::uint8_t readByte()
    {
        if (_bytes.empty())
        {
            _hasFailed = true;
            return 0;
        }
        const auto byte = static_cast<std::uint8_t>(_bytes.front());
        _bytes.remove_prefix(1);
        return byte;
    }

    std::string_view _bytes;
    bool _hasFailed = false;
};

} // namespace osgLego
