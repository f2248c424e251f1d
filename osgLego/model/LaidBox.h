#pragma once

#include <osgLego/data/BuildingBox.h>
#include <osgLego/layout/LayoutProblem.h>

namespace osgLego
{

/** The cells of a part of a layout. */
inline BuildingBox toBox(const LaidPart& part)
{
    BuildingBox box;
    box.lower = {part.place[0], part.place[1], part.place[2]};
    box.upper = box.lower + glm::ivec3(part.size[0], part.size[1], part.size[2]);
    return box;
}

} // namespace osgLego
