#pragma once

#include <osgLego/passes/LegolizationPass.h>

#include <glm/vec3.hpp>
#include <osg/Texture2D>

namespace osgLego
{

/** Draws the vertices of the fine triangles into a square picture by orthographic projection. Each pixel contains the
 * number of the cell of its vertex (the paper, section III-B, Algorithms 3 and 4).
 *
 * If several vertices fall on the same pixel, the depth buffer keeps the one nearest to the picture, and the first of
 * those at the same depth. Cells behind others are lost; a larger picture loses fewer of them. The picture is fitted
 * to the triangles. The direction of projection is parallel to no coordinate plane, so that no wall of an upright model
 * is projected to a line.
 */
class ProjectionPass : public LegolizationPass
{
public:
    ProjectionPass(PassWorkspace& workspace, unsigned int step, osg::Texture2D& picture);

    /** The direction from the model to the picture, in cell units; not of length 1. */
    static glm::vec3 getDirection();
    /** The power of two by which cell numbers are divided to store them in alpha. */
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
