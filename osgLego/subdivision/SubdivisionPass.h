#pragma once

#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

namespace osgLego
{

/** The first pass: uploads a source and cuts its triangles until no edge exceeds the limit (the paper, section III-A,
 * Algorithms 1 and 2, Figure 3).
 *
 * It uses two vertex buffers in ping-pong: each pass reads one and captures into the other by transform feedback, until
 * a pass outputs as many triangles as it reads. The counts of several passes are read back together, after the last of
 * them; the triangles themselves never leave the GPU. If a buffer is too small, it is enlarged and the batch restarted,
 * so that no triangle is lost.
 */
class SubdivisionPass : public LegolizationPass
{
public:
    SubdivisionPass(PassWorkspace& workspace, const PassPlan& plan);

    bool isSameKindAs(const osg::Object* object) const override
    {
        return dynamic_cast<const SubdivisionPass*>(object) != nullptr;
    }
    const char* className() const override { return "SubdivisionPass"; }

protected:
    bool begin(osg::State& state, PassContext& context) const override;
    std::string run(osg::State& state, Legolization& work) const override;
    double& getTime(LegoStatistics& statistics) const override { return statistics.subdivision; }

private:
    PassPlan _plan;
};

} // namespace osgLego
