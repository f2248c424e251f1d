#pragma once

#include "FrameResults.h"

#include <string>

namespace osgLego
{

/** Tables for people, in Markdown: what was measured, and which goals were reached. */
std::string formatTables(const FrameResults& results);

/** All of it for programs. */
std::string formatJson(const FrameResults& results);

/** A line for each way of drawing of each row, and for each way of drawing frames in which nothing changed, below lines
 * that begin with #. */
std::string formatCsv(const FrameResults& results);

} // namespace osgLego
