#pragma once

#include <osgLego/Palette.h>
#include <osgLego/flattening/GridTriangles.h>

#include <common/JsonValue.h>

#include <string>

namespace osgLego
{

/** Milliseconds that the tables of a palette take, on all cores. */
JsonValue measureTables(const Palette& palette, unsigned int numRuns, const std::string& name);

/** The same for a palette of the most colours, which are spread over sRGB at random. */
JsonValue measureLargestTables(unsigned int numRuns);

/** Milliseconds to choose eight colours of a palette for a mesh, in one thread: its histogram, and the choice. */
JsonValue measureChoice(const Palette& palette, const GridTriangles& triangles, unsigned int numRuns,
                        const std::string& name);

} // namespace osgLego
