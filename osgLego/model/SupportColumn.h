#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A square column of parts below a model. */
struct SupportColumn
{
    glm::ivec3 place{0}; //!< its lowest cell
    int width = 1;       //!< of its square, in cells
    int height = 0;      //!< in cells
    std::uint16_t color = 0;

    bool contains(const glm::ivec3& cell) const
    {
        const glm::ivec3 offset = cell - place;
        return offset.x >= 0 && offset.y >= 0 && offset.z >= 0 && offset.x < width && offset.y < width &&
               offset.z < height;
    }

    /** Whether it stands on another column. */
    bool standsOn(const SupportColumn& other) const
    {
        return place.z == other.place.z + other.height && place.x < other.place.x + other.width &&
               other.place.x < place.x + width && place.y < other.place.y + other.width &&
               other.place.y < place.y + width;
    }

    bool operator==(const SupportColumn&) const = default;
};

} // namespace osgLego
