#pragma once

#include "MemoryResults.h"

#include <string>

namespace osgLego
{

/** A table for people, in Markdown, and which goals were reached. */
std::string formatTables(const MemoryResults& results);

/** All of it for programs. */
std::string formatJson(const MemoryResults& results);

/** A line for each device and resolution, below lines that begin with #. */
std::string formatCsv(const MemoryResults& results);

} // namespace osgLego
