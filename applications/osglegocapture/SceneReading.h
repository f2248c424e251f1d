#pragma once

#include "CaptureOptions.h"
#include "CaptureScene.h"
#include "ProgressBar.h"

#include <memory>

namespace osgLego
{

/** Read a scene, and record the files that it consists of in InputFiles. Prints a warning if the mesh is large, or
 * names files that were not found. Call it before anything is written: a signal ends the program at once. Throws
 * CaptureError. */
std::unique_ptr<CaptureScene> readScene(const CaptureOptions& options, const ProgressBar& progress);

} // namespace osgLego
