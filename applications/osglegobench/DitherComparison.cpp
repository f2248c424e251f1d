#include "DitherComparison.h"

#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace osgLego
{

namespace
{

constexpr double NEUTRAL = 5.0;    // the largest chroma of nearly neutral colours
constexpr double CHROMATIC = 10.0; // the least chroma of colours that have a clear hue
constexpr int NUM_SURFACES = 1000;

double chromaOf(const DitherComparison::Color& color)
{
    const glm::dvec3 place = toCieLab(color);
    return std::hypot(place.y, place.z);
}

/** Add a plane of cells of one colour; planes across all axes take turns. */
void addPlane(DitherComparison& comparison, const DitherComparison::Color& color, int number)
{
    const auto axis = static_cast<std::size_t>(number % 3);
    for (std::uint16_t row = 0; row < 16; ++row)
        for (std::uint16_t column = 0; column < 16; ++column)
        {
            DitherComparison::Cell cell{};
            cell[axis] = static_cast<std::uint16_t>(number % 97);
            cell[(axis + 1) % 3] = row;
            cell[(axis + 2) % 3] = column;
            comparison.add(color, cell);
        }
    comparison.finishSurface();
}

} // namespace

DitherComparison::DitherComparison(const Palette& palette) : _palette(palette)
{
    for (const PaletteColor& color : palette.getColors())
        _chromas.push_back(chromaOf(color.color));
}

void DitherComparison::add(const Color& color, const Cell& cell)
{
    const std::size_t dithered = _palette.findDithered(color, cell);
    const glm::dvec3 nearestLight = toLinear(_palette.getColors()[_palette.findNearest(color)].color);
    for (std::size_t size = 0; size < SIDES.size(); ++size)
    {
        const std::uint16_t side = SIDES[size];
        const auto placeOf = [&](std::uint16_t coordinate) { return static_cast<std::uint16_t>(coordinate / side); };
        Block& block = _blocks[size][{placeOf(cell[0]), placeOf(cell[1]), placeOf(cell[2])}];
        block.numCells += 1.0;
        block.surface += toLinear(color);
        block.nearest += nearestLight;
        block.dithered += toLinear(_palette.getColors()[dithered].color);
    }
    _numCells += 1.0;
    if (chromaOf(color) > NEUTRAL) return;
    ++_numNeutral;
    _numChromatic += _chromas[dithered] > CHROMATIC ? 1 : 0;
}

void DitherComparison::finishSurface()
{
    for (std::size_t size = 0; size < SIDES.size(); ++size)
    {
        for (const auto& [place, block] : _blocks[size])
        {
            const glm::dvec3 surface = linearToCieLab(block.surface / block.numCells);
            const glm::dvec3 dithered = linearToCieLab(block.dithered / block.numCells);
            Sums& sums = _sums[size];
            sums.nearest += block.numCells * ciede2000(surface, linearToCieLab(block.nearest / block.numCells));
            sums.dithered += block.numCells * ciede2000(surface, dithered);
            sums.lightness += block.numCells * (dithered.x - surface.x);
        }
        _blocks[size].clear();
    }
}

JsonValue DitherComparison::toJson(const std::string& name) const
{
    JsonValue row{{"colorsOf", name}, {"cells", _numCells}, {"palette", _palette.getColors().size()}};
    for (std::size_t size = 0; size < SIDES.size(); ++size)
        row["blocks"].append({{"side", static_cast<std::size_t>(SIDES[size])},
                              {"nearest", _sums[size].nearest / _numCells},
                              {"dithered", _sums[size].dithered / _numCells},
                              {"lightness", _sums[size].lightness / _numCells}});
    if (_numNeutral > 0) row["chromatic"] = static_cast<double>(_numChromatic) / static_cast<double>(_numNeutral);
    return row;
}

JsonValue compareDitheredMixtures(const Palette& palette)
{
    DitherComparison comparison(palette);
    std::mt19937 engine(7);
    const auto colors = palette.getColors();
    for (int number = 0; number < NUM_SURFACES; ++number)
    {
        const auto& first = colors[engine() % colors.size()].color;
        const auto& second = colors[engine() % colors.size()].color;
        const double share = std::uniform_real_distribution<double>(0.0, 1.0)(engine);
        DitherComparison::Color color{};
        for (std::size_t channel = 0; channel < color.size(); ++channel)
            color[channel] = static_cast<std::uint8_t>(std::lround(std::lerp(first[channel], second[channel], share)));
        addPlane(comparison, color, number);
    }
    return comparison.toJson("mixtures of two");
}

JsonValue compareDitheredNeutrals(const Palette& palette)
{
    DitherComparison comparison(palette);
    std::mt19937 engine(8);
    for (int number = 0; number < NUM_SURFACES;)
    {
        const int level = static_cast<int>(engine() % 256);
        DitherComparison::Color color{};
        for (std::uint8_t& channel : color)
            channel = static_cast<std::uint8_t>(std::clamp(level + static_cast<int>(engine() % 25) - 12, 0, 255));
        if (chromaOf(color) <= NEUTRAL) addPlane(comparison, color, number++);
    }
    return comparison.toJson("near-neutrals");
}

JsonValue compareDithered(const Palette& palette, const BrickModel& cells, const std::string& name)
{
    DitherComparison comparison(palette);
    for (const Brick& brick : cells.getBricks())
        if (brick.openSides != 0) comparison.add(brick.color, brick.cell);
    comparison.finishSurface();
    return comparison.toJson(name);
}

} // namespace osgLego
