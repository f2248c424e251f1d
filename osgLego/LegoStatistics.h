#pragma once

#include <cstddef>

namespace osgLego
{

/** What a legolization went through: counts, and times in milliseconds.
 *
 * Times of stages are 0 unless LegoNode::setTiming is on, since a stage can only be timed by waiting for it.
 */
struct LegoStatistics
{
    bool isFromCpu = false;            //!< the bricks were found on the CPU; then there is no subdivision
    unsigned int numLegolizations = 0; //!< how often the passes ran in the context
    std::size_t numTriangles = 0;
    std::size_t numSubdivisionPasses = 0; //!< the most that any batch of triangles took
    std::size_t numFineTriangles = 0;
    std::size_t numDrawnBricks = 0; //!< covered cells with an open side
    double flattening = 0.0;        //!< the source to triangles in the grid, on the CPU
    double subdivision = 0.0;       //!< the upload included
    double voxelization = 0.0;
    double extraction = 0.0; //!< on the CPU: the upload
};

} // namespace osgLego
