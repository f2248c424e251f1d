#pragma once

#include <osgLego/extraction/ExtractionStates.h>
#include <osgLego/gl/TransformFeedback.h>
#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

namespace osgLego
{

/** Converts the voxel image of one slab to points, one for each visible brick, and appends them to those of the
 * previous slabs (the paper's future work: bricks with six neighbours are omitted, the others store their open sides).
 *
 * It examines only cells that are marked in the occupancy: for each block, its non-empty words, and for each of these,
 * its covered cells. So the bricks of a block are consecutive. The CPU never reads back the number of words.
 *
 * If the buffer is too small, it is enlarged and the bricks are captured again. The pass of the last slab completes the
 * legolization. If the grid is one slab, it also finds the neighbours of bricks (BrickNeighbors) if they are wanted;
 * the bricks of more slabs are read for that, after the legolization.
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
    std::string findNeighbors(osg::State& state, Legolization& work, const Slab& slab) const;

    PassPlan _plan;
    std::size_t _slab;
    osg::ref_ptr<const ExtractionStates> _states;
};

} // namespace osgLego
