#pragma once

#include "GltfBricks.h"

#include <cstdint>
#include <vector>

#include <osg/Vec3>

namespace osgLego
{

/** The triangles of a part, studs included, with the origin at the centre of its lower side. */
struct GltfPartMesh
{
    std::vector<osg::Vec3> vertices; //!< in model units
    std::vector<osg::Vec3> normals;
    std::vector<std::uint16_t> indices;

    /** Create the mesh of a shape in a grid, as createBrickGeometry() makes it, except that the sides are
     * BrickDimensions::GAP from those of the cells: parts side by side have a visible joint, as real ones.
     * @return no vertices if there would be more than 65535. */
    static GltfPartMesh create(const GltfBricks::Shape& shape, const BrickGrid& grid);
};

} // namespace osgLego
