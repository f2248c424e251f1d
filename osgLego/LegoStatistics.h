#pragma once

#include <osgLego/LayoutStatistics.h>

#include <cstddef>
#include <optional>

namespace osgLego
{

/** Statistics of one legolization: counts, and times in milliseconds.
 *
 * Times of stages on the GPU are meaningful only with LegoNode::setTiming(), which waits for each stage to finish.
 */
struct LegoStatistics
{
    bool isFromCpu = false;               //!< the bricks were made on the CPU, without subdivision
    bool isStored = false;                //!< the bricks were not made, but given to LegoNode::setStoredBricks()
    unsigned int numLegolizations = 0;    //!< in this context so far
    std::size_t numTriangles = 0;         //!< of the source, except those beside the grid
    std::size_t numSubdivisionPasses = 0; //!< the largest number that any batch of triangles took
    std::size_t numFineTriangles = 0;
    std::size_t numDrawnBricks = 0; //!< covered cells with an open side
    double flattening = 0.0;        //!< converting the source to triangles in the grid, on the CPU
    double subdivision = 0.0;       //!< including the upload
    double voxelization = 0.0;
    double extraction = 0.0; //!< for bricks that were not made on the GPU: the upload
    /** Of the parts that were made of the cells; unset without parts, and for stored bricks. */
    std::optional<LayoutStatistics> layout;
};

} // namespace osgLego
