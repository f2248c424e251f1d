#include <osgLego/PassPlan.h>

#include <cmath>

namespace osgLego
{

namespace
{

/** A triangle with edges of at most `edgeLimit` reaches across so many cells of an axis, and one more. */
int cellsMetAtMost(double edgeLimit)
{
    const int along = static_cast<int>(std::ceil(edgeLimit)) + 1;
    return along * along * along;
}

} // namespace

PassPlan PassPlan::create(const LegoSource& source)
{
    const LegoSettings& settings = source.settings;
    const SlabPlan slabs = SlabPlan::create(source.triangles->getGrid());
    PassPlan plan;
    plan.method = settings.method;
    plan.target = settings.getTarget();
    if (plan.target == VoxelizationTarget::PROJECTED) plan.pictureSize = static_cast<int>(settings.fboSize);
    if (plan.method == VoxelizationMethod::EXACT) plan.cellsPerTriangle = cellsMetAtMost(settings.getEdgeLimit());
    plan.imageSize = slabs.imageSize;
    plan.numSlabs = slabs.slabs.size();
    return plan;
}

} // namespace osgLego
