#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/search/LayoutRegion.h>
#include <osgLego/search/WindowBuilder.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

/** Determines whether new parts in a window may separate parts of the model from each other.
 *
 * The check examines a limited number of parts around the window, and components of parts that no thread changes. Parts
 * that are connected only farther away count as separate. Therefore layouts that pass never have more components, but a
 * few layouts fail although they separate nothing.
 *
 * Keeps its memory from one window to the next. One thread at a time. */
class ConnectionCheck
{
public:
    using Index = CellLattice::Index;

    ConnectionCheck(const PartMap& map);

    /** Examine the surroundings of a window. */
    void start(const WindowBuilder& window, const LayoutRegion& region);
    /** Whether the chosen parts connect all parts that the present parts of the window connect. */
    bool keepsConnections(const std::vector<int>& chosen);
    /** Whether the chosen parts leave fewer components than the present parts. */
    bool joinsComponents(const std::vector<int>& chosen);

private:
    struct Partition
    {
        UnionFind sets;
        int numComponents = 0;
        int numLoose = 0; //!< components that consist of parts in the window only
    };

    bool isCoarser(const std::vector<int>& chosen);
    std::int32_t addOutside(Index anchor);
    void connectOutside(std::size_t end);
    bool isComplete();
    void explore(std::size_t most);
    void partition(const std::vector<int>& owners, int numOwners, Partition& partition);

    const PartMap& _map;
    const WindowBuilder* _window = nullptr;
    const LayoutRegion* _region = nullptr;
    std::vector<std::int32_t> _numbers; //!< for each anchor of a part outside the window, its number; -1 for others
    std::vector<Index> _outside;
    std::size_t _numConnected = 0;                       //!< the number of parts outside whose neighbours are known
    std::vector<std::pair<int, std::int32_t>> _contacts; //!< a cell of the window, and a part outside
    UnionFind _base;                                     //!< of parts outside, without the window
    std::vector<int> _presentOwners;
    Partition _before;
    Partition _after;
    std::vector<int> _owners; //!< for each cell of the window, the index of its part
    std::vector<std::int32_t> _roots;
};

} // namespace osgLego
