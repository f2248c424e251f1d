#include <osgLego/search/WindowBuilder.h>

#include <osgLego/search/LayoutCosts.h>

#include <algorithm>
#include <cstddef>

namespace osgLego
{

WindowBuilder::WindowBuilder(const PartMap& map, const PartSizes& sizes) :
    _map(map), _sizes(sizes), _leafCost(LayoutCosts::getLeaf(map.getLattice().getProblem())),
    _places(static_cast<std::size_t>(map.getLattice().getNumCells()), NO_CELL)
{
}

void WindowBuilder::clear()
{
    for (const Index cell : _cells)
        _places[static_cast<std::size_t>(cell)] = NO_CELL;
    _cells.clear();
    _anchors.clear();
}

bool WindowBuilder::addPart(Index anchor)
{
    if (static_cast<int>(_cells.size()) + _map.getShape(anchor).getNumCells() > WindowCells::CAPACITY) return false;
    _anchors.push_back(anchor);
    _map.visitPart(anchor, [&](Index cell) { _cells.push_back(cell); });
    return true;
}

void WindowBuilder::build(LayoutRandom& random, int seamCost)
{
    _seamCost = seamCost;
    linkCells();
    weighSeams(random);
    _parts.parts.clear();
    _parts.starts.clear();
    const std::vector<int>& heights = _sizes.getHeights();
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
        _columns[i].resize(_cells.size());
        for (std::size_t cell = 0; cell < _cells.size(); ++cell)
            _columns[i][cell] = makeColumn(static_cast<int>(cell), heights[i]);
    }
    for (int cell = 0; cell < static_cast<int>(_cells.size()); ++cell)
    {
        _parts.starts.push_back(static_cast<int>(_parts.parts.size()));
        for (std::size_t i = 0; i < heights.size(); ++i)
            addPartsAt(cell, heights[i], _columns[i]);
    }
    _parts.starts.push_back(static_cast<int>(_parts.parts.size()));
    _cost = computeCost();
}

void WindowBuilder::linkCells()
{
    std::sort(_cells.begin(), _cells.end());
    for (std::size_t i = 0; i < _cells.size(); ++i)
        _places[static_cast<std::size_t>(_cells[i])] = static_cast<std::int16_t>(i);
    _neighbors.resize(_cells.size());
    for (std::size_t i = 0; i < _cells.size(); ++i)
        for (const auto side : {CellLattice::EAST, CellLattice::WEST, CellLattice::NORTH, CellLattice::SOUTH,
                                CellLattice::ABOVE, CellLattice::BELOW})
            _neighbors[i][side] = findCell(_map.getLattice().getNeighbor(_cells[i], side));
}

/** Half the cost of a seam between a cell and its neighbour on one side. */
int WindowBuilder::computeSeam(Index cell, CellLattice::Side side, LayoutRandom& random) const
{
    const CellLattice& lattice = _map.getLattice();
    const Index other = lattice.getNeighbor(cell, side);
    int cost = static_cast<int>(random.below(std::size_t(LayoutCosts::LARGEST_CHANCE)));
    for (const auto vertical : {CellLattice::ABOVE, CellLattice::BELOW})
    {
        const Index near = lattice.getNeighbor(cell, vertical);
        const Index far = lattice.getNeighbor(other, vertical);
        // Parts of cells in the window will be replaced, so their seams are not known yet.
        if (near == CellLattice::NONE || far == CellLattice::NONE || findCell(near) != NO_CELL) continue;
        if (_map.getAnchor(near) != _map.getAnchor(far)) cost += _seamCost;
    }
    return cost;
}

void WindowBuilder::weighSeams(LayoutRandom& random)
{
    _seams.assign(_cells.size(), {0, 0});
    for (std::size_t i = 0; i < _cells.size(); ++i)
    {
        if (_neighbors[i][CellLattice::EAST] != NO_CELL)
            _seams[i][0] = computeSeam(_cells[i], CellLattice::EAST, random);
        if (_neighbors[i][CellLattice::NORTH] != NO_CELL)
            _seams[i][1] = computeSeam(_cells[i], CellLattice::NORTH, random);
    }
}

void WindowBuilder::Contacts::add(Index anchor)
{
    if (anchor == CellLattice::NONE) return;
    areSeveral |= first != CellLattice::NONE && first != anchor;
    first = anchor;
}

/** The part above or below a cell; UNKNOWN if that cell is in the window. */
WindowBuilder::Index WindowBuilder::findContact(int cell, CellLattice::Side side) const
{
    const Index other = _map.getLattice().getNeighbor(_cells[static_cast<std::size_t>(cell)], side);
    if (other == CellLattice::NONE) return CellLattice::NONE;
    return findCell(other) == NO_CELL ? _map.getAnchor(other) : UNKNOWN;
}

