#pragma once

#include <osgLego/BrickModel.h>

#include <array>
#include <cstdint>
#include <functional>

#include <osg/ref_ptr>

namespace osgLego
{

/** The colour (red, green, blue) for a load on joints, as a share of their capacity: blue for none, green for a third,
 * yellow for two thirds, red for all of it or more, and grey if it is not a number. */
std::array<std::uint8_t, 3> findLoadColor(float load);

/** A model on a table with its parts in the colours for the load on their joints (StabilityReport::loads), magenta for
 * parts that fall, and grey for those of which that is unknown.
 * @param isCancelled may be empty.
 * @return `model` itself if it has no parts; null if it was cancelled. */
osg::ref_ptr<const BrickModel> colorByLoad(const BrickModel& model, const std::function<bool()>& isCancelled = {});

} // namespace osgLego
