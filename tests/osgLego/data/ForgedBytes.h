#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace osgLego::test
{

/** CRC-32, computed bit by bit from its definition. */
std::uint32_t checkSumOf(const std::string& bytes);

/** Replace bytes of stored bricks and correct the check sum. */
std::string forge(std::string bytes, std::size_t place, const std::string& replacement);

/** The bytes of a number in little-endian order. */
std::string toBytes(std::uint64_t number);
std::string toBytes(double number);

} // namespace osgLego::test
