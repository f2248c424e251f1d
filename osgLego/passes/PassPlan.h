#pragma once

#include <osgLego/flattening/LegoSource.h>
#include <osgLego/passes/SlabPlan.h>

#include <cstddef>
#include <string>

namespace osgLego
{

/** What decides which passes there are and what they draw into; sources with equal plans share their passes. */
struct PassPlan
{
    /** Cells of a grid that a projected target can number: whole numbers that a float holds. */
    static constexpr std::size_t MAXIMUM_PROJECTED_CELLS = std::size_t(1) << 24;

    VoxelizationMethod method = VoxelizationMethod::EXACT;
    VoxelizationTarget target = VoxelizationTarget::ADDRESSED;
    int pictureSize = 0;      //!< the side of a projected target, in pixels; else 0
    int cellsPerTriangle = 0; //!< how many cells a fine triangle may meet, for the exact method; else 0
    glm::ivec2 imageSize{0};  //!< of the voxel image
    std::size_t numSlabs = 0;

    static PassPlan create(const LegoSource& source);

    /** Whether the passes of this plan can legolize a source. */
    bool fits(const LegoSource& source) const { return create(source) == *this; }

    /** Why no passes can legolize a source, and what is allowed, in one sentence; empty when they can. */
    static std::string findObstacle(const LegoSource& source);

    bool operator==(const PassPlan&) const = default;
};

} // namespace osgLego
