#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoNode.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego::test
{

/** A grid with its lowest corner at the origin. @param height of a cell, which is 1 wide. */
BrickGrid createPartGrid(const glm::ivec3& dimensions, double height = 1.0, UpAxis up = UpAxis::Z);

/** How createParts() fills cells. */
struct PartFilling
{
    std::function<bool(const glm::ivec3& cell)> isCovered = [](const glm::ivec3&) { return true; };
    std::vector<int> heights{1}; //!< of parts, in cells
    std::vector<std::array<std::uint8_t, 3>> colors{{150, 150, 150}};
    std::uint32_t seed = 1;
};

/** Fill cells with parts of random real sizes and colours; equal seeds give equal models. */
osg::ref_ptr<const BrickModel> createParts(const BrickGrid& grid, const PartFilling& filling);

/** A model of the same cells in the same colours, without parts. */
osg::ref_ptr<const BrickModel> createCells(const BrickModel& parts);

/** A node that shows a model, with settings in their text form. */
osg::ref_ptr<LegoNode> createStoredNode(const BrickModel& model, const std::string& settings);

} // namespace osgLego::test
