#include <osgLego/passes/PassPlan.h>

#include <cmath>

namespace osgLego
{

namespace
{

/** The size of a dominant colour and of its depth. */
constexpr int DOMINANT_BYTES = 8;

/** The largest number of cells that a triangle meets if its edges have at most `edgeLimit` cells: along each axis it
 * spans that many cells, rounded up, and one more. */
int cellsMetAtMost(double edgeLimit)
{
    const int along = static_cast<int>(std::ceil(edgeLimit)) + 1;
    return along * along * along;
}

/** Whether sums need single precision. Rounding errors of half floats add up where a cell meets many fine triangles: in
 * dense sources, beside which such sums take little memory, and with a low edge limit. The sums must fit into one slab.
 */
VoxelFormat chooseFormat(const LegoSource& source)
{
    constexpr std::size_t CELLS_PER_TRIANGLE = 16;
    constexpr double LOWEST_EDGE_LIMIT = 2.0; // the default of exact voxelization
    if (source.settings.voxelization.method == VoxelizationMethod::POINTS) return VoxelFormat::COLOR;
    const std::size_t numCells = source.triangles->getGrid().getNumCells();
    const bool isDense = numCells < CELLS_PER_TRIANGLE * source.triangles->getNumTriangles() ||
                         source.settings.getEdgeLimit() < LOWEST_EDGE_LIMIT;
    const int cellBytes = bytesOf(VoxelFormat::FLOAT_SUMS) + (source.lookup.hasPalette() ? DOMINANT_BYTES : 0);
    const bool isOneSlab = numCells <= static_cast<std::size_t>(SlabPlan::MAXIMUM_BYTES / cellBytes);
    return isDense && isOneSlab ? VoxelFormat::FLOAT_SUMS : VoxelFormat::HALF_SUMS;
}

} // namespace

PassPlan PassPlan::create(const LegoSource& source)
{
    PassPlan plan;
    const LegoSettings& settings = source.settings;
    plan.method = settings.voxelization.method;
    plan.target = settings.getTarget();
    if (plan.target == VoxelizationTarget::PROJECTED)
        plan.pictureSize = static_cast<int>(settings.voxelization.fboSize);
    if (plan.method == VoxelizationMethod::EXACT) plan.cellsPerTriangle = cellsMetAtMost(settings.getEdgeLimit());
    plan.format = chooseFormat(source);
    plan.hasPalette = source.lookup.hasPalette();
    const SlabPlan slabs = plan.createSlabs(source.triangles->getGrid());
    plan.imageSize = slabs.imageSize;
    plan.numSlabs = slabs.slabs.size();
    return plan;
}

/** The size of a cell in all images together. */
int PassPlan::getCellBytes() const
{
    return bytesOf(format) + (findsDominantColors() ? DOMINANT_BYTES : 0);
}

std::string PassPlan::findObstacle(const LegoSource& source)
{
    const std::size_t numCells = source.triangles->getGrid().getNumCells();
    if (source.settings.getTarget() != VoxelizationTarget::PROJECTED || numCells <= MAXIMUM_PROJECTED_CELLS) return {};
    return "a projected target holds at most 16777216 cells (256 x 256 x 256), and this grid has " +
           std::to_string(numCells) + "; expected a lower resolution, or target=addressed";
}

} // namespace osgLego
