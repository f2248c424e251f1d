#pragma once

#include <string>

#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego::test
{

/** Create a scene that can't be described on a command line: bricks among other nodes, lights, state, and settings that
 * only LegoNode has.
 *
 * The first LegoNode is not transformed, since the camera is placed according to its own coordinates.
 * @return the scene, including LegoNodes and AmbientOcclusionScenes; null if the name is unknown. */
osg::ref_ptr<osg::Node> createLibraryScene(const std::string& name);

} // namespace osgLego::test
