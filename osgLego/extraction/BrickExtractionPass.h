#pragma once

#include <osgLego/extraction/ExtractionStates.h>
#include <osgLego/gl/TransformFeedback.h>
#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

namespace osgLego
{

/** Turns the voxel image of one slab into a point for each brick that can be seen, behind those of the slabs before
 * (the paper's future work: a brick with six neighbours is left out, and the others know which of theirs are empty).
 *
 * Only places that voxelization marked in the occupancy are looked at: blocks of cells, then those of their words that
 * are not empty, then the covered cells in these. So the bricks of a block follow each other. How many words there are
 * the CPU never asks.
 *
 * A buffer that was too small is made larger, and the bricks captured again. The pass of the last slab finishes the
 * legolization.
 */
class BrickExtractionPass : public LegolizationPass
{
public:
    BrickExtractionPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan, std::size_t slab,
                        const ExtractionStates& states);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const BrickExtractionPass*>(object) != nullptr;
    }
    const char* className() const override { return "BrickExtractionPass"; }

    void releaseGLObjects(osg::State* state = nullptr) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;

protected:
    std::string run(osg::State& state, Legolization& work) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.extraction; }

private:
    bool apply(osg::State& state, const osg::StateSet& stateSet, const BrickGrid& grid, const Slab& slab) const;
    std::string capture(osg::State& state, Legolization& work, const TransformFeedback& words) const;

    PassPlan _plan;
    std::size_t _slab;
    osg::ref_ptr<const ExtractionStates> _states;
};

} // namespace osgLego
