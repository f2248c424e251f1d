#pragma once

#include "CaptureScene.h"
#include "ScenePicture.h"
#include "SceneStability.h"

#include <osgLego/LayoutStatistics.h>

#include <optional>
#include <ostream>

#include <osg/GraphicsContext>

namespace osgLego
{

/** The results of a capture. */
struct CaptureStatistics
{
    const CaptureScene& scene;
    const ScenePicture& picture;
    const std::optional<LayoutStatistics>& layout; //!< the figures of parts
    const SceneStability* stability = nullptr;     //!< null if it is not computed
};

/** Write the statistics of a capture as JSON: the GL renderer, counts, the grid in model units, times of stages in
 * milliseconds. Makes the context current, in which the picture was drawn. */
void writeStatistics(std::ostream& stream, const CaptureStatistics& capture, osg::GraphicsContext& context);

} // namespace osgLego
