#include <osgLego/node/NodePlace.h>

#include <algorithm>

#include <osg/Notify>
#include <osg/Transform>

namespace osgLego
{

namespace
{

const osg::Node* findRoot(const osg::Node& node)
{
    return node.getNumParents() > 0 ? findRoot(*node.getParent(0)) : &node;
}

} // namespace

bool NodePlace::update(const osg::Node& node, bool isInWorld)
{
    _root = isInWorld ? findRoot(node) : nullptr;
    const osg::MatrixList places = isInWorld ? node.getWorldMatrices() : osg::MatrixList();
    const osg::Matrixd toWorld = places.empty() ? osg::Matrixd() : places.front();
    const auto differs = [&](const osg::Matrix& place) { return place != toWorld; };
    if (!_hasWarned && std::any_of(places.begin(), places.end(), differs))
    {
        _hasWarned = true;
        const std::string name = node.getName().empty() ? "a LegoNode" : "'" + node.getName() + "'";
        OSG_WARN << "osgLego: " << name
                 << " has several places in the world; its bricks with anchor=world are made for the first one, and "
                    "are drawn at the others with their transforms; expected one LegoNode for each place"
                 << std::endl;
    }
    if (toWorld == _toWorld) return false;
    _toWorld = toWorld;
    _obstacle.clear();
    if (!_toNode.invert(toWorld) || !_toNode.valid())
    {
        _toNode.makeIdentity();
        _obstacle = "the transform above the node has no inverse; expected one that has, with anchor=world";
    }
    return true;
}

} // namespace osgLego
