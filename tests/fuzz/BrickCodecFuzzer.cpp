#include "Harness.h"

#include <osgLego/BrickCodec.h>

#include <vector>

#include <zlib.h>

// Stored bricks. The first byte of an input says how the rest becomes bytes of a model, since random changes hardly
// ever give the right check sum or compressed data.

namespace
{

using osgLego::fuzz::require;

constexpr std::size_t CHECK_SUM = 4;
constexpr std::size_t HEADER = 8;
constexpr std::size_t DATA_SIZE = 77;
constexpr std::size_t DATA = 85;

enum class Form
{
    RAW,        // as it is
    CHECKED,    // with the right check sum
    COMPRESSED, // the data compressed, too, with the right size
    COUNT
};

void writeNumber(std::string& bytes, std::size_t place, std::uint64_t number, int numBytes)
{
    for (int byte = 0; byte < numBytes; ++byte)
        bytes[place + static_cast<std::size_t>(byte)] = static_cast<char>(number >> (8 * byte));
}

std::string compressData(const std::string& bytes)
{
    const std::string data = bytes.substr(DATA);
    std::vector<Bytef> compressed(compressBound(data.size()));
    uLongf size = compressed.size();
    compress(compressed.data(), &size, reinterpret_cast<const Bytef*>(data.data()), data.size());
    std::string result = bytes.substr(0, DATA);
    writeNumber(result, DATA_SIZE, data.size(), 8);
    return result.append(reinterpret_cast<const char*>(compressed.data()), size);
}

void correctCheckSum(std::string& bytes)
{
    const auto* begin = reinterpret_cast<const Bytef*>(bytes.data());
    const uLong sum = crc32_z(crc32_z(0, begin, CHECK_SUM), begin + HEADER, bytes.size() - HEADER);
    writeNumber(bytes, CHECK_SUM, sum, 4);
}

std::string toBytes(Form form, std::string bytes)
{
    if (form == Form::COMPRESSED && bytes.size() >= DATA) bytes = compressData(bytes);
    if (form != Form::RAW && bytes.size() >= HEADER) correctCheckSum(bytes);
    return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    const auto form = static_cast<Form>(*data % static_cast<int>(Form::COUNT));
    const std::string bytes = toBytes(form, std::string(osgLego::fuzz::toText(data + 1, size - 1)));
    std::string error;
    const osg::ref_ptr<const osgLego::BrickModel> model = osgLego::decodeBricks(bytes, error);
    require(model.valid() == error.empty(), "there is a model, or there is a reason: " + error);
    if (!model) return 0;
    osgLego::fuzz::requirePossible(*model);
    const osg::ref_ptr<const osgLego::BrickModel> again = osgLego::decodeBricks(osgLego::encodeBricks(*model), error);
    require(again.valid(), "encoded bricks can be decoded: " + error);
    require(again->getGrid() == model->getGrid() && again->getBricks() == model->getBricks() &&
                again->getParts() == model->getParts(),
            "bricks are equal after encoding and decoding");
    return 0;
}
