#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** Count the components that every layout of some cells has at least.
 *
 * Cells with a cell above or below are connected to it in every layout. Two such columns can be connected if a part
 * that contains cells of both exists in a colour that suits all its cells. A cell without a cell above and below needs
 * a part that it shares with a column; if no part reaches a column from it, its part is a component of its own, and the
 * largest parts give a bound on how many of those there are. */
std::size_t countPossibleComponents(const LayoutProblem& problem);

constexpr std::int32_t NO_COMPONENT = -1;

/** For each cell, the possible component that every layout connects it to: the same number for two cells if a layout
 * may connect them, different numbers if none can. NO_COMPONENT for cells without a cell above and below. */
std::vector<std::int32_t> findPossibleComponents(const LayoutProblem& problem);

} // namespace osgLego
