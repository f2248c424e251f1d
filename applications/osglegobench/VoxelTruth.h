#pragma once

#include "CellSet.h"

#include <osgLego/BrickModel.h>
#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>
#include <optional>

#include <osg/ref_ptr>

namespace osgLego
{

/** A contender's bricks, compared with the true ones. */
struct VoxelQuality
{
    std::size_t numCells = 0; //!< number of cells found
    double precision = 0.0;   //!< the fraction of the cells found that a triangle overlaps
    double recall = 0.0;      //!< the fraction of the cells that a triangle overlaps that were found
    /** The number of segments between the centres of two empty face-neighbours that are crossed by a triangle: holes in
     * the surface. Cells outside the grid are empty. A segment includes its lower end but not its upper end, so that no
     * surface is counted twice along an axis; a triangle parallel to a segment does not cross it. */
    std::size_t numTunnels = 0;
    /** Mean difference of colour channels in cells that both have, in levels of 255; for contenders with colours. */
    std::optional<double> colorError;
};

/** The reference for contenders: the cells of a grid that triangles overlap, from TriangleOverlap in double precision,
 * with the colours of legolizeOnCpu. */
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
