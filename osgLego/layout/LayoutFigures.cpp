#include <osgLego/layout/LayoutFigures.h>

#include <osgLego/layout/IndexLayer.h>
#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/layout/PossibleComponents.h>

#include <algorithm>
#include <iterator>
#include <set>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/connected_components.hpp>

namespace osgLego
{

namespace
{

using PartGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using PartsOfLayers = std::vector<std::vector<std::uint32_t>>;

/** The parts in each layer; a part of three plates is in three of them. */
PartsOfLayers sortByLayer(const glm::ivec3& size, const LaidParts& parts)
{
    PartsOfLayers layers(static_cast<std::size_t>(size.z));
    for (std::uint32_t index = 0; index < parts.size(); ++index)
        for (std::size_t z = 0; z < parts[index].size[2]; ++z)
            layers[parts[index].place[2] + z].push_back(index);
    return layers;
}

/** Finds joints and connections layer by layer. */
class LayerWalk
{
public:
    LayerWalk(const glm::ivec3& size, const LaidParts& parts) :
        graph(parts.size()), _parts(parts), _layer(size), _below(size)
    {
        for (const std::vector<std::uint32_t>& indices : sortByLayer(size, parts))
            visitLayer(indices);
    }

    PartGraph graph; //!< an edge connects two parts
    std::size_t joints = 0;
    std::size_t stackedLength = 0;

private:
    void visitLayer(const std::vector<std::uint32_t>& indices)
    {
        std::swap(_layer, _below);
        _layer.clear();
        for (const std::uint32_t index : indices)
            enter(index);
        for (const std::uint32_t index : indices)
        {
            countJoints(index);
            connectToPartsBelow(index);
        }
    }

    void enter(std::uint32_t index)
    {
        const LaidPart& part = _parts[index];
        _layer.fill({part.place[0], part.place[1]}, {part.size[0], part.size[1]}, index);
    }

    void countJoints(std::uint32_t index)
    {
        const LaidPart& part = _parts[index];
        const int endX = part.place[0] + part.size[0];
        const int endY = part.place[1] + part.size[1];
        for (int y = part.place[1]; y < endY; ++y)
            countJoint({endX - 1, y}, {endX, y});
        for (int x = part.place[0]; x < endX; ++x)
            countJoint({x, endY - 1}, {x, endY});
    }

    void countJoint(const glm::ivec2& first, const glm::ivec2& second)
    {
        const std::uint32_t firstPart = _layer.get(first.x, first.y);
        const std::uint32_t secondPart = _layer.get(second.x, second.y);
        const std::uint32_t firstBelow = _below.get(first.x, first.y);
        const std::uint32_t secondBelow = _below.get(second.x, second.y);
        if (secondPart == IndexLayer::NONE || (firstPart == firstBelow && secondPart == secondBelow)) return;
        ++joints;
        const bool isJointBelow =
            firstBelow != IndexLayer::NONE && secondBelow != IndexLayer::NONE && firstBelow != secondBelow;
        if (isJointBelow && firstPart != firstBelow && secondPart != secondBelow) ++stackedLength;
    }

    void connectToPartsBelow(std::uint32_t index)
    {
        const LaidPart& part = _parts[index];
        _found.clear();
        for (int y = part.place[1]; y < part.place[1] + part.size[1]; ++y)
            for (int x = part.place[0]; x < part.place[0] + part.size[0]; ++x)
                if (const std::uint32_t below = _below.get(x, y); below != IndexLayer::NONE && below != index)
                    _found.insert(below);
        for (const std::uint32_t below : _found)
            boost::add_edge(below, index, graph);
    }

