#pragma once

#include <osgLego/layout/LayoutRegion.h>
#include <osgLego/layout/UnionFind.h>
#include <osgLego/layout/WindowBuilder.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

/** Decides whether laying a window again may separate parts of the model from each other.
 *
 * It looks only at the parts around the window and the next ones: parts that are also connected farther away count as
 * separate. So a layout that passes never has more components, and some harmless ones fail.
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

private:
    struct Partition
    {
        UnionFind sets;
        int numLoose = 0; //!< components inside the window that no part outside is connected to
    };

    std::int32_t addOutside(Index anchor);
    void connectOutside(std::size_t end, const LayoutRegion& region);
    void partition(const std::vector<int>& owners, int numOwners, Partition& partition);

    const PartMap& _map;
    const WindowBuilder* _window = nullptr;
    std::vector<std::int32_t> _numbers; //!< of the anchors of parts outside; -1 for others
    std::vector<Index> _outside;
    std::vector<std::pair<int, std::int32_t>> _contacts; //!< a cell of the window, and a part outside
    UnionFind _base;                                     //!< the parts outside
    Partition _before;
    Partition _after;
    std::vector<int> _owners; //!< of each cell of the window
    std::vector<std::int32_t> _roots;
};

} // namespace osgLego
