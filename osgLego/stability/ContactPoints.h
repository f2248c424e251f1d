#pragma once

#include <vector>

#include <Eigen/Core>
#include <glm/vec3.hpp>

namespace osgLego
{

/** A corner of a PartBox in pitches. */
Eigen::Vector3d toPitches(const glm::ivec3& corner);

/** The points at which a part touches the studs below it, in pitches: four at each stud if the part is one stud wide,
 * and three otherwise, as walls and tubes of real parts do. They turn with the part, so that a model that is turned or
 * mirrored has the same forces.
 * @param halfSize half the size of the rectangle of studs, about the origin.
 * @param center that of the upper part.
 * @param size that of the upper part, in studs. */
std::vector<Eigen::Vector2d> findStudPoints(const Eigen::Vector2d& halfSize, const Eigen::Vector2d& center,
                                            const Eigen::Vector2i& size);

/** The corners of the convex hull of points, counter-clockwise. */
std::vector<Eigen::Vector2d> findHull(std::vector<Eigen::Vector2d> points);

} // namespace osgLego
