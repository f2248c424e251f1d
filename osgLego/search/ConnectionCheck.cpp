#include <osgLego/search/ConnectionCheck.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace osgLego
{

namespace
{

constexpr std::array VERTICAL{CellLattice::ABOVE, CellLattice::BELOW};
constexpr std::int32_t UNKNOWN = -1;
constexpr std::size_t MAXIMUM_PARTS = 600;
constexpr std::size_t COMPLETE_VIEW = 20000;

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

/** Connect the first `end` parts outside the window to their neighbours. Connect those that no thread changes to their
 * components. */
void ConnectionCheck::connectOutside(std::size_t end)
{
    const CellLattice& lattice = _map.getLattice();
    for (; _numConnected < end; ++_numConnected)
    {
        const Index anchor = _outside[_numConnected];
        const auto number = static_cast<std::int32_t>(_numConnected);
        if (_region->fixedComponents)
        {
            const Index component = (*_region->fixedComponents)[static_cast<std::size_t>(anchor)];
            if (component != CellLattice::NONE) _base.join(number, addOutside(component));
        }
        _map.visitPart(anchor,
                       [&](Index cell)
                       {
                           for (const auto side : VERTICAL)
                           {
                               const Index other = lattice.getNeighbor(cell, side);
                               if (other == CellLattice::NONE || _window->findCell(other) != WindowBuilder::NO_CELL)
                                   continue;
                               if (_region->isReadable(lattice, other))
                                   _base.join(number, addOutside(_map.getAnchor(other)));
                           }
                       });
    }
}

/** Whether the search can connect no more sets of parts outside the window: the parts whose neighbours are unknown
 * belong to one set. A search from all sides ends soon after all sets but the largest are known, not with the whole
 * model. */
bool ConnectionCheck::isComplete()
{
    for (std::size_t i = _numConnected + 1; i < _outside.size(); ++i)
        if (_base.find(static_cast<std::int32_t>(i)) != _base.find(static_cast<std::int32_t>(_numConnected)))
            return false;
    return true;
}

/** Connect parts outside the window to their neighbours, up to `most` parts, until this is complete. */
void ConnectionCheck::explore(std::size_t most)
{
    while (_numConnected < std::min(_outside.size(), most) && !isComplete())
        connectOutside(std::min(_outside.size(), most));
}

void ConnectionCheck::start(const WindowBuilder& window, const LayoutRegion& region)
{
    for (const Index anchor : _outside)
        _numbers[static_cast<std::size_t>(anchor)] = UNKNOWN;
    _outside.clear();
    _contacts.clear();
    _base.reset(0);
    _numConnected = 0;
    _window = &window;
    _region = &region;
    const CellLattice& lattice = _map.getLattice();
    for (std::size_t i = 0; i < window.getCells().size(); ++i)
        for (const auto side : VERTICAL)
        {
            const Index other = lattice.getNeighbor(window.getCells()[i], side);
            if (other == CellLattice::NONE || window.findCell(other) != WindowBuilder::NO_CELL) continue;
            _contacts.emplace_back(static_cast<int>(i), addOutside(_map.getAnchor(other)));
        }
    _presentOwners.resize(window.getCells().size());
    int numOwners = 0;
    for (const Index anchor : window.getAnchors())
    {
        _map.visitPart(anchor, [&](Index cell)
                       { _presentOwners[static_cast<std::size_t>(window.findCell(cell))] = numOwners; });
        ++numOwners;
    }
}

/** Connect the parts outside the window through the parts inside it. @param owners for each cell of the window, the
 * index of its part. */
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
    partition.numComponents = 0;
    partition.numLoose = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(partition.sets.getCount()); ++i)
        if (partition.sets.find(i) == i) ++(i < first ? partition.numComponents : partition.numLoose);
    partition.numComponents += partition.numLoose;
}

bool ConnectionCheck::keepsConnections(const std::vector<int>& chosen)
{
    _owners.resize(_presentOwners.size());
    for (std::size_t i = 0; i < chosen.size(); ++i)
        _window->getParts().parts[static_cast<std::size_t>(chosen[i])].cells.visit(
            [&](int cell) { _owners[static_cast<std::size_t>(cell)] = static_cast<int>(i); });
    // The nearest neighbours connect the parts around most windows. Look farther only if they don't.
    for (const std::size_t numParts : {_outside.size(), MAXIMUM_PARTS})
    {
        explore(numParts);
        if (isCoarser(chosen)) return true;
    }
    return false;
}

bool ConnectionCheck::joinsComponents(const std::vector<int>& chosen)
{
    if (keepsConnections(chosen)) return _after.numComponents < _before.numComponents;
    // Parts may leave one component to join another. To count components, all parts of these components must be known.
    explore(COMPLETE_VIEW);
    if (!isComplete()) return false;
    isCoarser(chosen);
    return _after.numComponents < _before.numComponents;
}

/** Whether the chosen parts connect all parts outside the window that the present parts connect. */
bool ConnectionCheck::isCoarser(const std::vector<int>& chosen)
{
    partition(_presentOwners, static_cast<int>(_window->getAnchors().size()), _before);
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
