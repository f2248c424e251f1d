#pragma once

#include "LDrawResolver.h"

#include <optional>
#include <span>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The cells of a part: x to the right and y away from the viewer, in studs; z upwards, in plates. */
struct LatticeBox
{
    glm::ivec3 place{0};
    glm::ivec3 size{1};
};

/** The lattice of studs and plates on which the parts of a model stand. */
class LDrawLattice
{
public:
    static constexpr double STUD = 20.0; //!< LDU
    static constexpr double PLATE = 8.0; //!< LDU

    /** The lattice of most of the parts; of the first ones, if lattices are equally frequent. */
    static LDrawLattice find(std::span<const LDrawPart> parts);

    /** The cells of a part; nothing if it is inclined, upside down, scaled or between the cells. */
    std::optional<LatticeBox> toBox(const LDrawPart& part) const;

    /** The corner of cell (0, 0, 0) along the axes of the cells, in LDU. */
    const glm::dvec3& getOrigin() const { return _origin; }

private:
    glm::dvec3 _origin{0.0};
};

/** The extent of a cell along x, y and z, in LDU. */
inline constexpr std::array<double, 3> LATTICE_CELL{LDrawLattice::STUD, LDrawLattice::STUD, LDrawLattice::PLATE};

} // namespace osgLego
