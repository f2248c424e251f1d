#include <osgLego/layout/ConnectionCheck.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace osgLego
{

namespace
{

constexpr std::array VERTICAL{CellLattice::ABOVE, CellLattice::BELOW};
constexpr std::int32_t UNKNOWN = -1;

} // namespace

ConnectionCheck::ConnectionCheck(const PartMap& map) :
    _map(map), _numbers(static_cast<std::size_t>(map.getLattice().getNumCells()), UNKNOWN)
{
}

std::int32_t ConnectionCheck::addOutside(Index anchor)
{
    std::int32_t& number = _numbers[static_cast<std::size_t>(anchor)];
    if (number == UNKNOWN)
    {
        number = static_cast<std::int32_t>(_outside.size());
        _outside.push_back(anchor);
        _base.add();
    }
    return number;
}

/** Connect the first `end` parts outside by parts that touch two of them. */
void ConnectionCheck::connectOutside(std::size_t end, const LayoutRegion& region)
{
    const CellLattice& lattice = _map.getLattice();
    for (std::size_t i = 0; i < end; ++i)
        _map.visitPart(_outside[i],
                       [&](Index cell)
                       {
                           for (const auto side : VERTICAL)
                           {
                               const Index other = lattice.getNeighbor(cell, side);
                               if (other == CellLattice::NONE || _window->findCell(other) != WindowBuilder::NO_CELL)
                                   continue;
                               if (region.isReadable(lattice, other))
                                   _base.join(static_cast<std::int32_t>(i), addOutside(_map.getAnchor(other)));
                           }
                       });
}

void ConnectionCheck::start(const WindowBuilder& window, const LayoutRegion& region)
{
    for (const Index anchor : _outside)
        _numbers[static_cast<std::size_t>(anchor)] = UNKNOWN;
    _outside.clear();
    _contacts.clear();
    _base.reset(0);
    _window = &window;
    const CellLattice& lattice = _map.getLattice();
    for (std::size_t i = 0; i < window.getCells().size(); ++i)
        for (const auto side : VERTICAL)
        {
            const Index other = lattice.getNeighbor(window.getCells()[i], side);
            if (other == CellLattice::NONE || window.findCell(other) != WindowBuilder::NO_CELL) continue;
            _contacts.emplace_back(static_cast<int>(i), addOutside(_map.getAnchor(other)));
        }
    const std::size_t numTouching = _outside.size();
    connectOutside(numTouching, region);

    _owners.resize(window.getCells().size());
    int numOwners = 0;
    for (const Index anchor : window.getAnchors())
    {
        _map.visitPart(anchor,
                       [&](Index cell) { _owners[static_cast<std::size_t>(window.findCell(cell))] = numOwners; });
        ++numOwners;
    }
    partition(_owners, numOwners, _before);
}

/** Connect the parts outside by the parts of the window that own its cells. */
void ConnectionCheck::partition(const std::vector<int>& owners, int numOwners, Partition& partition)
{
    partition.sets = _base;
    const auto first = static_cast<std::int32_t>(_outside.size());
    for (int i = 0; i < numOwners; ++i)
        partition.sets.add();
    const auto number = [&](int cell) { return first + owners[static_cast<std::size_t>(cell)]; };
    for (const auto& [cell, outside] : _contacts)
        partition.sets.join(number(cell), outside);
    for (int cell = 0; cell < static_cast<int>(owners.size()); ++cell)
    {
        const int above = _window->findCell(
            _map.getLattice().getNeighbor(_window->getCells()[static_cast<std::size_t>(cell)], CellLattice::ABOVE));
        if (above != WindowBuilder::NO_CELL) partition.sets.join(number(cell), number(above));
    }
    partition.numLoose = 0;
    for (int i = 0; i < numOwners; ++i)
        partition.numLoose += partition.sets.find(first + i) == first + i ? 1 : 0;
}

bool ConnectionCheck::keepsConnections(const std::vector<int>& chosen)
{
    for (std::size_t i = 0; i < chosen.size(); ++i)
        _window->getParts().parts[static_cast<std::size_t>(chosen[i])].cells.visit(
            [&](int cell) { _owners[static_cast<std::size_t>(cell)] = static_cast<int>(i); });
    partition(_owners, static_cast<int>(chosen.size()), _after);
    if (_after.numLoose > _before.numLoose) return false;
    _roots.assign(_outside.size(), UNKNOWN);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(_outside.size()); ++i)
    {
        std::int32_t& root = _roots[static_cast<std::size_t>(_before.sets.find(i))];
        if (root == UNKNOWN) root = _after.sets.find(i);
        if (root != _after.sets.find(i)) return false;
    }
    return true;
}

} // namespace osgLego
