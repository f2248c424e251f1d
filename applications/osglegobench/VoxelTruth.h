#pragma once

#include "CellSet.h"

#include <osgLego/BrickModel.h>
#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>
#include <optional>

#include <osg/ref_ptr>

namespace osgLego
{

/** How close the bricks of a contender are to the truth. */
struct VoxelQuality
{
    std::size_t numCells = 0; //!< that it found
    double precision = 0.0;   //!< the share of them that a triangle overlaps
    double recall = 0.0;      //!< the share of cells that a triangle overlaps which it found
    /** Segments between the centres of two empty face-neighbours that a triangle crosses: holes in the surface. Cells
     * outside the grid are empty. A segment contains its lower end and not its upper, so that no surface is counted
     * twice along an axis; a triangle that lies along a segment does not cross it. */
    std::size_t numTunnels = 0;
    /** The mean difference of a channel in cells that both have, in levels of 255; of contenders with colours. */
    std::optional<double> colorError;
};

/** The cells of a grid that triangles overlap, by TriangleOverlap in double precision, to compare contenders with; the
 * colours to compare with are those of legolizeOnCpu. */
class VoxelTruth
{
public:
    explicit VoxelTruth(const GridTriangles& triangles);

    std::size_t getNumCells() const { return _cells.getSize(); }
    VoxelQuality compare(const BrickModel& found, bool hasColors) const;

private:
    double computeColorError(const BrickModel& found) const;
    std::size_t countTunnels(const CellSet& covered) const;

    osg::ref_ptr<const GridTriangles> _triangles;
    osg::ref_ptr<const BrickModel> _reference;
    CellSet _cells;
};

} // namespace osgLego
