#pragma once

#include <osgLego/Export.h>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Where the geometry of bricks stores their colours. */
enum class BrickColors
{
    BY_VERTEX,  //!< one geometry for each LegoNode, with one colour per vertex
    BY_MATERIAL //!< one geometry for each colour of a LegoNode, with an osg::Material
};

/** Create a scene for programs without osgLego: each LegoNode is replaced by an osg::Geode with its bricks (see
 * createBrickGeometry), each AmbientOcclusionScene by an osg::Group. Needs no GL context.
 *
 * Once a LegoNode exists, osgDB does this itself for files in formats other than OSG's own. Call this function if a
 * scene is written in another way: by an osgDB::ReaderWriter directly, or with an osgDB::Options or osgDB::Registry
 * that has its own WriteFileCallback.
 *
 * LegoNodes without triangles become groups with their sources. Nodes above the bricks are copied; other nodes are
 * shared with the original. The state set of a LegoNode is not copied, since its effect is already in the colours of
 * the bricks.
 *
 * Call it from the thread that updates the scene.
 * @return the scene itself if it contains neither a LegoNode nor an AmbientOcclusionScene. */
OSGLEGO_EXPORT osg::ref_ptr<const osg::Node> createBrickScene(const osg::Node& scene, BrickColors colors);

/** Create a scene without the sources of its bricks: each LegoNode is replaced by a copy without children, in which its
 * bricks are stored (LegoNode::setStoredBricks()). The look of the bricks, AmbientOcclusionScenes included, is kept.
 * Needs no GL context.
 *
 * With the option "bake", osgDB writes this scene to files in OSG's own formats:
 *
 *     osg::ref_ptr<osgDB::Options> options = new osgDB::Options("bake");
 *     osgDB::writeNodeFile(*scene, "bricks.osgb", options);
 *
 * A scene that contains no LegoNode with bricks is written unchanged, with a warning.
 *
 * LegoNodes without triangles keep their sources, which they draw instead of bricks. Nodes above the bricks are copied;
 * other nodes are shared with the original.
 *
 * Call it from the thread that updates the scene.
 * @return the scene itself if it contains no LegoNode with bricks. */
OSGLEGO_EXPORT osg::ref_ptr<const osg::Node> createBakedScene(const osg::Node& scene);

} // namespace osgLego
