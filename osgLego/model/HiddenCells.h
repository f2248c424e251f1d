#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <cstdint>
#include <vector>

namespace osgLego
{

/** The empty cells near some parts that nobody would see if they were covered (CellExposure).
 * @param near indices of parts. @param reach the distance from them along each axis, in cells.
 * @return cells that may have any colour, sorted by z, y and x. */
std::vector<LayoutCell> findHiddenCells(const LayoutProblem& problem, const LaidParts& parts,
                                        const std::vector<std::uint32_t>& near, int reach);

} // namespace osgLego
