#pragma once

#include <osgLego/Export.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** How the geometry of bricks carries their colours. */
enum class BrickColors
{
    BY_VERTEX,  //!< one geometry for each LegoNode, a colour a vertex
    BY_MATERIAL //!< one geometry for each colour of a LegoNode, under an osg::Material
};

/** A scene as programs can take it that do not know osgLego: each LegoNode is replaced by an osg::Geode of its bricks
 * (see createBrickGeometry), each AmbientOcclusionScene by a plain osg::Group. Needs no GL context.
 *
 * osgDB does this itself with what it writes into other formats than its own, as soon as there is a LegoNode; call it
 * where a scene is handed over in another way: to an osgDB::ReaderWriter directly, or under an osgDB::Options or an
 * osgDB::Registry with a WriteFileCallback of the program's own.
 *
 * LegoNodes without triangles become groups of their sources. Nodes above the bricks are copied, others are shared with
 * the original. What a LegoNode's own state set says of its source is in the bricks' colours; it is not copied.
 *
 * To be called from the thread that updates the scene.
 * @return the scene itself when there is neither a LegoNode nor an AmbientOcclusionScene in it. */
OSGLEGO_EXPORT osg::ref_ptr<const osg::Node> createBrickScene(const osg::Node& scene, BrickColors colors);

} // namespace osgLego
