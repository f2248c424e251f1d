#pragma once

#include <osgLego/cpu/NearestPoint.h>
#include <osgLego/cpu/TriangleSlicer.h>
#include <osgLego/flattening/GridTriangles.h>

#include <array>
#include <span>

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

    /** The colours for the cells of some parts, 0 to 1 a channel. @param colors as many as there are parts. */
    void getColors(std::span<const CellPart> parts, glm::vec3* colors) const;

private:
    glm::vec3 getColor(double shareB, double shareC) const;

    const GridBatch& _batch;
    const GridVertex* _vertices;
    NearestPoint _nearestPoint;
    std::array<glm::vec3, 3> _colors;
    bool _isEven; // the same all over, whatever the point
};

} // namespace osgLego
