#pragma once

#include <osgLego/building/Symmetry.h>
#include <osgLego/stability/JointGraph.h>

#include <vector>

namespace osgLego
{

/** Move parts that join others to an earlier place, so that few parts and pieces lie beside each other for long.
 *
 * A part that joins two pieces of four parts and more on the base, but comes more than 16 parts later, is placed as
 * soon as all parts below it are in place. As soon as five parts on the base are loose, each of them that nothing joins
 * yet is followed by the part above it that needs the fewest others below it, and, before that one, by these others.
 * Parts that mirror each other stay together.
 *
 * May be called from any thread.
 * @param order all parts of the graph, in the order of building.
 * @return the new order. */
std::vector<std::uint32_t> joinEarly(const JointGraph& graph, const Symmetry& symmetry,
                                     const std::vector<std::uint32_t>& order);

} // namespace osgLego
