#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Combine the colour at a point of a triangle with the batch's texture, filtered to the size of a cell; the colour
 * itself if there is no texture. May be called from any thread.
 * @param corners the first of three vertices of the batch. @param shares the barycentric coordinates of the point. */
glm::vec3 applyTexture(const GridBatch& batch, const GridVertex* corners, const glm::dvec3& shares,
                       const glm::vec3& color);

} // namespace osgLego
