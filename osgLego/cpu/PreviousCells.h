#pragma once

#include <osgLego/BrickModel.h>

#include <optional>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

/** The cells of a source before it moved, in the colours of its surface.
 *
 * Immutable; may be called from any thread.
 */
class PreviousCells
{
public:
    /** @param step the place of the first cell of the present grid in the grid of `cells`. */
    explicit PreviousCells(const BrickModel& cells, const glm::ivec3& step = glm::ivec3(0)) :
        _cells(&cells), _step(step)
    {
    }

    /** The colour, 0 to 1 per channel, that a cell of the present grid had before; none if it was empty. */
    std::optional<glm::vec3> findColor(const glm::ivec3& cell) const
    {
        const Brick* brick = _cells->find(cell + _step);
        if (!brick) return std::nullopt;
        return glm::vec3(brick->color[0], brick->color[1], brick->color[2]) / 255.0f;
    }

private:
    osg::ref_ptr<const BrickModel> _cells;
    glm::ivec3 _step;
};

} // namespace osgLego