WindowBuilder::Column WindowBuilder::makeColumn(int cell, int height) const
{
    Column column;
    column.color = LayoutCell::ANY_COLOR;
    const CellLattice& lattice = _map.getLattice();
    column.contacts[0] = findContact(cell, CellLattice::BELOW);
    for (int z = 0; z < height; ++z)
    {
        const auto index = static_cast<std::size_t>(cell);
        const auto color = PartSizes::join(column.color, lattice.getColor(_cells[index]));
        if (!color) break;
        column.color = *color;
        column.cells.add(cell);
        const int west = _neighbors[index][CellLattice::WEST];
        const int south = _neighbors[index][CellLattice::SOUTH];
        column.eastSeam += _seams[index][0];
        column.northSeam += _seams[index][1];
        column.sum += _seams[index][0] + _seams[index][1];
        if (west != NO_CELL) column.sum += _seams[static_cast<std::size_t>(west)][0];
        if (south != NO_CELL) column.sum += _seams[static_cast<std::size_t>(south)][1];
        if (z + 1 == height)
        {
            column.exists = true;
            column.contacts[1] = findContact(cell, CellLattice::ABOVE);
            break;
        }
        cell = _neighbors[index][CellLattice::ABOVE];
        if (cell == NO_CELL) break;
    }
    return column;
}

void WindowBuilder::addPartsAt(int cell, int height, const std::vector<Column>& columns)
{
    if (!columns[static_cast<std::size_t>(cell)].exists) return;
    extend(cell, height, columns, true, 1, 1);
    extend(cell, height, columns, true, 2, 1);
    extend(cell, height, columns, false, 1, 3);
    extend(cell, height, columns, false, 2, 3);
}

/** Add the parts that begin at a cell, are one or two columns wide and extend along x or y, the shortest first. */
void WindowBuilder::extend(int cell, int height, const std::vector<Column>& columns, bool isAlongX, int breadth,
                           int shortest)
{
    const CellLattice::Side along = isAlongX ? CellLattice::EAST : CellLattice::NORTH;
    const CellLattice::Side across = isAlongX ? CellLattice::NORTH : CellLattice::EAST;
    WindowPart part;
    std::uint16_t color = LayoutCell::ANY_COLOR;
    int seams = 0;
    Contacts contacts;
    int next = cell;
    for (int length = 1; length <= PartSizes::LONGEST && next != NO_CELL; ++length)
    {
        int beside = next;
        for (int i = 0; i < breadth; ++i)
        {
            if (beside == NO_CELL) return;
            const Column& column = columns[static_cast<std::size_t>(beside)];
            const auto joint = PartSizes::join(color, column.color);
            if (!column.exists || !joint) return;
            color = *joint;
            part.cells |= column.cells;
            seams += column.sum;
            for (const Index contact : column.contacts)
                contacts.add(contact);
            if (i + 1 == breadth) break;
            seams -= 2 * (isAlongX ? column.northSeam : column.eastSeam);
            beside = _neighbors[static_cast<std::size_t>(beside)][across];
        }
        const auto longSide = static_cast<std::uint8_t>(length);
        const auto shortSide = static_cast<std::uint8_t>(breadth);
        part.shape = {isAlongX ? longSide : shortSide, isAlongX ? shortSide : longSide,
                      static_cast<std::uint8_t>(height)};
        const bool isMade = _sizes.isMade(part.shape, color);
        if (length >= shortest && (isMade || _sizes.isAllowed(part.shape, color)))
        {
            part.cost = LayoutCosts::PART + seams + (isMade ? 0 : LayoutCosts::UNMADE);
            if (contacts.first == CellLattice::NONE && height == 1) part.cost += LayoutCosts::COMPONENT;
            if (contacts.first >= 0 && !contacts.areSeveral) part.cost += _leafCost;
            _parts.parts.push_back(part);
        }
        // There are no seams between these columns and the next ones of the same part.
        beside = next;
        for (int i = 0; i < breadth; ++i)
        {
            const Column& column = columns[static_cast<std::size_t>(beside)];
            seams -= 2 * (isAlongX ? column.eastSeam : column.northSeam);
            beside = _neighbors[static_cast<std::size_t>(beside)][across];
        }
        next = _neighbors[static_cast<std::size_t>(next)][along];
    }
}

void WindowBuilder::keepTogether(Index cell, Index other)
{
    const int a = findCell(cell);
    const int b = findCell(other);
    std::size_t kept = 0;
    for (std::size_t first = 0; first + 1 < _parts.starts.size(); ++first)
    {
        const auto begin = static_cast<std::size_t>(_parts.starts[first]);
        const auto end = static_cast<std::size_t>(_parts.starts[first + 1]);
        _parts.starts[first] = static_cast<int>(kept);
        for (std::size_t i = begin; i < end; ++i)
            if (_parts.parts[i].cells.contains(a) == _parts.parts[i].cells.contains(b))
                _parts.parts[kept++] = _parts.parts[i];
    }
    _parts.starts.back() = static_cast<int>(kept);
    _parts.parts.resize(kept);
}

int WindowBuilder::computeCost() const
{
    int cost = 0;
    for (const Index anchor : _anchors)
    {
        const auto cell = static_cast<std::size_t>(findCell(anchor));
        for (int i = _parts.starts[cell]; i < _parts.starts[cell + 1]; ++i)
            if (_parts.parts[static_cast<std::size_t>(i)].shape == _map.getShape(anchor))
                cost += _parts.parts[static_cast<std::size_t>(i)].cost;
    }
    return cost;
}

} // namespace osgLego
