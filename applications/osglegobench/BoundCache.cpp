#include "BoundCache.h"

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

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

std::string computeHash(const LayoutProblem& problem, const std::vector<int>& layers, double seconds)
{
    Hash hash;
    for (const LayoutCell& cell : problem.cells)
        hash.add(cell.place[0] | std::uint64_t{cell.place[1]} << 16 | std::uint64_t{cell.place[2]} << 32 |
                 std::uint64_t{cell.color} << 48);
    for (const LayoutColor& color : problem.colors)
        hash.add(color.bricks);
    for (const int layer : layers)
        hash.add(static_cast<std::uint64_t>(layer));
    hash.add(static_cast<std::uint64_t>(seconds));
    return hash.toText();
}

} // namespace

BoundCache::BoundCache(std::string fileName) : _fileName(std::move(fileName))
{
    if (_fileName.empty() || !std::filesystem::exists(_fileName)) return;
    std::ifstream file(_fileName);
    _entries = nlohmann::ordered_json::parse(file, nullptr, false);
    if (!_entries.is_object())
        throw std::runtime_error("'" + _fileName + "' has no bounds; expected a file that --bounds has written");
}

std::vector<LayerBound> BoundCache::getBounds(const LayoutProblem& problem, const std::vector<int>& layers,
                                              double seconds)
{
    std::vector<LayerBound> bounds;
    const std::string hash = computeHash(problem, layers, seconds);
    if (const auto entry = _entries.find(hash); entry != _entries.end())
    {
        for (const auto& layer : *entry)
            bounds.push_back({layer.at(0), layer.at(1), layer.at(2)});
        return bounds;
    }
    bounds = boundLayers(problem, layers, {seconds, {}});
    for (const LayerBound& bound : bounds)
        _entries[hash].push_back({bound.z, bound.parts, bound.isOptimum});
    write();
    return bounds;
}

void BoundCache::write() const
{
    if (_fileName.empty()) return;
    const std::string why = writeCompleteFile(_fileName,
                                              [this](const std::string& temporaryName)
                                              {
                                                  std::ofstream file(temporaryName, std::ios::binary);
                                                  file << _entries.dump() << '\n';
                                                  file.close();
                                                  return file ? std::string() : std::string(std::strerror(errno));
                                              });
    if (!why.empty()) throw std::runtime_error("can't write '" + _fileName + "': " + why);
}

} // namespace osgLego
