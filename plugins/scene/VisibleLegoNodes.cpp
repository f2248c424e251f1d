#include "VisibleLegoNodes.h"

#include <osg/NodeVisitor>
#include <osg/Transform>

namespace osgLego
{

namespace
{

class LegoNodes : public osg::NodeVisitor
{
public:
    explicit LegoNodes(const osg::Node& scene) : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN)
    {
        const_cast<osg::Node&>(scene).accept(*this); // the visitor changes nothing
    }

    void apply(osg::Group& group) override
    {
        if (const auto* lego = dynamic_cast<const LegoNode*>(&group))
            found.push_back({lego, lego->getBricksToNode() * osg::computeLocalToWorld(getNodePath())});
        else
            traverse(group);
    }

    std::vector<PlacedLegoNode> found;
};

} // namespace

std::vector<PlacedLegoNode> findVisibleLegoNodes(const osg::Node& scene)
{
    return LegoNodes(scene).found;
}

} // namespace osgLego
