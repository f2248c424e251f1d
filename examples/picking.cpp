// Finds the brick and the part under a ray, without a GL context.

#include <osgLego/BrickIntersection.h>
#include <osgLego/LegoNode.h>

#include <iostream>

#include <osg/ShapeDrawable>
#include <osgUtil/LineSegmentIntersector>

int main()
{
    osgLego::LegoSettings settings;
    std::string error;
    if (!osgLego::LegoSettings::parse("24,parts=bricks", settings, error))
    {
        std::cerr << error << '\n';
        return 1;
    }
    const osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode(settings);
    lego->addChild(new osg::ShapeDrawable(new osg::Sphere({0, 0, 0}, 1.0f)));

    const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(0.1, 0.1, 5.0), osg::Vec3d(0.1, 0.1, -5.0));
    osgUtil::IntersectionVisitor visitor(ray);
    lego->accept(visitor);
    if (!ray->containsIntersections()) return 1;
    const auto hit = osgLego::BrickIntersection::find(ray->getFirstIntersection());
    if (!hit || !hit->part) return 1;
    const auto& cell = hit->brick.cell;
    std::cout << "cell " << cell[0] << ' ' << cell[1] << ' ' << cell[2] << ", a part of " << hit->part->getSize().x
              << " x " << hit->part->getSize().y << (hit->isStud ? ", its stud\n" : "\n");
    // Show the part in magenta.
    const osg::ref_ptr<const osgLego::BrickModel> bricks = lego->getBricks();
    const auto index = static_cast<std::size_t>(bricks->findPart(hit->brick.getCell()) - bricks->getParts().data());
    if (!lego->setHighlightedParts({&index, 1}, {255, 0, 200})) return 1;
    // The ray comes from above, so it meets the topmost layer.
    return cell[2] == hit->model->getGrid().dimensions.z - 1 ? 0 : 1;
}
