#pragma once

#include "LDrawLattice.h"

#include <common/BasePlate.h>
#include <osgLego/BrickModel.h>

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

namespace osgLego
{

/** The coordinates of a model in LDraw: those with the origin at the centre of the lowest layer, y downwards. */
class LDrawFrame
{
public:
    /** @param model has at least one part. */
    explicit LDrawFrame(const BrickModel& model);

    /** The cells of a part, counted from the lowest that any part covers: x and y horizontal, z upwards, in studs and
     * plates. */
    LatticeBox toBox(const Part& part) const;
    /** A part of the model in its place. */
    LDrawTransform getTransform(const Part& part) const;
    /** The plates below the model, each in its place. */
    std::vector<LDrawTransform> getTransforms(const BasePlate& plates) const;
    /** The centre of the lowest layer of some parts. @param parts at least one index into BrickModel::getParts(). */
    glm::dvec3 getBottomCenter(std::span<const std::uint32_t> parts) const;
    /** From these coordinates, in LDU, to those of the model's grid. */
    glm::dmat4 getModelTransform() const;

private:
    LatticeBox toGridBox(const Part& part) const;

    glm::dvec3 toPlace(const glm::dvec3& cell) const;

    const BrickModel& _model;
    const BrickGrid& _grid;
    int _plates; // the height of a cell
    glm::ivec3 _lowest;
    glm::ivec3 _end;
};

} // namespace osgLego
