#pragma once

#include "ProgressBar.h"

#include <osgLego/LegoNode.h>

namespace osgLego
{

/** Make the bricks of a node on the CPU, unless they exist, and show the progress. Throws CaptureError if it is
 * cancelled. */
void makeBricks(LegoNode& lego, const ProgressBar& progress);

} // namespace osgLego
