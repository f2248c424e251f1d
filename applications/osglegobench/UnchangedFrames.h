#pragma once

#include "OcclusionBench.h"

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** What happens in frames in which nothing has changed since the one before. Numbers are those of all frames. */
struct UnchangedFrames
{
    std::string name; //!< what draws: "splats", "triangles", the scene around them, or a box of OpenSceneGraph's own
    std::string look; //!< "plain", "full", or "none" where there are no bricks
    bool hasGoal = false; //!< bricks alone
    std::size_t numFrames = 0;
    std::size_t numPasses = 0;         //!< legolizations
    std::size_t numWaits = 0;          //!< for what the renderer has to say, as GlWatch counts them
    std::size_t numAllocations = 0;    //!< by operator new, in all threads
    std::size_t numOwnAllocations = 0; //!< of these, in the thread that draws
};

/** Count in frames of a scene without bricks, the first, and of one and the same mesh in bricks by every way of drawing
 * them that there is with this renderer; the last, for comparison, in frames in which they are made anew.
 *
 * Needs GL by EGL; throws std::runtime_error when there is none or a mesh can't be read. One thread. */
std::vector<UnchangedFrames> countInUnchangedFrames(const BenchScene& scene, const glm::ivec2& size);

} // namespace osgLego
