#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Lists the triangles that may reach into each bundle of rows (RowBundle), so that bundles can be processed
 * independently.
 *
 * Triangles are numbered consecutively through all batches; each list is in that order. Immutable once created; may be
 * read from any thread. */
class TriangleBins
{
public:
    explicit TriangleBins(const GridTriangles& triangles);

    /** The number of bundles along y and z. */
    const glm::ivec2& getSize() const { return _size; }
    std::size_t getNumBundles() const { return static_cast<std::size_t>(_size.x) * static_cast<std::size_t>(_size.y); }
    /** @param bundle its number, along y first. */
    std::span<const std::uint32_t> getTriangles(std::size_t bundle) const
    {
        return std::span(_triangles).subspan(_begins[bundle], _begins[bundle + 1] - _begins[bundle]);
    }

private:
    glm::ivec2 _size;
    std::vector<std::size_t> _begins; // of each bundle, and the end
    std::vector<std::uint32_t> _triangles;
};

} // namespace osgLego
