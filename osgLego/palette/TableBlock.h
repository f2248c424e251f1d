#pragma once

#include <osgLego/PaletteColor.h>
#include <osgLego/data/ParallelLoop.h>

#include <cstddef>

namespace osgLego
{

/** A cube of entries of Palette::getTable(): few colours of a palette matter to any of them. */
class TableBlock
{
public:
    static constexpr std::size_t SIDE = 4; //!< in entries
    static constexpr std::size_t ALONG = PaletteLimits::TABLE_SIDE / SIDE;
    static constexpr std::size_t COUNT = ALONG * ALONG * ALONG; //!< blocks of a table

    /** @param index below COUNT. */
    explicit TableBlock(std::size_t index) :
        _index(index),
        _first(SIDE * (index % ALONG + TABLE_SIDE * (index / ALONG % ALONG + TABLE_SIDE * (index / ALONG / ALONG))))
    {
    }

    std::size_t getIndex() const { return _index; }
    /** @param red 0 to SIDE - 1, as the other two. */
    std::size_t getEntry(std::size_t red, std::size_t green, std::size_t blue) const
    {
        return _first + red + TABLE_SIDE * (green + TABLE_SIDE * blue);
    }
    std::size_t getMiddle() const { return getEntry(SIDE / 2, SIDE / 2, SIDE / 2); }

    /** Call function(entry) for each entry. */
    template <typename Function>
    void forEachEntry(const Function& function) const
    {
        for (std::size_t blue = 0; blue < SIDE; ++blue)
            for (std::size_t green = 0; green < SIDE; ++green)
                for (std::size_t red = 0; red < SIDE; ++red)
                    function(getEntry(red, green, blue));
    }

    /** Call function(block) for each block of a table, on several threads. */
    template <typename Function>
    static void forEach(const Function& function)
    {
        forEachIndex(COUNT, [&](std::size_t index) { function(TableBlock(index)); });
    }

private:
    static constexpr std::size_t TABLE_SIDE = PaletteLimits::TABLE_SIDE;

    std::size_t _index;
    std::size_t _first;
};

} // namespace osgLego
