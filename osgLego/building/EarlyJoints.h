#pragma once

#include <osgLego/building/Symmetry.h>
#include <osgLego/stability/JointGraph.h>

#include <vector>

namespace osgLego
{

/** Move parts that join parts on the base to an earlier place, so that few of these lie loose beside each other until
 * the layer above comes.
 *
 * As soon as five parts on the base are loose, each of them that nothing joins yet is followed by the part above it
 * that needs the fewest others below it, and, before that one, by these others. Parts that mirror each other stay
 * together.
 *
 * May be called from any thread.
 * @param order all parts of the graph, in the order of building.
 * @return the new order. */
std::vector<std::uint32_t> joinEarly(const JointGraph& graph, const Symmetry& symmetry,
                                     const std::vector<std::uint32_t>& order);

} // namespace osgLego
