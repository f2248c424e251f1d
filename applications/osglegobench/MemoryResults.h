#pragma once

#include "BenchEnvironment.h"
#include "SceneFootprint.h"

#include <optional>
#include <string>
#include <vector>

namespace osgLego
{

/** The memory of one mesh at one resolution, its bricks found by one device. */
struct MemoryRow
{
    std::string device;
    unsigned int resolution = 0;
    std::optional<SceneFootprint> footprint; //!< nothing: no frame could be drawn
};

/** All that was measured in one call of the bench. */
struct MemoryResults
{
    BenchEnvironment environment;
    std::string mesh;
    std::vector<MemoryRow> rows; //!< resolutions of a device from the lowest to the highest
};

} // namespace osgLego
