#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** An index for each cell of one layer, of a part or of a cell. A border of empty cells surrounds the layer. */
class IndexLayer
{
public:
    static constexpr std::uint32_t NONE = 0xffffffff;

    /** Create an empty layer of a layout of the given size. */
    explicit IndexLayer(const glm::ivec3& size);

    void clear();
    /** Set the index of a rectangle of cells, which is within the layout. */
    void fill(const glm::ivec2& place, const glm::ivec2& size, std::uint32_t index);
    /** @param x, y -1 to the size of the layout. */
    std::uint32_t get(int x, int y) const { return _indices[getOffset(x, y)]; }

private:
    std::size_t getOffset(int x, int y) const
    {
        return static_cast<std::size_t>(y + 1) * _stride + static_cast<std::size_t>(x + 1);
    }

    std::size_t _stride;
    std::vector<std::uint32_t> _indices;
};

} // namespace osgLego
