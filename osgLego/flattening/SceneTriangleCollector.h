#pragma once

#include <osgLego/flattening/SceneBatch.h>
#include <osgLego/flattening/SourceVisitor.h>
#include <osgLego/flattening/SurfaceState.h>
#include <osgLego/flattening/SurfaceTextureCache.h>

#include <array>
#include <map>
#include <tuple>

#include <osg/Geometry>

namespace osgLego
{

/** The visitor that fills SceneBatches with the primitives of each drawable, split into triangles. */
class SceneTriangleCollector : public SourceVisitor
{
public:
    META_NodeVisitor(osgLego, SceneTriangleCollector)

    /** @param toRoot as in SourceVisitor. */
    SceneTriangleCollector(SceneBatches& contents, SurfaceTextureCache& textures, const osg::Matrixd& toRoot) :
        SourceVisitor(toRoot), _contents(contents), _textures(textures)
    {
    }

protected:
    void applySurface(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                      const std::vector<const osg::StateSet*>& stateSets) override;

private:
    using BatchKey = std::tuple<const SurfaceTexture*, TextureEnvironment>;

    void collectGeometry(const osg::Geometry& geometry, const osg::Matrixd& toRoot, const SurfaceState& state);
    void collectShape(const osg::Drawable& drawable, const osg::Matrixd& toRoot, const SurfaceState& state);
    SceneBatch& findOrMakeBatch(const SurfaceState& state, bool hasCoordinates);
    /** @return false when a corner is not finite or too far away, and the triangle is ignored. */
    bool addTriangle(SceneBatch& batch, const std::array<SceneVertex, 3>& corners);

    SceneBatches& _contents;
    SurfaceTextureCache& _textures;
    std::map<BatchKey, std::size_t> _batchIndices;
};

} // namespace osgLego
