#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace osgLego
{

/** The next nodes of a node. */
using NextNodes = std::function<std::span<const std::uint32_t>(std::uint32_t node)>;

/** Find the nodes of a directed graph that can reach each other (Tarjan, "Depth-first search and linear graph
 * algorithms", 1972).
 * @return groups of at least two nodes, each in ascending order. */
std::vector<std::vector<std::uint32_t>> findStronglyConnected(std::size_t numNodes, const NextNodes& getNext);

} // namespace osgLego
