#pragma once

#include "BenchEnvironment.h"
#include "Spread.h"
#include "VoxelTruth.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** What one contender did with one mesh in one grid. */
struct ContenderResult
{
    std::string contender;
    bool hasColors = false;
    std::string failure;                                //!< why there is no more than this; empty when there is
    Spread time;                                        //!< milliseconds
    std::vector<std::pair<std::string, double>> stages; //!< medians, milliseconds
    VoxelQuality quality;
};

/** What all contenders did with one mesh in one grid. */
struct MeshResult
{
    std::string mesh;
    std::size_t numTriangles = 0;
    unsigned int resolution = 0;
    glm::ivec3 dimensions{0};
    std::size_t numCells = 0; //!< that triangles overlap; 0 when nobody looked
    std::vector<ContenderResult> contenders;

    /** The result of a contender; null when it has none or failed. */
    const ContenderResult* find(const std::string& contender) const;
};

/** All that was measured in one call of the bench. */
struct VoxelizeResults
{
    BenchEnvironment environment;
    unsigned int numRuns = 0;
    unsigned int numWarmUps = 0;
    std::vector<MeshResult> meshes;

    const MeshResult* find(const std::string& mesh, unsigned int resolution) const;
};

} // namespace osgLego
