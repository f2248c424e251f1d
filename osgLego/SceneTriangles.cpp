#include <osgLego/SceneTriangles.h>

#include <osgLego/SceneTriangleCollector.h>

#include <osg/Notify>

namespace osgLego
{

osg::ref_ptr<const SceneTriangles> SceneTriangles::create(const osg::Node& node)
{
    osg::ref_ptr<SceneTriangles> triangles = new SceneTriangles;
    SceneTriangleCollector collector(*triangles);
    // accept() is not const, but the visitor only reads.
    const_cast<osg::Node&>(node).accept(collector);
    if (triangles->getNumNotFinite() > 0)
    {
        OSG_WARN << "osgLego: " << triangles->getNumNotFinite() << " triangles of '" << node.getName()
                 << "' have coordinates that are not finite, and are left out" << std::endl;
    }
    return triangles;
}

} // namespace osgLego
