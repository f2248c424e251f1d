#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/search/LayoutRegion.h>
#include <osgLego/search/WindowBuilder.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

/** Decides whether laying a window again may separate parts of the model from each other.
 *
 * It examines only a limited number of parts around the window, and components of parts that no thread changes. Parts
 * that are connected only farther away count as separate. So a layout that passes never has more components, but a few
 * harmless layouts fail.
 *
 * Keeps its memory from one window to the next. One thread at a time. */
class ConnectionCheck
{
public:
    using Index = CellLattice::Index;

    ConnectionCheck(const PartMap& map);

    /** Look at the surroundings of a window. */
    void start(const WindowBuilder& window, const LayoutRegion& region);
    /** Whether parts that are connected by the present parts of the window are connected by the chosen ones too. */
    bool keepsConnections(const std::vector<int>& chosen);
    /** Whether there are fewer components too. */
    bool joinsComponents(const std::vector<int>& chosen);

private:
    struct Partition
    {
        UnionFind sets;
        int numComponents = 0;
        int numLoose = 0; //!< components inside the window that no part outside is connected to
    };

    bool isCoarser(const std::vector<int>& chosen);
    std::int32_t addOutside(Index anchor);
    void connectOutside(std::size_t end);
    void partition(const std::vector<int>& owners, int numOwners, Partition& partition);

    const PartMap& _map;
    const WindowBuilder* _window = nullptr;
    const LayoutRegion* _region = nullptr;
    std::vector<std::int32_t> _numbers; //!< of the anchors of parts outside; -1 for others
    std::vector<Index> _outside;
    std::size_t _numConnected = 0;                       //!< parts outside whose neighbours are known
    std::vector<std::pair<int, std::int32_t>> _contacts; //!< a cell of the window, and a part outside
    UnionFind _base;                                     //!< the parts outside
    std::vector<int> _presentOwners;
    Partition _before;
    Partition _after;
    std::vector<int> _owners; //!< of each cell of the window, the index of its part
    std::vector<std::int32_t> _roots;
};

} // namespace osgLego
