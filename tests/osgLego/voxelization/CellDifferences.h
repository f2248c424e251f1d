#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>

namespace osgLego::test
{

/** The cells in which two models of the same triangles differ. */
struct CellDifferences
{
    std::size_t within = 0; //!< cells that single precision can't decide
    std::size_t beyond = 0;
    std::size_t offColor = 0; //!< common cells whose colours are more than 2 apart
};

/** Whether a channel of two colours differs by more than 2 of 255. */
bool isColorOff(const Brick& a, const Brick& b);

CellDifferences compare(const GridTriangles& triangles, const BrickModel& cpu, const BrickModel& gpu);

} // namespace osgLego::test
