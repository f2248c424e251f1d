#include <osgLego/search/PartCut.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

constexpr std::size_t MOST_CUTS = 6;
constexpr std::size_t NEAR_PARTS = 40; // examined before parts count as separate
/** The lengths of parts that cover a strip, by its length. There are no parts of 5 and 7 cells. */
constexpr std::array<std::array<int, 2>, PartSizes::LONGEST + 1> LENGTHS_IN_STRIP{
    {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {3, 2}, {6, 0}, {4, 3}, {8, 0}}};

} // namespace

bool PartCut::cover(const Piece& bridge, const LayoutRegion& region)
{
    const CellLattice& lattice = _map.getLattice();
    const std::array<int, 2> begin{lattice.getX(bridge.anchor), lattice.getY(bridge.anchor)};
    _cuts.clear();
    _bridge = bridge;
    std::uint16_t color = LayoutCell::ANY_COLOR;
    Index level = bridge.anchor;
    for (int z = 0; z < bridge.shape.height; ++z, level = lattice.move(level, CellLattice::ABOVE, 1))
    {
        Index row = level;
        for (int y = 0; y < bridge.shape.depth; ++y, row = lattice.move(row, CellLattice::NORTH, 1))
        {
            Index cell = row;
            for (int x = 0; x < bridge.shape.width; ++x, cell = lattice.move(cell, CellLattice::EAST, 1))
            {
                if (cell == CellLattice::NONE) return false;
                const auto joint = PartSizes::join(color, lattice.getColor(cell));
                if (!joint || !addCell(cell, {begin[0] + x, begin[1] + y}, region)) return false;
                color = *joint;
            }
        }
    }
    return _sizes.isMade(bridge.shape, color);
}

/** Note that the part laid covers a cell. @return false if the cell's part may not be cut, or too many parts are. */
bool PartCut::addCell(Index cell, const std::array<int, 2>& place, const LayoutRegion& region)
{
    const Index anchor = _map.getAnchor(cell);
    const auto cut = findCut(anchor);
    if (cut == _cuts.end())
    {
        if (_cuts.size() == MOST_CUTS || !region.isActive(anchor)) return false;
        const std::uint16_t color = _map.getLattice().getColor(anchor);
        _cuts.push_back({anchor,
                         color == LayoutCell::ANY_COLOR ? _map.getColor(anchor) : color,
                         {place, {place[0] + 1, place[1] + 1}}});
        return true;
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
        cut->covered.begin[axis] = std::min(cut->covered.begin[axis], place[axis]);
        cut->covered.end[axis] = std::max(cut->covered.end[axis], place[axis] + 1);
    }
    return true;
}

std::vector<PartCut::Cut>::iterator PartCut::findCut(Index anchor)
{
    return std::ranges::find(_cuts, anchor, &Cut::anchor);
}

bool PartCut::divide()
{
    _pieces.assign(1, _bridge);
    for (Cut& cut : _cuts)
    {
        cut.firstPiece = _pieces.size();
        if (!divide(cut)) return false;
    }
    return true;
}

/** Add the pieces that remain of a part. @return false if one was never made. */
bool PartCut::divide(Cut& cut)
{
    const CellLattice& lattice = _map.getLattice();
    const PartShape& shape = _map.getShape(cut.anchor);
    const int begin = lattice.getZ(cut.anchor);
    const int bridgeBegin = lattice.getZ(_bridge.anchor) - begin;
    const int bridgeEnd = bridgeBegin + _bridge.shape.height;
    const int first = std::max(bridgeBegin, 0);
    const int height = std::min(bridgeEnd, int{shape.height}) - first;
    // The part laid may cover two parts above each other. They remain connected if their strips are connected to it.
    cut.isTouched = height < _bridge.shape.height;
    if (height == shape.height) return addStrips(cut, 0, height);
    // A brick that is cut horizontally becomes plates.
    const PartShape plate{shape.width, shape.depth, 1};
    if (height != 1 || !_sizes.isMade(plate, cut.color)) return false;
    for (int layer = 0; layer < shape.height; ++layer)
        if (layer != first) _pieces.push_back({lattice.move(cut.anchor, CellLattice::ABOVE, layer), plate});
    return addStrips(cut, first, height);
}

