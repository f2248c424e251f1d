#pragma once

#include "VoxelizeResults.h"

#include <string>

namespace osgLego
{

/** Tables for people, in Markdown: what was measured, and which goals were reached. */
std::string formatTables(const VoxelizeResults& results);

/** All of it for programs. */
std::string formatJson(const VoxelizeResults& results);

/** A line for each contender, mesh and resolution, below lines that begin with # and tell where it was measured. */
std::string formatCsv(const VoxelizeResults& results);

} // namespace osgLego
