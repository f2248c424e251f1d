#pragma once

#include <osgLego/passes/LegolizationPass.h>

#include <osg/Texture2D>

namespace osgLego
{

/** Draws the vertices of the fine triangles into a square picture by orthographic projection, each pixel telling the
 * cell that its vertex lies in (the paper, section III-B, Algorithms 3 and 4).
 *
 * Vertices that fall on the same pixel collide, and the last one stays: the larger the picture, the fewer cells are
 * lost. The picture looks along a direction in which no axis of the grid is seen end on, so that no wall of an upright
 * model shrinks to a line.
 */
class ProjectionPass : public LegolizationPass
{
public:
    ProjectionPass(PassWorkspace& workspace, unsigned int step, osg::Texture2D& picture);

    /** The power of two by which cell numbers are divided in the picture's alpha. */
    static float getNumberScale(const BrickGrid& grid);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const ProjectionPass*>(object) != nullptr;
    }
    const char* className() const override { return "ProjectionPass"; }

protected:
    std::string run(osg::State& state, Legolization& work) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.voxelization; }
};

} // namespace osgLego
