#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/LegoNode.h>

#include <optional>

#include <osg/ref_ptr>
#include <osgUtil/LineSegmentIntersector>

namespace osgLego
{

/** Which brick an intersection has hit: its cell, its colour, and where on it.
 *
 * Works on the bricks of a LegoNode and on geometry made by createBrickGeometry, wherever they stand in a scene. Both
 * are intersected as the triangles that createBrickGeometry describes, faces and studs, so that of an Intersection
 *
 * - `primitiveIndex` is the number of the triangle in that order;
 * - `indexList` and `ratioList` name the vertices of geometry; for a LegoNode, whose bricks have no vertex array, OSG
 *   leaves them empty.
 *
 * Preconditions:
 * 1. The LegoNode shows the same bricks as when the intersection was found: the next frame may bring others.
 * 2. Geometry still has its user data and its triangles in the order in which they were made: merging and flattening
 *    by the osgUtil::Optimizer keep it, reordering (INDEX_MESH, VERTEX_POSTTRANSFORM, VERTEX_PRETRANSFORM) does not.
 *
 * Usage:
 *
 *     osg::ref_ptr<osgUtil::LineSegmentIntersector> ray = new osgUtil::LineSegmentIntersector(from, to);
 *     osgUtil::IntersectionVisitor visitor(ray);
 *     scene->accept(visitor);
 *     if (!ray->containsIntersections()) return;
 *     if (const auto hit = osgLego::BrickIntersection::find(ray->getFirstIntersection()))
 *         select(hit->brick.getCell());
 *
 * A plain value; needs no GL context.
 */
struct OSGLEGO_EXPORT BrickIntersection
{
    osg::ref_ptr<LegoNode> node;          //!< null for geometry that is under no LegoNode
    osg::ref_ptr<const BrickModel> model; //!< all bricks of the node or the geometry, and their grid
    Brick brick;                          //!< its cell, its colour (red, green, blue), its open sides
    BrickSide side = SIDE_LEFT;           //!< the side that was hit; of a stud the one that it stands on
    bool isStud = false;                  //!< whether the stud was hit, its wall or its top

    /** Find the brick. Counts through the bricks before it: a few milliseconds for some millions. May be called from
     * the thread that updates the scene.
     * @return empty when what was hit is no brick. */
    static std::optional<BrickIntersection> find(const osgUtil::LineSegmentIntersector::Intersection& intersection);
};

} // namespace osgLego
