#pragma once

#include <osgLego/SceneTriangles.h>
#include <osgLego/SourceVisitor.h>
#include <osgLego/SurfaceState.h>

#include <map>
#include <tuple>

#include <osg/Geometry>

namespace osgLego
{

/** The visitor that fills SceneTriangles: each drawable's primitives, taken apart into triangles. */
class SceneTriangleCollector : public SourceVisitor
{
public:
    META_NodeVisitor(osgLego, SceneTriangleCollector)

    explicit SceneTriangleCollector(SceneTriangles& triangles) : _triangles(triangles) {}

protected:
    void applySurface(const osg::Drawable& drawable, const osg::Matrixd& toRoot,
                      const std::vector<const osg::StateSet*>& stateSets) override;

private:
    using BatchKey = std::tuple<const SurfaceTexture*, TextureEnvironment>;

    void collectGeometry(const osg::Geometry& geometry, const osg::Matrixd& toRoot, const SurfaceState& state);
    void collectShape(const osg::Drawable& drawable, const osg::Matrixd& toRoot, const SurfaceState& state);
    SceneBatch& findOrMakeBatch(const SurfaceState& state, bool hasCoordinates);
    osg::ref_ptr<const SurfaceTexture> findOrMakeTexture(const osg::Texture2D& texture);
    void addTriangle(SceneBatch& batch, const SceneVertex& a, const SceneVertex& b, const SceneVertex& c);

    SceneTriangles& _triangles;
    std::map<BatchKey, std::size_t> _batchIndices;
    std::map<const osg::Texture2D*, osg::ref_ptr<const SurfaceTexture>> _textures;
};

} // namespace osgLego
