#pragma once

#include <osgLego/BrickModel.h>

#include <functional>

#include <osg/ref_ptr>

namespace osgLego
{

/** A model on a table with its parts in colours for the load on their joints (StabilityReport::loads): blue for none,
 * green, yellow, and red for the whole capacity; magenta for parts that fall.
 * @param isCancelled may be empty.
 * @return `model` itself if it has no parts; null if it was cancelled. */
osg::ref_ptr<const BrickModel> colorByLoad(const BrickModel& model, const std::function<bool()>& isCancelled = {});

} // namespace osgLego
