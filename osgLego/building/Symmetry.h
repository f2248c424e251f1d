#pragma once

#include <osgLego/stability/JointGraph.h>

#include <vector>

namespace osgLego
{

/** The vertical plane in the middle of a model in which it mirrors itself, and the parts that mirror each other.
 *
 * Immutable once created; every function may be called from any thread. */
class Symmetry
{
public:
    static constexpr std::uint32_t NONE = 0xffffffff;

    /** Find the plane, across x or y, that mirrors most cells; there is none if these are less than nine tenths. */
    explicit Symmetry(const std::vector<BuildingBox>& boxes);

    bool hasPlane() const { return _axis >= 0; }
    BuildingBox mirror(BuildingBox box) const;
    /** The part in the mirrored place; NONE if there is none, also for a part that mirrors itself. */
    std::uint32_t getTwin(std::uint32_t part) const { return _twins[part]; }
    /** A place, in half cells, mirrored to one side of the plane. */
    glm::ivec3 fold(glm::ivec3 place) const;

private:
    void findPlane(const std::vector<BuildingBox>& boxes);
    void findTwins(const std::vector<BuildingBox>& boxes);

    int _axis = -1; // the normal of the plane; none if negative
    int _sum = 0;   // twice the coordinate of the plane
    std::vector<std::uint32_t> _twins;
};

} // namespace osgLego
