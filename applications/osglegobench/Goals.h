#pragma once

#include <string>
#include <vector>

namespace osgLego
{

struct FrameResults;
struct MemoryResults;
struct VoxelizeResults;

/** Something that was aimed at, and what came of it. */
struct Goal
{
    std::string text;  //!< what was measured; of a ratio, what is over what
    std::string where; //!< the mesh and the resolution
    double figure = 0.0;
    double bound = 0.0;
    bool isAtMost = false; //!< the figure is to be at most the bound, not at least
    bool isReached = false;
    std::string unit{}; //!< of figure and bound; empty: a ratio

    std::string getFigureText() const;
    std::string getBoundText() const;
};

// The goals for which what was measured has both sides.

std::vector<Goal> checkGoals(const VoxelizeResults& results);
std::vector<Goal> checkGoals(const FrameResults& results);
std::vector<Goal> checkGoals(const MemoryResults& results);

} // namespace osgLego
