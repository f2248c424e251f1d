#pragma once

#include <osgLego/layout/PartMap.h>
#include <osgLego/search/LayoutRandom.h>
#include <osgLego/search/WindowParts.h>

#include <array>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** The cells of a few parts that may be replaced, and the parts that could cover them instead.
 *
 * A part costs LayoutCosts::PART, plus half a stacked seam for each length of its sides that would lie above or below
 * another seam. The cost of a cover is exact as long as the layers above and below stay the same.
 *
 * Keeps its memory from one window to the next. One thread at a time. */
class WindowBuilder
{
public:
    using Index = CellLattice::Index;
    static constexpr int NO_CELL = -1;
    static constexpr Index UNKNOWN = -2;

    WindowBuilder(const PartMap& map, const PartSizes& sizes);

    void clear();
    /** Add the cells of a part, which must not be in the window.
     * @return false if the window would have too many cells. */
    bool addPart(Index anchor);
    /** List the parts that could be laid, once all cells are known. Small random costs of joints decide between equal
     * covers.
     * @param seamCost the cost of half a unit of stacked seams. */
    void build(LayoutRandom& random, int seamCost);

    /** Remove the parts that contain one of two cells and not the other. */
    void keepTogether(Index cell, Index other);

    /** The anchors of the present parts, in the order in which they were added. */
    const std::vector<Index>& getAnchors() const { return _anchors; }
    const WindowParts& getParts() const { return _parts; }
    /** The cost of the present parts. Valid after build(). */
    int getCost() const { return _cost; }

    /** The cells of the window in their order. Valid after build(). */
    const std::vector<Index>& getCells() const { return _cells; }
    /** The number of a cell in the window, or NO_CELL. Valid after build(). */
    int findCell(Index cell) const { return cell < 0 ? NO_CELL : _places[static_cast<std::size_t>(cell)]; }
    /** The index in getCells() at which a part of getParts() begins. */
    int getFirstCell(int part) const { return _parts.parts[static_cast<std::size_t>(part)].cells.getFirst(); }

private:
    /** The parts above or below a part: none, one, or several. */
    struct Contacts
    {
        Index first = CellLattice::NONE;
        bool areSeveral = false;

        void add(Index anchor);
    };

    /** Stacked cells that one part covers together. */
    struct Column
    {
        WindowCells cells;
        int sum = 0;      //!< the cost of the seams on all sides
        int eastSeam = 0; //!< the cost of the seams between it and the column to the east
        int northSeam = 0;
        std::uint16_t color = 0;
        bool exists = false;
        std::array<Index, 2> contacts{}; //!< the parts above and below; NONE without a part, UNKNOWN in the window
    };

    Index findContact(int cell, CellLattice::Side side) const;
    int computeSeam(Index cell, CellLattice::Side side, LayoutRandom& random) const;
    void linkCells();
    void weighSeams(LayoutRandom& random);
    Column makeColumn(int cell, int height) const;
    void addPartsAt(int cell, int height, const std::vector<Column>& columns);
    void extend(int cell, int height, const std::vector<Column>& columns, bool isAlongX, int breadth, int shortest);
    int computeCost() const;

    const PartMap& _map;
    const PartSizes& _sizes;
    int _leafCost;
    std::vector<std::int16_t> _places; //!< for each cell of the lattice, its number in the window
    std::vector<Index> _anchors;
    std::vector<Index> _cells;
    std::vector<std::array<int, 6>> _neighbors;  //!< in the window
    std::vector<std::array<int, 2>> _seams;      //!< half the cost of the seams to the east and to the north
    std::array<std::vector<Column>, 2> _columns; //!< for each height
    WindowParts _parts;
    int _seamCost = 0;
    int _cost = 0;
};

} // namespace osgLego