/** Add the fewest strips that remain in some layers of a part, from `layer` on. */
bool PartCut::addStrips(const Cut& cut, int layer, int height)
{
    const bool isPossible = addStripsAlong(0, cut, layer, height, _strips);
    const bool isOtherPossible = addStripsAlong(1, cut, layer, height, _otherStrips);
    if (!isPossible && !isOtherPossible) return false;
    const bool isOtherBetter = !isPossible || (isOtherPossible && _otherStrips.size() < _strips.size());
    const std::vector<Piece>& strips = isOtherBetter ? _otherStrips : _strips;
    _pieces.insert(_pieces.end(), strips.begin(), strips.end());
    return true;
}

/** List strips beside the covered cells: first those across the whole part at both ends along an axis. */
bool PartCut::addStripsAlong(std::size_t axis, const Cut& cut, int layer, int height, std::vector<Piece>& strips) const
{
    const CellLattice& lattice = _map.getLattice();
    const PartShape& shape = _map.getShape(cut.anchor);
    Rectangle rest{{lattice.getX(cut.anchor), lattice.getY(cut.anchor)}, {}};
    rest.end = {rest.begin[0] + shape.width, rest.begin[1] + shape.depth};
    strips.clear();
    for (const std::size_t along : {axis, 1 - axis})
    {
        Rectangle before = rest;
        Rectangle after = rest;
        before.end[along] = rest.begin[along] = cut.covered.begin[along];
        after.begin[along] = rest.end[along] = cut.covered.end[along];
        if (!addStrip(cut, before, layer, height, strips) || !addStrip(cut, after, layer, height, strips)) return false;
    }
    return true;
}

bool PartCut::addStrip(const Cut& cut, const Rectangle& strip, int layer, int height, std::vector<Piece>& strips) const
{
    const std::array<int, 2> size{strip.end[0] - strip.begin[0], strip.end[1] - strip.begin[1]};
    if (size[0] <= 0 || size[1] <= 0) return true;
    const CellLattice& lattice = _map.getLattice();
    const bool isAlongX = size[0] >= size[1];
    Index place = lattice.move(cut.anchor, CellLattice::ABOVE, layer);
    place = lattice.move(place, CellLattice::NORTH, strip.begin[1] - lattice.getY(cut.anchor));
    place += strip.begin[0] - lattice.getX(cut.anchor);
    for (const int length : LENGTHS_IN_STRIP[static_cast<std::size_t>(isAlongX ? size[0] : size[1])])
    {
        if (length == 0) break;
        const PartShape shape{static_cast<std::uint8_t>(isAlongX ? length : size[0]),
                              static_cast<std::uint8_t>(isAlongX ? size[1] : length),
                              static_cast<std::uint8_t>(height)};
        if (!_sizes.isMade(shape, cut.color)) return false;
        strips.push_back({place, shape});
        place = isAlongX ? place + length : lattice.move(place, CellLattice::NORTH, length);
    }
    return true;
}

/** Call visit(cell, neighbour) for each cell directly above or below a piece. */
template <typename Visit>
void PartCut::visitContacts(const Piece& piece, Visit visit) const
{
    const CellLattice& lattice = _map.getLattice();
    const PartShape base{piece.shape.width, piece.shape.depth, 1};
    const Index top = lattice.move(piece.anchor, CellLattice::ABOVE, piece.shape.height - 1);
    const std::array<std::pair<Index, CellLattice::Side>, 2> ends{
        {{piece.anchor, CellLattice::BELOW}, {top, CellLattice::ABOVE}}};
    for (const auto& [first, side] : ends)
        _map.visitCells(first, base,
                        [&, side = side](Index cell)
                        {
                            const Index other = lattice.getNeighbor(cell, side);
                            if (other != CellLattice::NONE) visit(cell, other);
                        });
}

