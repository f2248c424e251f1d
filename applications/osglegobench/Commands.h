#pragma once

#include "BenchCommand.h"

namespace osgLego
{

// Each function adds a subcommand. The subcommand runs as a callback, writes one JSON document, and throws
// std::runtime_error if it fails.

/** Time, exactness and colours of contenders, on meshes at several resolutions. */
void addVoxelizeCommand(BenchCommandLine& commands);
/** Time and picture of a frame, compared with the reference that draws every face and every stud. */
void addFrameCommand(BenchCommandLine& commands);
/** Memory, times and counts of frames of one scene. */
void addDrawCommand(BenchCommandLine& commands);
/** Error of ambient occlusion against rays, and the time of its passes. */
void addOcclusionCommand(BenchCommandLine& commands);
/** Colours that a palette gives to meshes, beside the best. Prints a table unless JSON goes to a file. */
void addColorsCommand(BenchCommandLine& commands);
/** Layouts of parts beside the least number of parts that is possible. Prints tables unless JSON goes to a file. */
void addLayoutCommand(BenchCommandLine& commands);
/** Times of computing stability, beside CLP. Prints a table unless JSON goes to a file. */
void addStabilityCommand(BenchCommandLine& commands);
/** Building orders beside the order layer by layer. Prints a table unless JSON goes to a file. */
void addBuildingCommand(BenchCommandLine& commands);
/** Pieces of layouts before and after they are joined. Prints a table unless JSON goes to a file. */
void addConnectCommand(BenchCommandLine& commands);
/** Times to cancel legolizations, and on one and two threads. Prints a table unless JSON goes to a file. */
void addLiveCommand(BenchCommandLine& commands);
/** Memory of many small nodes, each. Prints a table unless JSON goes to a file. */
void addNodesCommand(BenchCommandLine& commands);
/** Memory over hours of random changes. Prints the growth unless JSON goes to a file. */
void addSoakCommand(BenchCommandLine& commands);

} // namespace osgLego
