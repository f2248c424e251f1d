#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** The transform of a line of type 1: from the coordinates of a part to those of the file that refers to it, in LDU.
 * LDraw's axes: x to the right, y downwards, z away from the viewer. */
struct LDrawTransform
{
    glm::dmat3 axes{1.0};
    glm::dvec3 place{0.0};

    glm::dvec3 operator*(const glm::dvec3& point) const { return axes * point + place; }
    LDrawTransform operator*(const LDrawTransform& inner) const
    {
        return {axes * inner.axes, axes * inner.place + place};
    }
    LDrawTransform getInverse() const
    {
        const glm::dmat3 inverse = glm::inverse(axes);
        return {inverse, -(inverse * place)};
    }
};

} // namespace osgLego
