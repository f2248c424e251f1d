#include "ConnectionModels.h"

#include <osgLego/layout/LayoutModel.h>

#include <Layouts.h>

namespace osgLego
{

namespace
{

std::vector<PaletteColor> createColors()
{
    return {{4, "Red", {200, 0, 0}}, {5, "Similar Red", {190, 0, 8}}, {15, "White", {255, 255, 255}}};
}

LayoutProblem createCells(const std::vector<std::vector<std::string>>& layers)
{
    LayoutProblem problem = drawProblem(layers);
    problem.colors.resize(createColors().size());
    return problem;
}

/** The model of the cells before their layout: visible cells in their own colours. */
osg::ref_ptr<const BrickModel> createSurface(const LayoutProblem& problem)
{
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, 1.2};
    grid.dimensions = problem.size;
    std::vector<Brick> bricks;
    for (const LayoutCell& cell : problem.cells)
        if (cell.color != LayoutCell::ANY_COLOR) bricks.push_back({cell.place, createColors()[cell.color].color});
    return BrickModel::create(grid, std::move(bricks));
}

} // namespace

ColoredCells drawColoredCells(const std::vector<std::vector<std::string>>& layers)
{
    const LayoutProblem problem = createCells(layers);
    return {problem, RecoloringCosts(*createSurface(problem), createColors())};
}

} // namespace osgLego
