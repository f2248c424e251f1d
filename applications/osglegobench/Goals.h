#pragma once

#include "VoxelizeResults.h"

#include <string>
#include <vector>

namespace osgLego
{

/** Something that was aimed at, and what came of it. */
struct Goal
{
    std::string text;  //!< what is over what
    std::string where; //!< the mesh and the resolution
    double ratio = 0.0;
    double bound = 0.0;
    bool isAtMost = false; //!< the ratio is to be at most the bound, not at least
    bool isReached = false;

    std::string getBoundText() const;
};

/** The goals for which what was measured has both sides. */
std::vector<Goal> checkGoals(const VoxelizeResults& results);

} // namespace osgLego
