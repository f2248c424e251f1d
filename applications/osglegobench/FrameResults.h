#pragma once

#include "BenchEnvironment.h"
#include "FrameBench.h"
#include "UnchangedFrames.h"

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** One mesh in bricks, looked at from one place, drawn in two ways. */
struct FrameRow
{
    std::string mesh;
    unsigned int resolution = 0;
    std::string view;
    std::string look;
    FrameComparison comparison;
};

/** All that was measured in one call of the bench. */
struct FrameResults
{
    BenchEnvironment environment;
    glm::ivec2 size{0};
    unsigned int numFrames = 0;
    std::vector<FrameRow> rows;
    std::string unchangedMesh; //!< of the frames below, and its resolution
    std::vector<UnchangedFrames> unchanged;
};

} // namespace osgLego
