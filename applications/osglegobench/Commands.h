#pragma once

#include <CLI/CLI.hpp>

namespace osgLego
{

// Each function adds a subcommand. The subcommand runs as a callback, writes one JSON document, and throws
// std::runtime_error if it fails.

/** Time, exactness and colours of contenders, on meshes at several resolutions. */
void addVoxelizeCommand(CLI::App& app);
/** Time and picture of a frame, compared with the reference that draws every face and every stud. */
void addFrameCommand(CLI::App& app);
/** Memory, times and counts of frames of one scene. */
void addDrawCommand(CLI::App& app);
/** Error of ambient occlusion against rays, and the time of its passes. */
void addOcclusionCommand(CLI::App& app);
/** Colours that a palette gives to meshes, beside the best. Prints a table unless JSON goes to a file. */
void addColorsCommand(CLI::App& app);
/** Layouts of parts beside the least number of parts that is possible. Prints tables unless JSON goes to a file. */
void addLayoutCommand(CLI::App& app);
/** Times of computing stability, beside CLP. Prints a table unless JSON goes to a file. */
void addStabilityCommand(CLI::App& app);
/** Building orders beside the order layer by layer. Prints a table unless JSON goes to a file. */
void addBuildingCommand(CLI::App& app);

} // namespace osgLego
