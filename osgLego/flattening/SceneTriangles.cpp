#include <osgLego/flattening/SceneTriangles.h>

#include <osgLego/text/CountedNoun.h>

#include <osgLego/flattening/SceneTriangleCollector.h>
#include <osgLego/flattening/SurfaceTextureCache.h>

#include <algorithm>
#include <string>
#include <utility>

#include <osg/Notify>

namespace osgLego
{

namespace
{

std::string ownerText(const osg::Node& node)
{
    return node.getName().empty() ? std::string() : " of '" + node.getName() + "'";
}

void warnOfReplacedAttributes(const SceneTriangles& triangles, const osg::Node& node)
{
    OSG_WARN << "osgLego: " << counted(triangles.getNumReplaced(), "vertex", "vertices") << ownerText(node)
             << (triangles.getNumReplaced() == 1 ? " has" : " have")
             << " a colour or texture coordinates that are not finite, or texture coordinates beyond "
             << SceneVertex::MAXIMUM_COORDINATE << "; these are replaced by values in range" << std::endl;
}

void warnOfBadVertices(const SceneTriangles& triangles, const osg::Node& node)
{
    OSG_WARN << "osgLego: " << counted(triangles.getNumBadVertices(), "vertex", "vertices") << ownerText(node)
             << (triangles.getNumBadVertices() == 1 ? " has" : " have") << " coordinates that are not finite or beyond "
             << SceneVertex::MAXIMUM_COORDINATE << "; "
             << counted(triangles.getNumOutOfRange(), "triangle", "triangles") << " with such vertices "
             << (triangles.getNumOutOfRange() == 1 ? "is" : "are") << " ignored" << std::endl;
}

std::string nameOf(const osg::Node& node)
{
    return node.getName().empty() ? "the model" : "'" + node.getName() + "'";
}

void warnOfPictures(const osg::Node& node, double longest)
{
    OSG_WARN << "osgLego: the longest side of " << nameOf(node) << " is " << longest
             << " units, with which pictures of it may be empty or dark; expected " << SceneTriangles::SMALLEST_DRAWN
             << " to " << SceneTriangles::LARGEST_DRAWN << std::endl;
}

} // namespace

SceneTriangles::SceneTriangles(SceneBatches contents) : _contents(std::move(contents)) {}

osg::ref_ptr<const SceneTriangles> SceneTriangles::create(const osg::Node& node)
{
    SurfaceTextureCache textures;
    return create(node, textures);
}

osg::ref_ptr<const SceneTriangles> SceneTriangles::create(const osg::Node& node, SurfaceTextureCache& textures,
                                                          const osg::Matrixd& toRoot)
{
    SceneBatches contents;
    SceneTriangleCollector collector(contents, textures, toRoot);
    // accept() is not const, but the visitor only reads.
    const_cast<osg::Node&>(node).accept(collector);
    contents.numTexts = collector.getNumTexts();
    textures.dropUnused();
    const osg::ref_ptr<const SceneTriangles> triangles = new SceneTriangles(std::move(contents));
    if (triangles->getNumOutOfRange() > 0) warnOfBadVertices(*triangles, node);
    if (triangles->getNumReplaced() > 0) warnOfReplacedAttributes(*triangles, node);
    const osg::Vec3d size = triangles->getBounds()._max - triangles->getBounds()._min;
    if (triangles->getNumTriangles() == 0) return triangles;
    const double longest = std::max({size.x(), size.y(), size.z()});
    if (longest < MINIMUM_SIZE)
    {
        OSG_WARN << "osgLego: " << nameOf(node) << " is smaller than " << MINIMUM_SIZE
                 << " units and is ignored; expected a larger scale" << std::endl;
        return new SceneTriangles({});
    }
    if (longest < SMALLEST_DRAWN || longest > LARGEST_DRAWN) warnOfPictures(node, longest);
    return triangles;
}

void SceneTriangles::warnOfTexts(const osg::Node& node) const
{
    if (getNumTexts() == 0) return;
    OSG_WARN << "osgLego: " << counted(getNumTexts(), "text", "texts") << ownerText(node)
             << " can't be shown in bricks; expected osgText::Text3D, or texts beside the node" << std::endl;
}

} // namespace osgLego
