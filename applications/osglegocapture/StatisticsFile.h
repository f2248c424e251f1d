#pragma once

#include "CaptureScene.h"
#include "SceneStability.h"

#include <osgLego/LayoutStatistics.h>

#include <optional>
#include <ostream>

#include <osg/GraphicsContext>

namespace osgLego
{

/** Write the statistics of a capture as JSON: the GL renderer, counts, the grid in model units, times of stages in
 * milliseconds. Makes the context current. @param layout the figures of parts. @param stability may be null. */
void writeStatistics(std::ostream& stream, const CaptureScene& scene, const std::optional<LayoutStatistics>& layout,
                     const SceneStability* stability, osg::GraphicsContext& context);

} // namespace osgLego
