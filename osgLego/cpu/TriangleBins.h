#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Which triangles may reach into each bundle of rows (RowBundle), so that every bundle can be worked on by itself.
 *
 * Triangles are numbered through all batches; those of a bundle come in that order. Immutable once made; may be read
 * from any thread. */
class TriangleBins
{
public:
    explicit TriangleBins(const GridTriangles& triangles);

    /** How many bundles there are along y and z. */
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