    const LaidParts& _parts;
    IndexLayer _layer;
    IndexLayer _below;
    std::set<std::uint32_t> _found;
};

std::size_t countArticulationParts(const PartGraph& graph)
{
    std::vector<std::size_t> found;
    boost::articulation_points(graph, std::back_inserter(found));
    return found.size();
}

/** Parts in components that don't reach the lowest layer.
 * @param components the component of each part. */
std::size_t countFloating(const LaidParts& parts, const std::vector<std::size_t>& components)
{
    const auto isLower = [](const LaidPart& a, const LaidPart& b) { return a.place[2] < b.place[2]; };
    const auto lowest = std::min_element(parts.begin(), parts.end(), isLower);
    std::vector<char> stands(parts.size(), 0);
    for (std::size_t index = 0; index < parts.size(); ++index)
        if (parts[index].place[2] == lowest->place[2]) stands[components[index]] = 1;
    return static_cast<std::size_t>(std::count_if(components.begin(), components.end(),
                                                  [&stands](std::size_t component) { return stands[component] == 0; }));
}

/** Counts borders of colours that lie on borders of colours, layer by layer. */
class BorderWalk
{
public:
    explicit BorderWalk(const LayoutProblem& problem) : _problem(problem), _layer(problem.size), _below(problem.size) {}

    std::size_t count()
    {
        std::size_t count = 0;
        const auto numCells = static_cast<std::uint32_t>(_problem.cells.size());
        for (std::uint32_t begin = 0, end = 0; begin < numCells; begin = end)
        {
            const int z = _problem.cells[begin].place[2];
            std::swap(_layer, _below);
            if (begin > 0 && _problem.cells[begin - 1].place[2] + 1 != z) _below.clear();
            _layer.clear();
            for (end = begin; end < numCells && _problem.cells[end].place[2] == z; ++end)
                _layer.fill({_problem.cells[end].place[0], _problem.cells[end].place[1]}, {1, 1}, end);
            for (std::uint32_t cell = begin; cell < end; ++cell)
                count += countAt(_problem.cells[cell].place[0], _problem.cells[cell].place[1]);
        }
        return count;
    }

private:
    std::size_t countAt(int x, int y) const
    {
        const auto isStacked = [this, x, y](int otherX, int otherY)
        { return isBorder(_layer, x, y, otherX, otherY) && isBorder(_below, x, y, otherX, otherY); };
        return (isStacked(x + 1, y) ? 1u : 0u) + (isStacked(x, y + 1) ? 1u : 0u);
    }

    bool isBorder(const IndexLayer& layer, int x, int y, int otherX, int otherY) const
    {
        const std::uint32_t cell = layer.get(x, y);
        const std::uint32_t other = layer.get(otherX, otherY);
        if (cell == IndexLayer::NONE || other == IndexLayer::NONE) return false;
        const std::uint16_t color = _problem.cells[cell].color;
        const std::uint16_t otherColor = _problem.cells[other].color;
        return color != LayoutCell::ANY_COLOR && otherColor != LayoutCell::ANY_COLOR && color != otherColor;
    }

    const LayoutProblem& _problem;
    IndexLayer _layer;
    IndexLayer _below;
};

} // namespace

LayoutFigures computeLayoutFigures(const LayoutProblem& problem, const LaidParts& parts)
{
    LayoutFigures figures;
    figures.cells = problem.cells.size();
    figures.parts = parts.size();
    figures.componentsPossible = countPossibleComponents(problem);
    if (parts.empty()) return figures;
    const LayerWalk walk(problem.size, parts);
    figures.joints = walk.joints;
    figures.stackedLength = walk.stackedLength;
    if (!problem.isOfPlates) figures.stackedBorders = BorderWalk(problem).count();
    std::vector<std::size_t> components(parts.size());
    figures.components = boost::connected_components(walk.graph, components.data());
    figures.articulationParts = countArticulationParts(walk.graph);
    figures.floating = countFloating(parts, components);
    std::set<std::uint16_t> colors;
    for (const LaidPart& part : parts)
    {
        colors.insert(part.color);
        if (!isAvailable(problem, part)) ++figures.unavailable;
    }
    figures.colors = colors.size();
    return figures;
}

} // namespace osgLego
