#pragma once

#include <osgLego/LegoNode.h>

#include <vector>

#include <osg/Matrixd>
#include <osg/Node>

namespace osgLego
{

/** A LegoNode in its place. */
struct PlacedLegoNode
{
    const LegoNode* node;
    osg::Matrixd toWorld; //!< from the coordinates of LegoNode::getBricks()
};

/** Find the visible LegoNodes of a scene, once for each path to them, for writers of their bricks. */
std::vector<PlacedLegoNode> findVisibleLegoNodes(const osg::Node& scene);

} // namespace osgLego
