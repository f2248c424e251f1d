#pragma once

#include "BenchMeshes.h"
#include "Contenders.h"
#include "VoxelizeResults.h"

#include <string>
#include <vector>

#include <osg/GraphicsContext>

namespace osgLego
{

/** How often everybody runs. */
struct BenchRuns
{
    unsigned int numRuns = 7;
    unsigned int numWarmUps = 2; //!< before, and not counted
};

/** Measure contenders on one mesh, in turns: all of them once, then all of them once more, so that whatever else the
 * machine does meets all alike. One thread; the context is made current.
 *
 * What a contender can't do ends up in its result, and the others go on without it.
 * @param withQuality compare with the truth as well, which takes a while on the processor. */
MeshResult measureContenders(const BenchMesh& mesh, const ContenderList& contenders, const BenchRuns& runs,
                             osg::GraphicsContext& context, bool withQuality);

/** What to measure by measureVoxelization(). */
struct VoxelizeOptions
{
    std::vector<MeshSource> meshes;
    std::vector<unsigned int> resolutions;
    BenchRuns runs;
    std::vector<std::string> contenders; //!< by name; empty: all
};

/** Measure all contenders on all meshes at all resolutions. Throws std::runtime_error. */
VoxelizeResults measureVoxelization(const VoxelizeOptions& options);

/** A context to measure in. Throws std::runtime_error when there is none. */
osg::ref_ptr<osg::GraphicsContext> createBenchContext();

} // namespace osgLego
