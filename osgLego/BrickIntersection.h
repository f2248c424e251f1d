#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/LegoNode.h>

#include <optional>

#include <osg/ref_ptr>
#include <osgUtil/LineSegmentIntersector>

namespace osgLego
{

/** The brick hit by an intersection, with its cell, colour and part, and the side or stud that was hit.
 *
 * Works for the bricks of a LegoNode and for geometry from createBrickGeometry, anywhere in a scene. Both are
 * intersected as the triangles described at createBrickGeometry, faces and studs. In an Intersection,
 *
 * - `primitiveIndex` is the number of the triangle in that order;
 * - `indexList` and `ratioList` refer to the vertices of geometry; OSG leaves them empty for a LegoNode, whose bricks
 *   have no vertex array.
 *
 * Preconditions:
 * 1. The LegoNode shows the same bricks as when the intersection was found; they may change with the next frame.
 * 2. Geometry still has its user data, and its triangles in their original order. Merging and flattening by
 *    osgUtil::Optimizer keep this order, reordering (INDEX_MESH, VERTEX_POSTTRANSFORM, VERTEX_PRETRANSFORM) does not.
 *
 * Usage:
 *
 *     osg::ref_ptr<osgUtil::LineSegmentIntersector> ray = new osgUtil::LineSegmentIntersector(from, to);
 *     osgUtil::IntersectionVisitor visitor(ray);
 *     scene->accept(visitor);
 *     if (!ray->containsIntersections()) return;
 *     if (const auto hit = osgLego::BrickIntersection::find(ray->getFirstIntersection()))
 *         select(hit->part ? hit->part->getCell() : hit->brick.getCell());
 *
 * A plain value; needs no GL context.
 */
struct OSGLEGO_EXPORT BrickIntersection
{
    osg::ref_ptr<LegoNode> node;          //!< null for geometry that is not under a LegoNode
    osg::ref_ptr<const BrickModel> model; //!< all bricks of the node or the geometry, and their grid
    Brick brick;                          //!< the cell, colour (red, green, blue) and open sides of the brick
    /** The part that the cell belongs to, in the model; findPartType() names it. Null if the cells are not joined to
     * parts, and for geometry that createBrickScene() has divided by colours. */
    const Part* part = nullptr;
    BrickSide side = SIDE_LEFT; //!< the side that was hit; for a stud, the upper side
    bool isStud = false;        //!< whether the wall or the top of the stud was hit

    /** Find the brick. The time is proportional to the number of bricks before it: a few milliseconds for several
     * million. May be called from the thread that updates the scene.
     * @return nothing if the intersection is not with a brick. */
    static std::optional<BrickIntersection> find(const osgUtil::LineSegmentIntersector::Intersection& intersection);
};

} // namespace osgLego
