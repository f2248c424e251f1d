#pragma once

#include <osgLego/flattening/SurfaceTexture.h>

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <osg/BoundingBox>
#include <osg/ref_ptr>

namespace osgLego
{

/** A corner of a triangle, in the coordinates of the node that was flattened. */
struct SceneVertex
{
    // OpenSceneGraph keeps bounding spheres in single precision and squares their radii, which must neither overflow
    // nor underflow.
    static constexpr double MAXIMUM_COORDINATE = 1e18; //!< model units, or image sizes, of either sign

    glm::dvec3 position{0.0};
    glm::vec2 coordinate{0.0f}; //!< texture coordinate, with the texture matrix applied; 1 is the size of the image
    glm::vec3 color{1.0f};      //!< before texturing, 0 to 1 per channel
};

/** The vertex halfway between two others, and the square of their distance. */
SceneVertex midpoint(const SceneVertex& a, const SceneVertex& b);
double squaredLength(const SceneVertex& a, const SceneVertex& b);

/** Triangles that share one texture, three vertices each. */
struct SceneBatch
{
    osg::ref_ptr<const SurfaceTexture> texture; //!< null: the vertices have colours only
    TextureEnvironment environment = TextureEnvironment::MODULATE;
    std::vector<SceneVertex> vertices;
};

/** All batches of a scene, and the numbers of vertices and triangles with bad values; SceneTriangles describes them. */
struct SceneBatches
{
    std::vector<SceneBatch> batches;
    osg::BoundingBoxd bounds;
    std::size_t numTriangles = 0;
    std::size_t numBadVertices = 0;
    std::size_t numOutOfRange = 0;
    std::size_t numReplaced = 0;
    std::size_t numTexts = 0;
};

} // namespace osgLego
