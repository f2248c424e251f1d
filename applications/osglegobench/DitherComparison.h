#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Palette.h>

#include <common/JsonValue.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Compares blocks of cells with their surface, as an eye sees them from a distance: by CIEDE2000 between means in
 * linear light, once with the nearest colours and once with `dither=on`. One thread at a time. */
class DitherComparison
{
public:
    using Color = std::array<std::uint8_t, 3>;
    using Cell = std::array<std::uint16_t, 3>;

    explicit DitherComparison(const Palette& palette);

    /** Add a cell with the colour of its surface. */
    void add(const Color& color, const Cell& cell);
    /** Compare the blocks of the cells since the last call, and start again without cells. */
    void finishSurface();

    JsonValue toJson(const std::string& name) const;

private:
    static constexpr std::array<std::uint16_t, 2> SIDES{4, 8}; // of blocks, in cells

    struct Block
    {
        double numCells = 0.0;
        glm::dvec3 surface{0.0}; // sums of linear light
        glm::dvec3 nearest{0.0};
        glm::dvec3 dithered{0.0};
    };

    /** Sums over blocks of one size, weighted by their cells. */
    struct Sums
    {
        double nearest = 0.0;
        double dithered = 0.0;
        double lightness = 0.0; // by which dithered blocks are too light
    };

    const Palette& _palette;
    std::vector<double> _chromas;
    std::array<std::map<Cell, Block>, SIDES.size()> _blocks;
    std::array<Sums, SIDES.size()> _sums;
    double _numCells = 0.0;
    std::size_t _numNeutral = 0;
    std::size_t _numChromatic = 0;
};

/** Compare surfaces of one colour, each a plane of 16 x 16 cells: random mixtures of two colours of the palette. */
JsonValue compareDitheredMixtures(const Palette& palette);
/** Likewise with nearly neutral colours of every lightness. */
JsonValue compareDitheredNeutrals(const Palette& palette);
/** Compare the visible cells of a model, which have the colours of their surface. */
JsonValue compareDithered(const Palette& palette, const BrickModel& cells, const std::string& name);

} // namespace osgLego
