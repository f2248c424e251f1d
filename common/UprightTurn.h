#pragma once

#include <osg/MatrixTransform>
#include <osg/Node>
#include <osg/ref_ptr>

namespace osgLego
{

/** The turn from Y-up to Z-up, with which OpenSceneGraph's reader of .obj files turns its models: from x, y, z to
 * x, -z, y. */
const osg::Matrixd& getUprightTurn();

/** Put a node with Y upwards below a transform that makes it stand in OpenSceneGraph's world, where Z is upwards.
 * `.legolize` does this to bricks with `up=y`.
 *
 * @return the transform. */
osg::ref_ptr<osg::MatrixTransform> turnUpright(osg::Node& node);

/** Whether a node is a transform from turnUpright(), also if it was read from a file. */
bool isUprightTurn(const osg::Node& node);

} // namespace osgLego
