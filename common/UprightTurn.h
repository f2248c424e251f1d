#pragma once

#include <osg/MatrixTransform>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** Put a node with Y upwards below a transform that makes it stand in OpenSceneGraph's world, where Z is upwards: by
 * the turn with which OpenSceneGraph's reader of .obj files turns its models. `.legolize` does this to bricks with
 * `up=y`.
 *
 * @return the transform. */
osg::ref_ptr<osg::MatrixTransform> turnUpright(osg::Node& node);

/** Whether a node is a transform from turnUpright(), also if it was read from a file. */
bool isUprightTurn(const osg::Node& node);

} // namespace osgLego
