#include <osgLego/model/JoinPruning.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/LaidBox.h>
#include <osgLego/model/LayoutPieces.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace osgLego
{

namespace
{

using Cells = std::unordered_set<CellKey>;

/** A row of cells at an end of a part. */
struct End
{
    std::size_t axis = 0; //!< 0 or 1
    bool isUpper = false;
};

constexpr std::array<End, 4> ENDS{{{0, false}, {0, true}, {1, false}, {1, true}}};

bool isAdded(const LaidPart& part, const Cells& added)
{
    bool isAdded = true;
    visitCells(toBox(part), [&](const glm::ivec3& cell) { isAdded = isAdded && added.contains(toCellKey(cell)); });
    return isAdded;
}

LaidPart takeEnd(const LaidPart& part, const End& end)
{
    LaidPart taken = part;
    if (end.isUpper) taken.place[end.axis] = static_cast<std::uint16_t>(part.place[end.axis] + part.size[end.axis] - 1);
    taken.size[end.axis] = 1;
    return taken;
}

LaidPart cutEnd(const LaidPart& part, const End& end)
{
    LaidPart rest = part;
    --rest.size[end.axis];
    if (!end.isUpper) ++rest.place[end.axis];
    return rest;
}

/** The layout without some cells of a part, if they are added ones and it has no more pieces then. */
class Pruning
{
public:
    explicit Pruning(JoinedLayout& layout) : _layout(layout), _numPieces(LayoutPieces(layout.parts).getCount())
    {
        for (const glm::ivec3& cell : layout.added)
            _added.insert(toCellKey(cell));
    }

    void run()
    {
        for (std::size_t part = 0; part < _layout.parts.size();)
            if (!shorten(part)) ++part;
        const auto isGone = [&](const glm::ivec3& cell) { return !_added.contains(toCellKey(cell)); };
        _layout.added.erase(std::remove_if(_layout.added.begin(), _layout.added.end(), isGone), _layout.added.end());
        std::vector<LayoutCell>& cells = _layout.problem.cells;
        cells.erase(
            std::remove_if(cells.begin(), cells.end(),
                           [&](const LayoutCell& cell) {
                               return _removed.contains(toCellKey({cell.place[0], cell.place[1], cell.place[2]}));
                           }),
            cells.end());
    }

private:
    /** @return whether the part has changed or is gone. */
    bool shorten(std::size_t index)
    {
        const LaidPart part = _layout.parts[index];
        if (isAdded(part, _added))
        {
            LaidParts parts = _layout.parts;
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(index));
            return accept(std::move(parts), part);
        }
        for (const End& end : ENDS)
        {
            const LaidPart taken = takeEnd(part, end);
            if (part.size[end.axis] == 1 || !isAdded(taken, _added)) continue;
            const LaidPart rest = cutEnd(part, end);
            if (!findPartType(_layout.problem, rest) || !isAvailable(_layout.problem, rest)) continue;
            LaidParts parts = _layout.parts;
            parts[index] = rest;
            if (accept(std::move(parts), taken)) return true;
        }
        return false;
    }

    bool accept(LaidParts parts, const LaidPart& removed)
    {
        if (LayoutPieces(parts).getCount() > _numPieces) return false;
        _layout.parts = std::move(parts);
        visitCells(toBox(removed),
                   [&](const glm::ivec3& cell)
                   {
                       _added.erase(toCellKey(cell));
                       _removed.insert(toCellKey(cell));
                   });
        return true;
    }

    JoinedLayout& _layout;
    std::size_t _numPieces;
    Cells _added;
    Cells _removed;
};

} // namespace

void removeUnneededCells(JoinedLayout& layout)
{
    if (layout.added.empty()) return;
    Pruning(layout).run();
}

} // namespace osgLego
