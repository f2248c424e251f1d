#pragma once

#include <osgLego/flattening/SceneBatch.h>

#include <cstddef>
#include <vector>

#include <osg/BoundingBox>
#include <osg/Matrixd>
#include <osg/Node>
#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

class SurfaceTextureCache;

/** The triangles of any OSG subgraph, flattened: transforms applied, state resolved to plain colours and textures.
 *
 * Handles nested transforms, shared children, Switch, Sequence and LOD (the finest level loaded), every primitive type
 * of triangles (strips, fans, quads, polygons, indexed or not), colour arrays of any type and binding, Materials, the
 * Texture2D of the first unit with one, with wrap mode, matrix and environment, and inherited state with OVERRIDE and
 * PROTECTED. The colour of a triangle is the one that OSG would draw without lighting: the texture times the material
 * or vertex colour.
 *
 * Lines, points, triangles without area and osgText::Text are ignored. So are, with a warning that gives their number,
 * triangles with a vertex that is not finite or beyond SceneVertex::MAXIMUM_COORDINATE, through its array or a
 * transform, and, with a warning, sources smaller than MINIMUM_SIZE. Another warning tells of sources smaller than
 * SMALLEST_DRAWN or larger than LARGEST_DRAWN. Colours are limited to 0 to 1; channels that are NaN become 0. Texture
 * coordinates that are not finite or beyond SceneVertex::MAXIMUM_COORDINATE, with their matrix applied, become (0, 0).
 * A warning counts the vertices with such texture coordinates, or with colours in an array that are not finite.
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
    /** The longest side of the source's bounds, in model units; see SceneVertex::MAXIMUM_COORDINATE. */
    static constexpr double MINIMUM_SIZE = 1e-18;
    /** Longest sides with which pictures are right: GL computes them, and lights, in single precision. */
    static constexpr double SMALLEST_DRAWN = 1e-8;
    static constexpr double LARGEST_DRAWN = 1e13;

    /** Flatten the visible parts of the subgraph `node`, in the order of traversal. */
    static osg::ref_ptr<const SceneTriangles> create(const osg::Node& node);
    /** Likewise, but reuse textures from earlier calls.
     * @param toRoot a transform of the node's coordinates, which is applied to the triangles. */
    static osg::ref_ptr<const SceneTriangles> create(const osg::Node& node, SurfaceTextureCache& textures,
                                                     const osg::Matrixd& toRoot = osg::Matrixd());

    const std::vector<SceneBatch>& getBatches() const { return _contents.batches; }
    /** The bounds of the triangles' corners, in the node's coordinates; invalid when there are none. */
    const osg::BoundingBoxd& getBounds() const { return _contents.bounds; }
    std::size_t getNumTriangles() const { return _contents.numTriangles; }
    /** The number of triangle vertices with a coordinate that is NaN, infinite, or beyond
     * SceneVertex::MAXIMUM_COORDINATE. A vertex shared by several triangles of a geometry through its index counts
     * once. */
    std::size_t getNumBadVertices() const { return _contents.numBadVertices; }
    /** The number of triangles ignored because of such vertices. */
    std::size_t getNumOutOfRange() const { return _contents.numOutOfRange; }
    /** The number of triangle vertices whose colour or texture coordinate was replaced because it was not finite or too
     * large. */
    std::size_t getNumReplaced() const { return _contents.numReplaced; }
    /** The number of texts, which are ignored. */
    std::size_t getNumTexts() const { return _contents.numTexts; }
    /** Print that the texts of `node` are ignored, if it has any. Apart from create(), since once is enough for a node
     * that is flattened again and again. */
    void warnOfTexts(const osg::Node& node) const;

private:
    explicit SceneTriangles(SceneBatches contents);
    ~SceneTriangles() override = default;

    SceneBatches _contents;
};

} // namespace osgLego
