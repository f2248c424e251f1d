#pragma once

#include <osgLego/passes/LegolizationPass.h>
#include <osgLego/passes/PassPlan.h>

namespace osgLego
{

/** The first pass: uploads a source and cuts its triangles until no edge is beyond the limit (the paper, section III-A,
 * Algorithms 1 and 2, Figure 3).
 *
 * Two vertex buffers in ping-pong: each pass reads one and captures into the other by transform feedback, until a pass
 * makes no more triangles than it was given. The counts of several passes are asked for together, after the last of
 * them; the triangles themselves never leave the GPU. A buffer that was too small is made larger and the batch done
 * again from its start, so that no triangle is lost.
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
