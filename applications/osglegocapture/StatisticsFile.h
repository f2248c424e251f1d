#pragma once

#include "CaptureScene.h"

#include <string>

#include <osg/GraphicsContext>

namespace osgLego
{

/** Write what a capture went through as JSON: the GL renderer, counts, the grid in model units, milliseconds by stage.
 * Makes the context current; throws CaptureError. */
void writeStatistics(const std::string& fileName, const CaptureScene& scene, osg::GraphicsContext& context);

} // namespace osgLego
