#pragma once

#include <osgLego/passes/LegolizationPass.h>

namespace osgLego
{

/** Brings the bricks that CpuVoxelizationPass found to the GPU, those that can be seen, and finishes the
 * legolization. */
class BrickUploadPass : public LegolizationPass
{
public:
    explicit BrickUploadPass(BrickStore& store);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const BrickUploadPass*>(object) != nullptr;
    }
    const char* className() const override { return "BrickUploadPass"; }

protected:
    bool hasProgram() const override { return false; }
    bool begin(osg::State& state, ContextBricks& bricks) const override;
    std::string run(osg::State& state, ContextBricks& bricks) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.extraction; }
};

} // namespace osgLego
