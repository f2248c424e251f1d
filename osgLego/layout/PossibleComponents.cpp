#include <osgLego/layout/PossibleComponents.h>

#include <osgLego/PartType.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/layout/IndexLayer.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace osgLego
{

namespace
{

constexpr unsigned int ONE_BY_TWO = 2; // the bit of PART_SIZES[1]

/** A size of PART_SIZES in one of its directions. */
struct Footprint
{
    glm::ivec2 size{1};
    unsigned int bit = 1; //!< of a set of sizes
};

std::vector<Footprint> createFootprints()
{
    std::vector<Footprint> footprints;
    for (std::size_t index = 0; index < PART_SIZES.size(); ++index)
    {
        const auto [width, length] = PART_SIZES[index];
        footprints.push_back({{width, length}, 1u << index});
        if (width != length) footprints.push_back({{length, width}, 1u << index});
    }
    return footprints;
}

/** Joins the cells of columns, two or more cells above each other, layer by layer. */
class ColumnSearch
{
public:
    explicit ColumnSearch(const LayoutProblem& problem) :
        _problem(problem), _isInColumn(problem.cells.size(), 0), _layer(problem.size), _other(problem.size)
    {
        _sets.reset(problem.cells.size());
        for (const LayoutColor& color : problem.colors)
        {
            _sizes.push_back(problem.isOfPlates ? color.plates : color.bricks);
            _sizesOfColumns.push_back(_sizes.back() | color.bricks);
        }
    }

    std::size_t count()
    {
        forEachLayer([this](std::uint32_t begin, std::uint32_t end) { findColumns(begin, end); });
        std::size_t numAlone = 0;
        forEachLayer(
            [this, &numAlone](std::uint32_t begin, std::uint32_t end)
            {
                joinNeighbours(begin, end);
                numAlone += countAlone(joinAcross(begin, end));
            });
        std::size_t numRoots = 0;
        for (std::size_t cell = 0; cell < _isInColumn.size(); ++cell)
            if (_isInColumn[cell] && _sets.find(static_cast<std::int32_t>(cell)) == static_cast<std::int32_t>(cell))
                ++numRoots;
        return numRoots + numAlone;
    }

    /** Call this after count(). */
    std::vector<std::int32_t> getComponents()
    {
        std::vector<std::int32_t> components(_isInColumn.size(), NO_COMPONENT);
        for (std::size_t cell = 0; cell < components.size(); ++cell)
            if (_isInColumn[cell]) components[cell] = _sets.find(static_cast<std::int32_t>(cell));
        return components;
    }

private:
    const LayoutCell& getCell(std::uint32_t index) const { return _problem.cells[index]; }

    /** Enter the cells of each layer in turn, and call a function with their range. */
    template <class Visit>
    void forEachLayer(const Visit& visit)
    {
        _layer.clear();
        const auto numCells = static_cast<std::uint32_t>(_problem.cells.size());
        for (std::uint32_t begin = 0, end = 0; begin < numCells; begin = end)
        {
            std::swap(_layer, _other);
            _layer.clear();
            for (end = begin; end < numCells && getCell(end).place[2] == getCell(begin).place[2]; ++end)
                _layer.fill({getCell(end).place[0], getCell(end).place[1]}, {1, 1}, end);
            visit(begin, end);
        }
    }

    void findColumns(std::uint32_t begin, std::uint32_t end)
    {
        for (std::uint32_t cell = begin; cell < end; ++cell)
        {
            const std::uint32_t below = _other.get(getCell(cell).place[0], getCell(cell).place[1]);
            if (below == IndexLayer::NONE || getCell(below).place[2] + 1 != getCell(cell).place[2]) continue;
            _isInColumn[below] = _isInColumn[cell] = 1;
            join(below, cell);
        }
    }

    void join(std::uint32_t first, std::uint32_t second)
    {
        _sets.join(static_cast<std::int32_t>(first), static_cast<std::int32_t>(second));
    }

    /** The sizes of a colour; of all colours for LayoutCell::ANY_COLOR. */
    static unsigned int getSizes(const std::vector<unsigned int>& sizes, std::uint16_t color)
    {
        if (color != LayoutCell::ANY_COLOR) return sizes[color];
        return std::accumulate(sizes.begin(), sizes.end(), 0u, [](unsigned int a, unsigned int b) { return a | b; });
    }

    /** Find the colour of a part that covers cells of two colours; false if there is none. */
    static bool mix(std::uint16_t& color, std::uint16_t other)
    {
        if (color == LayoutCell::ANY_COLOR) color = other;
        return other == LayoutCell::ANY_COLOR || color == other;
    }

    void joinNeighbours(std::uint32_t begin, std::uint32_t end)
    {
        for (std::uint32_t cell = begin; cell < end; ++cell)
        {
            const int x = getCell(cell).place[0];
            const int y = getCell(cell).place[1];
            for (const std::uint32_t neighbour : {_layer.get(x + 1, y), _layer.get(x, y + 1)})
            {
                if (neighbour == IndexLayer::NONE || !_isInColumn[cell] || !_isInColumn[neighbour]) continue;
                std::uint16_t color = getCell(cell).color;
                if (mix(color, getCell(neighbour).color) && (getSizes(_sizesOfColumns, color) & ONE_BY_TWO) != 0)
                    join(cell, neighbour);
            }
        }
    }

    /** Join columns through parts that contain cells in no column, or have a colour in which 1x2 was never made.
     * @return the cells in no column that no part joins to a column. */
    std::vector<std::uint32_t> joinAcross(std::uint32_t begin, std::uint32_t end)
    {
        std::vector<std::uint32_t> alone;
        for (std::uint32_t cell = begin; cell < end; ++cell)
        {
            const bool isPair = (getSizes(_sizesOfColumns, getCell(cell).color) & ONE_BY_TWO) != 0;
            if (_isInColumn[cell] && isPair) continue;
            bool isJoined = false;
            forEachPartAt(cell, [this, &isJoined](const auto& covered) { isJoined |= joinColumns(covered); });
            if (!isJoined && !_isInColumn[cell]) alone.push_back(cell);
        }
        return alone;
    }

    /** @return whether one of the cells is in a column. */
    bool joinColumns(const std::vector<std::uint32_t>& cells)
    {
        std::uint32_t first = IndexLayer::NONE;
        for (const std::uint32_t cell : cells)
        {
            if (!_isInColumn[cell]) continue;
            if (first == IndexLayer::NONE) first = cell;
            join(first, cell);
        }
        return first != IndexLayer::NONE;
    }

    /** Count cells of a layer no two of which can be in one part. */
    std::size_t countAlone(const std::vector<std::uint32_t>& alone)
    {
        std::set<std::uint32_t> reached;
        std::size_t count = 0;
        for (const std::uint32_t cell : alone)
        {
            if (reached.contains(cell)) continue;
            ++count;
            forEachPartAt(cell, [&reached](const auto& covered) { reached.insert(covered.begin(), covered.end()); });
        }
        return count;
    }

    /** Call a function with the cells of each part that could cover a cell. */
    template <class Visit>
    void forEachPartAt(std::uint32_t cell, const Visit& visit)
    {
        const int x = getCell(cell).place[0];
        const int y = getCell(cell).place[1];
        for (const Footprint& footprint : _footprints)
            for (int beginY = y - footprint.size.y + 1; beginY <= y; ++beginY)
                for (int beginX = x - footprint.size.x + 1; beginX <= x; ++beginX)
                    if (collect({beginX, beginY}, footprint)) visit(_covered);
    }

    /** Collect the cells of a part; false if it doesn't fit. */
    bool collect(const glm::ivec2& place, const Footprint& footprint)
    {
        const glm::ivec2 end = place + footprint.size;
        if (place.x < 0 || place.y < 0 || end.x > _problem.size.x || end.y > _problem.size.y) return false;
        _covered.clear();
        std::uint16_t color = LayoutCell::ANY_COLOR;
        bool isOfColumns = true;
        for (int y = place.y; y < end.y; ++y)
            for (int x = place.x; x < end.x; ++x)
            {
                const std::uint32_t cell = _layer.get(x, y);
                if (cell == IndexLayer::NONE || !mix(color, getCell(cell).color)) return false;
                _covered.push_back(cell);
                isOfColumns &= _isInColumn[cell] != 0;
            }
        return (getSizes(isOfColumns ? _sizesOfColumns : _sizes, color) & footprint.bit) != 0;
    }

    const LayoutProblem& _problem;
    const std::vector<Footprint> _footprints = createFootprints();
    std::vector<unsigned int> _sizes;          //!< of each colour, in the height of one cell
    std::vector<unsigned int> _sizesOfColumns; //!< of each colour, in any height
    UnionFind _sets;                           //!< of the cells of columns, one for each component
    std::vector<char> _isInColumn;
    IndexLayer _layer;
    IndexLayer _other; //!< the layer before
    std::vector<std::uint32_t> _covered;
};

} // namespace

std::size_t countPossibleComponents(const LayoutProblem& problem)
{
    return ColumnSearch(problem).count();
}

std::vector<std::int32_t> findPossibleComponents(const LayoutProblem& problem)
{
    ColumnSearch search(problem);
    search.count();
    return search.getComponents();
}

} // namespace osgLego
