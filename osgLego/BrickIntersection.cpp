#include <osgLego/BrickIntersection.h>

#include <osgLego/polygonization/BrickDrawable.h>
#include <osgLego/polygonization/BrickTriangles.h>

namespace osgLego
{

namespace
{

/** The bricks that a drawable consists of; null if it is not made of bricks. */
osg::ref_ptr<const BrickModel> findModel(const osg::Drawable* drawable)
{
    if (const auto* bricks = dynamic_cast<const BrickDrawable*>(drawable)) return bricks->getModel();
    if (!drawable) return nullptr;
    const auto* holder = dynamic_cast<const BrickModelHolder*>(drawable->getUserData());
    return holder ? &holder->getModel() : nullptr;
}

osg::ref_ptr<LegoNode> findNode(const osg::NodePath& path)
{
    for (auto node = path.rbegin(); node != path.rend(); ++node)
        if (auto* lego = dynamic_cast<LegoNode*>(*node)) return lego;
    return nullptr;
}

} // namespace

std::optional<BrickIntersection>
BrickIntersection::find(const osgUtil::LineSegmentIntersector::Intersection& intersection)
{
    BrickIntersection found;
    found.model = findModel(intersection.drawable);
    if (!found.model) return std::nullopt;
    const std::optional<BrickTriangle> triangle = findBrickTriangle(*found.model, intersection.primitiveIndex);
    if (!triangle) return std::nullopt;
    found.node = findNode(intersection.nodePath);
    found.brick = triangle->brick;
    found.part = found.model->findPart(triangle->brick.getCell());
    found.side = triangle->side;
    found.isStud = triangle->isStud;
    return found;
}

} // namespace osgLego
