#pragma once

#include <osgLego/GridTriangles.h>

#include <array>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The colour that a triangle gives to the cells that it covers: that of its point nearest to the middle of the cell.
 *
 * Preconditions:
 * 1. The batch outlives this.
 *
 * Immutable, free of GL; every function may be called from any thread.
 */
class TriangleColor
{
public:
    /** @param corners the first of three vertices of the batch. */
    TriangleColor(const GridBatch& batch, const GridVertex* corners);

    /** For a cell with that middle, in cell units; 0 to 1 a channel. */
    glm::vec3 getColor(const glm::dvec3& middle) const { return _isEven ? _colors[0] : findColor(middle); }

private:
    glm::vec3 findColor(const glm::dvec3& middle) const;

    const GridBatch& _batch;
    const GridVertex* _vertices;
    std::array<glm::dvec3, 3> _corners;
    std::array<glm::vec3, 3> _colors;
    bool _isEven; // the same all over, whatever the point
};

} // namespace osgLego
