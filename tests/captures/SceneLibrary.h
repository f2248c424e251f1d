#pragma once

#include <string>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego::test
{

/** A scene that no command line can say: bricks among other nodes, lights, state, and what LegoNode alone can set.
 *
 * The first LegoNode is not moved, since the camera stands before it as it is.
 * @return the scene, LegoNodes and AmbientOcclusionScenes included; null when there is none of that name. */
osg::ref_ptr<osg::Node> createLibraryScene(const std::string& name);

} // namespace osgLego::test
