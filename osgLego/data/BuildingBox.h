#pragma once

#include <osgLego/BrickModel.h>

#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The cells of a part in the coordinates of building: x to the right, y away from the front, z upwards. */
struct BuildingBox
{
    glm::ivec3 lower{0};
    glm::ivec3 upper{0}; //!< behind the last cell

    bool operator==(const BuildingBox&) const = default;
};

/** The boxes of all parts. Models with y upwards are turned, so that their front, too, is the lowest y. */
std::vector<BuildingBox> createBuildingBoxes(const BrickModel& model);

/** The same boxes upside down. */
std::vector<BuildingBox> turnUpsideDown(std::vector<BuildingBox> boxes);

} // namespace osgLego
