#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoSettings.h>

#include <functional>
#include <vector>

#include <osg/BoundingBox>
#include <osg/Group>
#include <osg/Matrixd>
#include <osg/NodeVisitor>
#include <osg/Sequence>
#include <osg/Transform>

namespace osgLego
{

/** The extent of a scene along given directions, including the possible extent of the bricks of its LegoNodes.
 *
 * Bricks are within one cell of the surface and inside the grid, so their extent is known before they exist. A mesh has
 * the same extent as the bricks that would be made from it, and columns that support them go down to the bottom of the
 * grid. Stored bricks have the extent of the visible ones.
 *
 *     SceneReach reach({osg::Vec3d(1, 0, 0), osg::Vec3d(-1, 0, 0)});
 *     reach.addSource(*mesh, settings);
 *     const double width = reach.getReach()[0] + reach.getReach()[1];
 */
class SceneReach : public osg::NodeVisitor
{
public:
    META_NodeVisitor(osgLego, SceneReach)

    /** @param directions vectors of any length, in the coordinates of the visited nodes. */
    explicit SceneReach(const std::vector<osg::Vec3d>& directions);

    /** Add the bricks made from a node with the given settings. */
    void addSource(osg::Node& source, const LegoSettings& settings);

    /** For each direction, its largest scalar product with a point of the scene. */
    const std::vector<double>& getReach() const { return _surface.reach; }
    /** Whether any point was added. */
    bool isValid() const { return _surface.bounds.valid(); }

    void apply(osg::Group& group) override;
    void apply(osg::Sequence& sequence) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Drawable& drawable) override;

private:
    /** Points with the same grid. */
    struct Surface
    {
        osg::Matrixd toScene; //!< from the coordinates of the grid
        unsigned int upIndex; //!< the axis of the grid along which studs point
        osg::BoundingBoxd bounds;
        std::vector<double> reach;
        std::vector<double> groundReach; //!< that of the points if the coordinate along the up axis were 0
    };

    Surface createSurface(const osg::Matrixd& toScene) const;
    void addBricks(const LegoSettings& settings, const std::function<void()>& visitSource);
    void addBox(const osg::BoundingBoxd& box);
    void addStoredBricks(const BrickModel& model);
    void addPoint(const osg::Vec3d& point);
    std::vector<double> reachOf(const osg::BoundingBoxd& box, const osg::Matrixd& toScene, bool isOffset) const;

    std::vector<osg::Vec3d> _directions;
    Surface _surface;
    osg::Matrixd _matrix; // to the coordinates of the surface's grid
    bool _isInSource = false;
};

} // namespace osgLego
