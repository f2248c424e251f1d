#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** Combine a colour with the batch's texture, which it must have, at a texture coordinate and mipmap level. May be
 * called from any thread. */
glm::vec3 applyTexture(const GridBatch& batch, const glm::dvec2& coordinate, double level, const glm::vec3& color);

/** Likewise, with the texel that contains the texture coordinate. */
glm::vec3 applyTexel(const GridBatch& batch, const glm::dvec2& coordinate, int level, const glm::vec3& color);

/** The texture coordinate of a point of a triangle. @param shares its barycentric coordinates. */
glm::dvec2 coordinateAt(const GridVertex* corners, const glm::dvec3& shares);

/** Combine the colour at a point of a triangle with the batch's texture, filtered to the size of a cell; the colour
 * itself if there is no texture. May be called from any thread.
 * @param corners the first of three vertices of the batch. @param shares the barycentric coordinates of the point. */
glm::vec3 applyTexture(const GridBatch& batch, const GridVertex* corners, const glm::dvec3& shares,
                       const glm::vec3& color);

} // namespace osgLego
