#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A change of cells that lets parts join two pieces of a layout. */
struct Join
{
    /** A cell and the colour that it gets; LayoutCell::ANY_COLOR if any will do. */
    struct Change
    {
        glm::ivec3 cell{0};
        std::uint16_t color = 0;
    };

    std::vector<Change> added;     //!< empty cells that become covered
    std::vector<Change> recolored; //!< covered cells
    glm::ivec3 begin{0};           //!< the covered cell where the join begins
    glm::ivec3 end{0};             //!< likewise where it ends
    double cost = 0.0;
};

} // namespace osgLego
