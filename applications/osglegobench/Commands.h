#pragma once

#include <CLI/CLI.hpp>

namespace osgLego
{

// Each of these adds a subcommand, which runs as its callback and throws std::runtime_error where it can't go on.

void addOcclusionCommand(CLI::App& app);
void addVoxelizeCommand(CLI::App& app);
void addFrameCommand(CLI::App& app);
void addMemoryCommand(CLI::App& app);
void addPlotsCommand(CLI::App& app);
/** What measures memory calls in a process of its own; not for users. */
void addFootprintCommand(CLI::App& app);

} // namespace osgLego