bool PartCut::touchesSeveral(UnionFind& components) const
{
    Index found = CellLattice::NONE;
    bool areSeveral = false;
    visitContacts(_bridge,
                  [&](Index cell, Index)
                  {
                      const Index component = components.find(cell);
                      areSeveral |= found != CellLattice::NONE && found != component;
                      found = component;
                  });
    return areSeveral;
}

bool PartCut::touchesAll() const
{
    return std::all_of(_pieces.begin(), _pieces.end(),
                       [&](const Piece& piece)
                       {
                           bool touches = false;
                           visitContacts(piece, [&](Index, Index) { touches = true; });
                           return touches;
                       });
}

/** The piece that covers a cell of a part that is cut. */
std::size_t PartCut::findPiece(Index cell) const
{
    for (std::size_t piece = 0; piece < _pieces.size(); ++piece)
    {
        bool isCovered = false;
        _map.visitCells(_pieces[piece].anchor, _pieces[piece].shape, [&](Index other) { isCovered |= other == cell; });
        if (isCovered) return piece;
    }
    return 0;
}

/** Number a part around the pieces, or find its number. */
std::int32_t PartCut::addOutside(Index anchor)
{
    const auto index = static_cast<std::size_t>(anchor);
    if (_searches[index] != _numSearches)
    {
        _searches[index] = _numSearches;
        _numbers[index] = static_cast<std::int32_t>(_sets.getCount());
        _sets.add();
        _outside.push_back(anchor);
    }
    return _numbers[index];
}

/** Connect the pieces to the parts above and below. */
void PartCut::connectPieces()
{
    for (std::size_t piece = 0; piece < _pieces.size(); ++piece)
        visitContacts(_pieces[piece],
                      [&](Index cell, Index other)
                      {
                          const Index anchor = _map.getAnchor(other);
                          const std::int32_t number = findCut(anchor) == _cuts.end()
                                                          ? addOutside(anchor)
                                                          : static_cast<std::int32_t>(findPiece(other));
                          _sets.join(static_cast<std::int32_t>(piece), number);
                          if (piece == 0) findCut(_map.getAnchor(cell))->isTouched = true;
                      });
}

/** Connect the first `end` parts around the pieces to their neighbours. */
void PartCut::connectOutside(std::size_t end)
{
    for (; _numConnected < end; ++_numConnected)
    {
        const Index part = _outside[_numConnected];
        const std::int32_t number = _numbers[static_cast<std::size_t>(part)];
        visitContacts({part, _map.getShape(part)},
                      [&](Index, Index other)
                      {
                          const Index anchor = _map.getAnchor(other);
                          if (findCut(anchor) == _cuts.end()) _sets.join(number, addOutside(anchor));
                      });
    }
}

/** Whether the strips of each part that is cut are connected to each other, and to the part laid if that touches
 * others that the part touched. */
bool PartCut::areConnected()
{
    for (std::size_t i = 0; i < _cuts.size(); ++i)
    {
        const std::size_t first = _cuts[i].firstPiece;
        const std::size_t end = i + 1 < _cuts.size() ? _cuts[i + 1].firstPiece : _pieces.size();
        if (first == end) continue;
        const std::int32_t set = _sets.find(static_cast<std::int32_t>(first));
        if (_cuts[i].isTouched && _sets.find(0) != set) return false;
        for (std::size_t piece = first + 1; piece < end; ++piece)
            if (_sets.find(static_cast<std::int32_t>(piece)) != set) return false;
    }
    return true;
}

bool PartCut::keepsConnections()
{
    if (_searches.empty())
    {
        _searches.resize(static_cast<std::size_t>(_map.getLattice().getNumCells()));
        _numbers.resize(_searches.size());
    }
    ++_numSearches;
    _outside.clear();
    _numConnected = 0;
    _sets.reset(_pieces.size());
    connectPieces();
    while (!areConnected())
    {
        if (_numConnected == _outside.size() || _numConnected > NEAR_PARTS) return false;
        connectOutside(_outside.size());
    }
    return true;
}

} // namespace osgLego
