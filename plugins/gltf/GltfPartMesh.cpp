#include "GltfPartMesh.h"

#include <osgLego/BrickGeometry.h>

#include <cmath>
#include <limits>

#include <osg/Geometry>

namespace osgLego
{

GltfPartMesh GltfPartMesh::create(const GltfBricks::Shape& shape, const BrickGrid& grid)
{
    const int up = grid.getUpIndex();
    const int first = (up + 1) % 3;
    const int second = (up + 2) % 3;
    BrickGrid own = grid;
    own.dimensions[first] = shape.length;
    own.dimensions[second] = shape.width;
    own.dimensions[up] = shape.height;
    own.origin = -0.5 * own.cellSize * glm::dvec3(own.dimensions);
    own.origin[up] = 0.0;
    Part part;
    for (int axis = 0; axis < 3; ++axis)
        part.size[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(own.dimensions[axis]);
    const osg::ref_ptr<osg::Geometry> geometry =
        createBrickGeometry(*BrickModel::createOfParts(own, std::vector<Part>{part}));

    GltfPartMesh mesh;
    const auto& vertices = dynamic_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
    const auto& normals = dynamic_cast<const osg::Vec3Array&>(*geometry->getNormalArray());
    if (vertices.size() > std::numeric_limits<std::uint16_t>::max()) return mesh;
    mesh.vertices.assign(vertices.begin(), vertices.end());
    mesh.normals.assign(normals.begin(), normals.end());
    for (const int axis : {first, second})
    {
        const auto side = static_cast<float>(-own.origin[axis]);
        const auto gap = static_cast<float>(BrickDimensions::GAP * own.getPitch());
        for (osg::Vec3& vertex : mesh.vertices)
            if (std::abs(vertex[axis]) > side - gap) vertex[axis] = std::copysign(side - gap, vertex[axis]);
    }
    const osg::PrimitiveSet& triangles = *geometry->getPrimitiveSet(0);
    mesh.indices.reserve(triangles.getNumIndices());
    for (unsigned int index = 0; index < triangles.getNumIndices(); ++index)
        mesh.indices.push_back(static_cast<std::uint16_t>(triangles.index(index)));
    return mesh;
}

} // namespace osgLego
