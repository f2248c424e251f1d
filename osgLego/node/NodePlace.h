#pragma once

#include <string>

#include <osg/Matrixd>
#include <osg/Node>

namespace osgLego
{

/** The transforms between a node and the world, for bricks in a lattice of the world (Anchor::WORLD); both are the
 * identity for other bricks.
 *
 * Of a node with several parents, or parents with several, the first path from the root counts. If the transforms of
 * the paths differ, a warning says so, once.
 *
 * One thread at a time, while no other thread changes the scene.
 */
class NodePlace
{
public:
    /** Look at the transforms above a node.
     * @param isInWorld whether they count.
     * @return whether they have changed since the last call. */
    bool update(const osg::Node& node, bool isInWorld);

    const osg::Matrixd& getToWorld() const { return _toWorld; }
    const osg::Matrixd& getToNode() const { return _toNode; }

    /** The first node of the path; null for bricks that are not in a lattice of the world. */
    const osg::Node* getRoot() const { return _root; }

    /** The reason why the transforms can't be used; empty if they can. */
    const std::string& getObstacle() const { return _obstacle; }

private:
    osg::Matrixd _toWorld;
    osg::Matrixd _toNode;
    const osg::Node* _root = nullptr; // compared only, never used
    std::string _obstacle;
    bool _hasWarned = false;
};

} // namespace osgLego
