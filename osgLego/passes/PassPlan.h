#pragma once

#include <osgLego/flattening/LegoSource.h>
#include <osgLego/passes/SlabPlan.h>
#include <osgLego/passes/VoxelFormat.h>

#include <cstddef>
#include <string>

namespace osgLego
{

/** The properties of a source that determine its passes and their render targets. Sources with equal plans share their
 * passes. */
struct PassPlan
{
    /** The largest number of cells for a projected target: single precision represents larger numbers inexactly. */
    static constexpr std::size_t MAXIMUM_PROJECTED_CELLS = std::size_t(1) << 24;

    VoxelizationMethod method = VoxelizationMethod::EXACT;
    VoxelizationTarget target = VoxelizationTarget::ADDRESSED;
    int pictureSize = 0;      //!< the side of a projected target, in pixels; 0 for other targets
    int cellsPerTriangle = 0; //!< the largest number of cells that a fine triangle meets; 0 unless the method is exact
    VoxelFormat format = VoxelFormat::COLOR;
    bool hasPalette = false; //!< whether extraction looks colours up in a palette
    glm::ivec2 imageSize{0}; //!< of the voxel image
    std::size_t numSlabs = 0;

    static PassPlan create(const LegoSource& source);

    /** Whether a pass after voxelization replaces sums of colours by dominant colours. A palette needs it: its nearest
     * colour to a mixture of two colours may be a third one. */
    bool findsDominantColors() const { return hasPalette && format != VoxelFormat::COLOR; }
    /** The format of the voxel image that extraction reads. */
    VoxelFormat getExtractedFormat() const { return hasPalette ? VoxelFormat::COLOR : format; }

    /** The slabs of a grid in this plan. */
    SlabPlan createSlabs(const BrickGrid& grid) const { return SlabPlan::create(grid, getCellBytes()); }

    /** Whether the passes of this plan can legolize a source. */
    bool fits(const LegoSource& source) const { return create(source) == *this; }

    /** The reason why passes can't legolize a source, and the expected settings, in one sentence; empty if they can. */
    static std::string findObstacle(const LegoSource& source);

    bool operator==(const PassPlan&) const = default;

private:
    int getCellBytes() const;
};

} // namespace osgLego
