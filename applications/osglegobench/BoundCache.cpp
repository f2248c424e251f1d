#include "BoundCache.h"

#include <common/CompleteFile.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

constexpr std::size_t LAYERS_AT_ONCE = 4;

/** Fowler, Noll and Vo's hash of 64 bits (FNV-1a). */
class Hash
{
public:
    void add(std::uint64_t number)
    {
        for (int byte = 0; byte < 8; ++byte)
            _value = (_value ^ (number >> 8 * byte & 0xff)) * 0x100000001b3;
    }
    std::string toText() const { return fmt::format("{:016x}", _value); }

private:
    std::uint64_t _value = 0xcbf29ce484222325;
};

std::string computeHash(const LayoutProblem& problem, int layer, double seconds)
{
    Hash hash;
    for (const LayoutCell& cell : problem.cells)
        if (cell.place[2] == layer)
            hash.add(cell.place[0] | std::uint64_t{cell.place[1]} << 16 | std::uint64_t{cell.color} << 32);
    for (const LayoutColor& color : problem.colors)
        hash.add(color.bricks);
    hash.add(static_cast<std::uint64_t>(seconds));
    return hash.toText();
}

} // namespace

BoundCache::BoundCache(std::string fileName) : _fileName(std::move(fileName))
{
    if (_fileName.empty() || !std::filesystem::exists(_fileName)) return;
    std::ifstream file(_fileName);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::optional<JsonValue> entries = JsonValue::parse(text);
    if (!entries || !entries->isObject())
        throw std::runtime_error("'" + _fileName + "' has no bounds; expected a file that --bounds has written");
    _entries = *entries;
}

std::vector<LayerBound> BoundCache::getBounds(const LayoutProblem& problem, const std::vector<int>& layers,
                                              double seconds)
{
    std::vector<int> missing;
    for (const int layer : layers)
        if (!_entries.contains(computeHash(problem, layer, seconds))) missing.push_back(layer);
    for (std::size_t begin = 0; begin < missing.size(); begin += LAYERS_AT_ONCE)
    {
        const std::size_t end = std::min(begin + LAYERS_AT_ONCE, missing.size());
        compute(
            problem,
            {missing.begin() + static_cast<std::ptrdiff_t>(begin), missing.begin() + static_cast<std::ptrdiff_t>(end)},
            seconds);
    }
    std::vector<LayerBound> bounds;
    for (const int layer : layers)
    {
        const std::vector<JsonValue>& entry = _entries[computeHash(problem, layer, seconds)].getElements();
        bounds.push_back({layer, static_cast<std::size_t>(entry.at(0).toInteger()), entry.at(1).toBoolean()});
    }
    return bounds;
}

void BoundCache::compute(const LayoutProblem& problem, const std::vector<int>& layers, double seconds)
{
    for (const LayerBound& bound : boundLayers(problem, layers, {seconds, {}}))
        _entries[computeHash(problem, bound.z, seconds)] = JsonValue::createArray({bound.parts, bound.isOptimum});
    write();
}

void BoundCache::write() const
{
    if (_fileName.empty()) return;
    const std::string why = writeCompleteFile(_fileName,
                                              [this](std::ostream& stream)
                                              {
                                                  stream << _entries.toString() << '\n';
                                                  return std::string();
                                              });
    if (!why.empty()) throw std::runtime_error("can't write '" + _fileName + "': " + why);
}

} // namespace osgLego
