#pragma once

#include <osgLego/stability/ContactFinder.h>

#include <cstdint>
#include <span>

namespace osgLego
{

/** The angle by which a table can be tilted, in any direction, before parts that studs hold together tip over as a
 * whole about an edge of the convex hull of their lowest faces, in degrees, from 0 to 90. Nothing slides, and all
 * joints hold.
 * @param boxes those of all parts of the model.
 * @param parts at least one, as indices into `boxes`, of which `lowest` is the lower face of at least one.
 * @param lowest the height of the table, in plates.
 * @return 0 if the centre of mass is not above the hull. */
double findTippingAngle(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts, int lowest);

} // namespace osgLego
