#pragma once

#include <osgLego/flattening/SurfaceTexture.h>

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <osg/BoundingBox>
#include <osg/Node>
#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

class SurfaceTextureCache;

/** A corner of a triangle, in the coordinates of the node that was flattened. */
struct SceneVertex
{
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

/** The triangles of any OSG subgraph, flattened: transforms applied, state resolved to plain colours and textures.
 *
 * Handles nested transforms, shared children, Switch, Sequence and LOD (the finest level loaded), every primitive type
 * of triangles (strips, fans, quads, polygons, indexed or not), colour arrays of any type and binding, Materials, the
 * Texture2D of the first unit with one, with wrap mode, matrix and environment, and inherited state with OVERRIDE and
 * PROTECTED. The colour of a triangle is the one that OSG would draw without lighting: the texture times the material
 * or vertex colour.
 *
 * Lines, points and triangles without area are ignored. So are, with a warning that gives their number, triangles with
 * a vertex that is not finite or beyond MAXIMUM_COORDINATE, be it by its array or by a transform, and, with a warning,
 * sources smaller than MINIMUM_SIZE. Colours are limited to 0 to 1; channels that are NaN become 0. Texture coordinates
 * that are not finite or beyond MAXIMUM_COORDINATE, with their matrix applied, become (0, 0). A warning counts the
 * vertices with such texture coordinates, or with colours in an array that are not finite.
 *
 * Usage:
 *
 *     osg::ref_ptr<const osgLego::SceneTriangles> triangles = osgLego::SceneTriangles::create(*node);
 *     if (triangles->getNumTriangles() == 0) ...
 *
 * Uses no GL. create() may be called from any thread as long as no other thread changes the subgraph; the result is
 * immutable and independent of the subgraph.
 */
class SceneTriangles : public osg::Referenced
{
public:
    // OpenSceneGraph keeps bounding spheres in single precision and squares their radii, which must neither overflow
    // nor underflow.
    static constexpr double MAXIMUM_COORDINATE = 1e18; //!< model units, or image sizes, of either sign
    static constexpr double MINIMUM_SIZE = 1e-18;      //!< model units, the longest side of the source's bounds

    /** Flatten the visible parts of the subgraph `node`, in the order of traversal. */
    static osg::ref_ptr<const SceneTriangles> create(const osg::Node& node);
    /** Likewise, but reuse textures from earlier calls. */
    static osg::ref_ptr<const SceneTriangles> create(const osg::Node& node, SurfaceTextureCache& textures);

    const std::vector<SceneBatch>& getBatches() const { return _batches; }
    /** The bounds of the triangles' corners, in the node's coordinates; invalid when there are none. */
    const osg::BoundingBoxd& getBounds() const { return _bounds; }
    std::size_t getNumTriangles() const { return _numTriangles; }
    /** The number of triangle vertices with a coordinate that is NaN, infinite, or beyond MAXIMUM_COORDINATE. A vertex
     * shared by several triangles of a geometry through its index counts once. */
    std::size_t getNumBadVertices() const { return _numBadVertices; }
    /** The number of triangles ignored because of such vertices. */
    std::size_t getNumOutOfRange() const { return _numOutOfRange; }
    /** The number of triangle vertices whose colour or texture coordinate was replaced because it was not finite or too
     * large. */
    std::size_t getNumReplaced() const { return _numReplaced; }

private:
    friend class SceneTriangleCollector;

    SceneTriangles() = default;
    ~SceneTriangles() override = default;

    std::vector<SceneBatch> _batches;
    osg::BoundingBoxd _bounds;
    std::size_t _numTriangles = 0;
    std::size_t _numBadVertices = 0;
    std::size_t _numOutOfRange = 0;
    std::size_t _numReplaced = 0;
};

} // namespace osgLego
