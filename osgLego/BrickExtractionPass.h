#pragma once

#include <osgLego/LegolizationPass.h>
#include <osgLego/PassPlan.h>

#include <osg/Texture2D>

namespace osgLego
{

/** Turns the voxel image of one slab into a point for each brick that can be seen, behind those of the slabs before
 * (the paper's future work: a brick with six neighbours is left out, and the others know which of theirs are empty).
 *
 * A buffer that was too small is made larger, and the slab done again. The pass of the last slab finishes the
 * legolization.
 */
class BrickExtractionPass : public LegolizationPass
{
public:
    BrickExtractionPass(BrickStore& store, unsigned int step, const PassPlan& plan, std::size_t slab,
                        osg::Texture2D& voxelImage);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const BrickExtractionPass*>(object) != nullptr;
    }
    const char* className() const override { return "BrickExtractionPass"; }

protected:
    std::string run(osg::State& state, ContextBricks& bricks) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.extraction; }

private:
    PassPlan _plan;
    std::size_t _slab;
};

} // namespace osgLego
