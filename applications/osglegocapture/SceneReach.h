#pragma once

#include <osgLego/LegoSettings.h>

#include <functional>
#include <vector>

#include <osg/BoundingBox>
#include <osg/Group>
#include <osg/Matrixd>
#include <osg/NodeVisitor>
#include <osg/Transform>

namespace osgLego
{

/** How far a scene reaches along some directions, its LegoNodes as far as their bricks may reach.
 *
 * Bricks lie within a cell of the surface and inside the grid, so that they need not be there yet, and a mesh reaches
 * as far as the bricks that would be made of it.
 *
 *     SceneReach reach({osg::Vec3d(1, 0, 0), osg::Vec3d(-1, 0, 0)});
 *     reach.addSource(*mesh, settings);
 *     const double width = reach.getReach()[0] + reach.getReach()[1];
 */
class SceneReach : public osg::NodeVisitor
{
public:
    META_NodeVisitor(osgLego, SceneReach)

    /** @param directions in the coordinates of the nodes that are visited, of any length. */
    explicit SceneReach(const std::vector<osg::Vec3d>& directions);

    /** Take in the bricks that settings make of a node. */
    void addSource(osg::Node& source, const LegoSettings& settings);

    /** For each direction the largest product of it with a point of the scene. */
    const std::vector<double>& getReach() const { return _surface.reach; }
    /** Whether there was any point. */
    bool isValid() const { return _surface.bounds.valid(); }

    void apply(osg::Group& group) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Drawable& drawable) override;

private:
    /** The points that share one grid. */
    struct Surface
    {
        osg::Matrixd toScene; //!< from the coordinates of the grid
        osg::BoundingBoxd bounds;
        std::vector<double> reach;
    };

    void addBricks(const LegoSettings& settings, const std::function<void()>& visitSource);
    void addPoint(const osg::Vec3d& point);
    std::vector<double> reachOf(const osg::BoundingBoxd& box, const osg::Matrixd& toScene, bool isOffset) const;

    std::vector<osg::Vec3d> _directions;
    Surface _surface;
    osg::Matrixd _matrix; // to the coordinates of the surface's grid
    bool _isInSource = false;
};

} // namespace osgLego
