#include "BytesField.h"

#include <algorithm>

#include <osgDB/ConvertBase64>

// The bytes are divided into parts, since OSG only reports the end of a file after reading a number or a string.

namespace
{

constexpr std::size_t PART_SIZE = 48 * 1024;

std::string toBase64(const std::string& bytes)
{
    std::string text;
    osgDB::Base64encoder().encode(bytes.data(), static_cast<int>(bytes.size()), text);
    text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
    return text;
}

/** @return false if the text is not that of a part. */
bool fromBase64(const std::string& text, std::string& bytes)
{
    // OSG's decoder ignores other characters, and one makes it read beyond its table.
    constexpr const char* DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t numDigits = std::min(text.find_first_not_of(DIGITS), text.size());
    if (text.find_first_not_of('=', numDigits) != std::string::npos || text.size() > 2 * PART_SIZE) return false;
    bytes.resize(text.size() + 1); // the decoder clears the byte after the last one
    const int size = osgDB::Base64decoder().decode(text.data(), static_cast<int>(numDigits), bytes.data());
    bytes.resize(static_cast<std::size_t>(size));
    return true;
}

bool readPart(osgDB::InputStream& stream, std::string& part)
{
    if (!stream.isBinary())
    {
        std::string text;
        stream >> text;
        return fromBase64(text, part);
    }
    const unsigned int size = stream.readSize();
    if (stream.getException() || size > PART_SIZE) return false;
    part.resize(size);
    stream.readCharArray(part.data(), size);
    return true;
}

} // namespace

void writeBytesField(osgDB::OutputStream& stream, const std::string& bytes)
{
    stream.writeSize(static_cast<unsigned int>((bytes.size() + PART_SIZE - 1) / PART_SIZE));
    for (std::size_t begin = 0; begin < bytes.size(); begin += PART_SIZE)
    {
        const std::string part = bytes.substr(begin, PART_SIZE);
        if (stream.isBinary())
        {
            stream.writeSize(static_cast<unsigned int>(part.size()));
            stream.writeCharArray(part.data(), static_cast<unsigned int>(part.size()));
        }
        else
            stream << toBase64(part);
    }
    stream << std::endl;
}

bool readBytesField(osgDB::InputStream& stream, std::string& bytes)
{
    bytes.clear();
    const unsigned int numParts = stream.readSize();
    for (unsigned int index = 0; index < numParts; ++index)
    {
        std::string part;
        if (stream.getException() || !readPart(stream, part)) return false;
        bytes += part;
    }
    return !stream.getException();
}
