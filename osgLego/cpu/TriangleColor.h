#pragma once

#include <osgLego/cpu/NearestPoint.h>
#include <osgLego/cpu/TriangleSlicer.h>
#include <osgLego/flattening/GridTriangles.h>

#include <array>
#include <span>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The colour that a triangle contributes to each cell that it covers: the colour of its point nearest to the centre of
 * the cell.
 *
 * Preconditions:
 * 1. The batch and its vertices outlive this object.
 *
 * Immutable; uses no GL. Every function may be called from any thread.
 */
class TriangleColor
{
public:
    /** @param corners the first of three vertices of the batch. */
    TriangleColor(const GridBatch& batch, const GridVertex* corners);

    /** Compute the colours for the cells of some parts, 0 to 1 per channel. @param colors has an element per part. */
    void getColors(std::span<const CellPart> parts, glm::vec3* colors) const;

    /** Whether a texture may mix several colours in a cell. */
    bool hasMixtures() const { return _batch.texture.valid(); }
    /** Replace the colours of getColors(), for which the texture was filtered, by those of single texels: of five in
     * each cell, the nearest one to the filtered colour. Texels that are mixtures of their neighbours count as farther
     * away. */
    void makePlain(std::span<const CellPart> parts, glm::vec3* colors) const;

private:
    class PlainTexels;

    template <typename GetColor>
    void forEachPoint(std::span<const CellPart> parts, const GetColor& getColor) const;
    glm::vec3 getVertexColor(const glm::dvec3& shares) const;
    glm::vec3 getPlainColor(const PlainTexels& texels, const glm::dvec3& shares, const glm::vec3& filtered) const;

    const GridBatch& _batch;
    const GridVertex* _vertices;
    NearestPoint _nearestPoint;
    std::array<glm::vec3, 3> _colors;
    bool _isEven; // the same colour at every point
};

} // namespace osgLego
