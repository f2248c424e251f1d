#pragma once

#include <osgLego/data/SparseBox.h>
#include <osgLego/layout/LayoutProblem.h>

#include <glm/vec3.hpp>

namespace osgLego
{

/** How much of an empty cell would be seen from outside if it were covered.
 *
 * Immutable; may be called from any thread. */
class CellExposure
{
public:
    explicit CellExposure(const LayoutProblem& problem);

    /** @param cell within the grid of the layout.
     * @return 0 to 1: the share of 26 directions in which no cell hides it, those downwards counted a quarter. */
    double get(const glm::ivec3& cell) const;

private:
    bool isInside(const glm::ivec3& cell) const;

    glm::ivec3 _size;
    SparseBox<bool> _isCovered;
};

} // namespace osgLego
