#include <osgLego/flattening/SceneTriangles.h>

#include <osgLego/flattening/SceneTriangleCollector.h>
#include <osgLego/flattening/SurfaceTextureCache.h>

#include <algorithm>

#include <osg/Notify>

namespace osgLego
{

osg::ref_ptr<const SceneTriangles> SceneTriangles::create(const osg::Node& node)
{
    SurfaceTextureCache textures;
    return create(node, textures);
}

osg::ref_ptr<const SceneTriangles> SceneTriangles::create(const osg::Node& node, SurfaceTextureCache& textures)
{
    osg::ref_ptr<SceneTriangles> triangles = new SceneTriangles;
    SceneTriangleCollector collector(*triangles, textures);
    // accept() is not const, but the visitor only reads.
    const_cast<osg::Node&>(node).accept(collector);
    textures.dropUnused();
    if (triangles->getNumOutOfRange() > 0)
    {
        OSG_WARN << "osgLego: " << triangles->getNumOutOfRange() << " triangles of '" << node.getName()
                 << "' have coordinates that are not finite or beyond " << MAXIMUM_COORDINATE << ", and are left out"
                 << std::endl;
    }
    const osg::Vec3d size = triangles->_bounds._max - triangles->_bounds._min;
    if (triangles->_numTriangles > 0 && std::max({size.x(), size.y(), size.z()}) < MINIMUM_SIZE)
    {
        OSG_WARN << "osgLego: '" << node.getName() << "' is smaller than " << MINIMUM_SIZE
                 << " units and is left out; allowed: a larger scale" << std::endl;
        return new SceneTriangles;
    }
    return triangles;
}

} // namespace osgLego
