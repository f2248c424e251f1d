#include "../layout/LaidMap.h"
#include "../layout/LaidModel.h"

#include <osgLego/search/LayoutRegion.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(LayoutRegion, ContainsAPartIfItContainsAllOfItsCells)
{
    // A single part in a grid of plates, two rows deep and three layers high, and plates of one cell around it.
    constexpr glm::ivec3 SIZE{1, 4, 5};
    constexpr glm::ivec3 LOWER{0, 1, 1};
    constexpr PartShape SHAPE{1, 2, 3};
    const glm::ivec3 upper = LOWER + glm::ivec3(SHAPE.width, SHAPE.depth, SHAPE.height);
    LayoutProblem plates = makeCells(SIZE, [](int, int, int) { return 0; });
    plates.isOfPlates = true;
    LaidMap laid(plates);
    const auto getCell = [&laid](int y, int z) { return laid.lattice.getLayerStart(z) + y; };
    for (int z = 0; z < SIZE.z; ++z)
        for (int y = 0; y < SIZE.y; ++y)
            if (y < LOWER.y || y >= upper.y || z < LOWER.z || z >= upper.z) laid.map.lay(getCell(y, z), {});
    laid.map.lay(getCell(LOWER.y, LOWER.z), SHAPE);
    for (int zBegin = 0; zBegin <= SIZE.z; ++zBegin)
        for (int zEnd = zBegin; zEnd <= SIZE.z; ++zEnd)
            for (int yBegin = 0; yBegin <= SIZE.y; ++yBegin)
                for (int yEnd = yBegin; yEnd <= SIZE.y; ++yEnd)
                {
                    const LayoutRegion region{zBegin, zEnd, yBegin, yEnd, 0, 0, nullptr};
                    bool containsAll = true;
                    laid.map.visitPart(getCell(LOWER.y, LOWER.z), [&](CellLattice::Index cell)
                                       { containsAll = containsAll && region.isReadable(laid.lattice, cell); });
                    EXPECT_EQ(region.contains(laid.map, getCell(LOWER.y, LOWER.z)), containsAll)
                        << "layers " << zBegin << " to " << zEnd << ", rows " << yBegin << " to " << yEnd;
                }
}

} // namespace

} // namespace osgLego
