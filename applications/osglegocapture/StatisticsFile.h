#pragma once

#include "CaptureScene.h"

#include <ostream>

#include <osg/GraphicsContext>

namespace osgLego
{

/** Write the statistics of a capture as JSON: the GL renderer, counts, the grid in model units, times of stages in
 * milliseconds. Makes the context current. */
void writeStatistics(std::ostream& stream, const CaptureScene& scene, osg::GraphicsContext& context);

} // namespace osgLego
