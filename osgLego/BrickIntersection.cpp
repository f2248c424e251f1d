#include <osgLego/BrickIntersection.h>

#include <osgLego/polygonization/BrickDrawable.h>
#include <osgLego/polygonization/BrickTriangles.h>

namespace osgLego
{

namespace
{

/** The models of a drawable that is made of bricks; null for others. */
struct Models
{
    explicit Models(const osg::Drawable* drawable)
    {
        if (const auto* bricks = dynamic_cast<const BrickDrawable*>(drawable))
        {
            all = bricks->getModel();
            placed = bricks->getPlacedModel();
        }
        else if (drawable)
            if (const auto* holder = dynamic_cast<const BrickModelHolder*>(drawable->getUserData()))
                all = placed = &holder->getModel();
    }

    osg::ref_ptr<const BrickModel> all;
    osg::ref_ptr<const BrickModel> placed; // of the parts in place, whose triangles were intersected
};

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
    const Models models(intersection.drawable);
    if (!models.all || !models.placed) return std::nullopt;
    const std::optional<BrickTriangle> triangle = findBrickTriangle(*models.placed, intersection.primitiveIndex);
    if (!triangle) return std::nullopt;
    const Brick* brick = models.all->find(triangle->brick.getCell());
    if (!brick) return std::nullopt; // other bricks have replaced those that were intersected
    found.model = models.all;
    found.node = findNode(intersection.nodePath);
    found.brick = *brick;
    found.part = found.model->findPart(brick->getCell());
    found.side = triangle->side;
    found.isStud = triangle->isStud;
    return found;
}

} // namespace osgLego
