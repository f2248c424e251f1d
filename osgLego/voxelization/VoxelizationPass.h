#pragma once

#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

#include <osg/Texture2D>

namespace osgLego
{

/** Marks the covered cells of one slab in the voxel image, which has one texel per cell (the paper, section III-B).
 *
 * It draws a point for every cell that a fine triangle overlaps (exact), for every vertex (points, addressed), or for
 * every pixel of the picture made by ProjectionPass (points, projected). Exact: blending sums up weighted colours in
 * each texel, and weights in its alpha. Points: the last one in a texel determines its colour. GL draws and blends in
 * the order of the primitives, so the image is the same on every run.
 */
class VoxelizationPass : public LegolizationPass
{
public:
    /** @param slab the number of the slab.
     * @param picture the picture of ProjectionPass; null for an addressed target. */
    VoxelizationPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan, std::size_t slab,
                     osg::Texture2D& voxelImage, osg::Texture2D* picture);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const VoxelizationPass*>(object) != nullptr;
    }
    const char* className() const override { return "VoxelizationPass"; }

protected:
    std::string run(osg::State& state, Legolization& work) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.voxelization; }

private:
    void drawPoints(osg::State& state, const Legolization& work) const;
    void drawPicture(osg::State& state, const Legolization& work) const;

    PassPlan _plan;
    std::size_t _slab;
};

} // namespace osgLego
