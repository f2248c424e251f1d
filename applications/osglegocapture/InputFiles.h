#pragma once

#include <string>
#include <vector>

namespace osgLego
{

/** The files that this process has read: models with their materials and textures, palettes, probes. */
namespace InputFiles
{

/** Start to record those that OSG reads. Call this before anything is read. */
void record();

/** Add a file that is read in another way, such as a palette. Names of no files are ignored. */
void add(const std::string& fileName);

/** A sentence on the material libraries and pictures that a model has named, but OSG has not found; empty if there are
 * none. May be called from any thread. */
std::string describeMissing(const std::string& model);

/** Throws CaptureError if one of the outputs would take the place of a file that has been read. Empty names are
 * ignored. May be called from any thread. */
void checkAreKept(const std::vector<std::string>& outputs);

} // namespace InputFiles

} // namespace osgLego
