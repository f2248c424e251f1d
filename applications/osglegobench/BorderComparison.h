#pragma once

#include <osgLego/Palette.h>
#include <osgLego/flattening/GridTriangles.h>

#include <common/JsonValue.h>

#include <string>

namespace osgLego
{

/** Compares cells that have one of the colours that meet in them with cells that have the palette's colour nearest to
 * the mean: the numbers of colours, the shares of neighbouring cells with different colours, and milliseconds to find
 * the cells. */
JsonValue compareBorders(const Palette& palette, const GridTriangles& triangles, unsigned int numRuns,
                         const std::string& name);

} // namespace osgLego
