#include <osgLego/polygonization/DrawnBricks.h>

#include <algorithm>

namespace osgLego
{

namespace
{

// Highlighted parts have wider lines than others, and have them even if BrickAppearance has none.
constexpr double HIGHLIGHT = 2.0;
constexpr double LEAST_WIDTH = 1.0;

} // namespace

BrickLines::BrickLines(double outline, bool isHighlighted, const osg::Matrixd& cellsToEye,
                       const osg::Matrixd& projection, double pictureWidth)
{
    const double least = isHighlighted && outline == 0.0 ? LEAST_WIDTH : outline;
    width = static_cast<float>(isHighlighted ? HIGHLIGHT * least : least);
    oldWidth = static_cast<float>(least);
    const double cell = osg::Matrixd::transform3x3(osg::Vec3d(1.0, 0.0, 0.0), cellsToEye).length();
    pixelWidth = 2.0 / (pictureWidth * projection(0, 0) * cell) * glm::dvec2(projection(3, 3), projection(2, 3));
}

DrawnBricks::DrawnBricks(const ContextBricks& bricks, const BrickLines& brickLines) :
    grid(bricks.bricks->getGrid()), buffer(bricks.buffer.get()), count(bricks.numBricks), blocks(bricks.blocks),
    lines(brickLines)
{
}

DrawnBricks::DrawnBricks(const ContextBricks& bricks, const BuildingState& state, const BrickLines& brickLines) :
    grid(bricks.building->getModel().getGrid()), buffer(bricks.buildingBuffer.get()), ranks(bricks.rankBuffer.get()),
    count(static_cast<GLsizei>(bricks.building->getPoints().points.size())),
    blocks(bricks.building->getPoints().blocks), lines(brickLines)
{
    const std::size_t placed = bricks.building->getNumPlaced(state.progress);
    const std::size_t added = state.numNew > 0 ? std::min(state.numNew, placed) : placed;
    numPlaced = static_cast<std::uint32_t>(placed);
    numOld = static_cast<std::uint32_t>(placed - added);
}

} // namespace osgLego
