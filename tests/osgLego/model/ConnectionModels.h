#pragma once

#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/model/RecoloringCosts.h>

#include <string>
#include <vector>

namespace osgLego
{

/** Cells of a grid of bricks, and the costs of other colours for them: their surface has the colour of the cell. */
struct ColoredCells
{
    LayoutProblem problem;
    RecoloringCosts costs;
};

/** @param layers as for drawProblem(); 'a' is red, 'b' a similar red, 'c' white. */
ColoredCells drawColoredCells(const std::vector<std::vector<std::string>>& layers);

} // namespace osgLego
