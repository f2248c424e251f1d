#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/store/BrickStore.h>
#include <osgLego/store/ContextBricks.h>

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>
#include <osg/Matrixd>

namespace osgLego
{

/** The lines at the edges of parts, in pixels. */
struct BrickLines
{
    float width = 0.0f;
    float oldWidth = 0.0f;      //!< of faded parts
    glm::vec2 pixelWidth{0.0f}; //!< in cells, at the depth z in eye coordinates: |x + y * z|

    /** @param outline BrickAppearance::outline.
     * @param pictureWidth in pixels. */
    BrickLines(double outline, bool isHighlighted, const osg::Matrixd& cellsToEye, const osg::Matrixd& projection,
               double pictureWidth);
};

/** The bricks that a context draws: all, or those of the parts in place. Refers to buffers, grid and blocks of a
 * ContextBricks, whose mutex the caller holds. */
struct DrawnBricks
{
    /** All bricks. */
    DrawnBricks(const ContextBricks& bricks, const BrickLines& brickLines);
    /** The bricks of the parts in place, from the set of the partly built model. */
    DrawnBricks(const ContextBricks& bricks, const BuildingState& state, const BrickLines& brickLines);

    const BrickGrid& grid;
    GLuint buffer = 0; //!< of BrickPoint
    GLuint ranks = 0;  //!< of CellRanks; 0: all bricks are shown
    GLsizei count = 0;
    const std::vector<BrickBlock>& blocks; //!< empty while they are unknown
    // The number of parts in place, and of those that are faded.
    std::uint32_t numPlaced = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t numOld = 0;
    BrickLines lines;
};

} // namespace osgLego
