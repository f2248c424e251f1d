#pragma once

#include "BenchMeshes.h"
#include "Plot.h"
#include "VoxelizeBench.h"

#include <string>
#include <vector>

#include <osg/GraphicsContext>

namespace osgLego
{

/** The paper's Figure 6(a): the time of its method over the size of the frame buffer object. */
Plot measureFboSizes(const std::vector<MeshSource>& meshes, unsigned int resolution,
                     const std::vector<unsigned int>& sizes, const BenchRuns& runs, osg::GraphicsContext& context);

/** The paper's Figure 6(b): frames a second over the resolution, of pictures with everything on; legolized before, and
 * legolized anew in every frame. */
Plot measureFrameRates(const std::vector<MeshSource>& meshes, const std::vector<unsigned int>& resolutions,
                       const BenchRuns& runs);

/** The time of contenders over the resolution. */
Plot measureTimes(const MeshSource& source, const std::vector<unsigned int>& resolutions,
                  const std::vector<std::string>& contenders, const BenchRuns& runs, osg::GraphicsContext& context);

/** The memory of contenders over the resolution, each in a process of its own. */
Plot measureFootprints(const MeshSource& source, const std::vector<unsigned int>& resolutions,
                       const std::vector<std::string>& contenders);

} // namespace osgLego
