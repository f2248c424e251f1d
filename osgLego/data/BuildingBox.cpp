#include <osgLego/data/BuildingBox.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace osgLego
{

std::vector<BuildingBox> createBuildingBoxes(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    std::vector<BuildingBox> boxes;
    boxes.reserve(model.getParts().size());
    for (const Part& part : model.getParts())
    {
        const glm::ivec3 lower = part.getCell();
        const glm::ivec3 upper = lower + part.getSize();
        if (grid.upAxis == UpAxis::Z)
            boxes.push_back({lower, upper});
        else // z points to the front
            boxes.push_back(
                {{lower.x, grid.dimensions.z - upper.z, lower.y}, {upper.x, grid.dimensions.z - lower.z, upper.y}});
    }
    return boxes;
}

std::vector<BuildingBox> turnUpsideDown(std::vector<BuildingBox> boxes)
{
    int top = 0;
    for (const BuildingBox& box : boxes)
        top = std::max(top, box.upper.z);
    for (BuildingBox& box : boxes)
        std::tie(box.lower.z, box.upper.z) = std::pair(top - box.upper.z, top - box.lower.z);
    return boxes;
}

} // namespace osgLego
