#include <osgLego/passes/PassPlan.h>

#include <cmath>

namespace osgLego
{

namespace
{

/** The largest number of cells that a triangle meets if its edges have at most `edgeLimit` cells: along each axis it
 * spans that many cells, rounded up, and one more. */
int cellsMetAtMost(double edgeLimit)
{
    const int along = static_cast<int>(std::ceil(edgeLimit)) + 1;
    return along * along * along;
}

} // namespace

PassPlan PassPlan::create(const LegoSource& source)
{
    PassPlan plan;
    const LegoSettings& settings = source.settings;
    const SlabPlan slabs = SlabPlan::create(source.triangles->getGrid());
    plan.method = settings.method;
    plan.target = settings.getTarget();
    if (plan.target == VoxelizationTarget::PROJECTED) plan.pictureSize = static_cast<int>(settings.fboSize);
    if (plan.method == VoxelizationMethod::EXACT) plan.cellsPerTriangle = cellsMetAtMost(settings.getEdgeLimit());
    plan.imageSize = slabs.imageSize;
    plan.numSlabs = slabs.slabs.size();
    return plan;
}

std::string PassPlan::findObstacle(const LegoSource& source)
{
    const std::size_t numCells = source.triangles->getGrid().getNumCells();
    if (source.settings.getTarget() != VoxelizationTarget::PROJECTED || numCells <= MAXIMUM_PROJECTED_CELLS) return {};
    return "a projected target holds at most 16777216 cells (256 x 256 x 256), and this grid has " +
           std::to_string(numCells) + "; expected a lower resolution, or target=addressed";
}

} // namespace osgLego
