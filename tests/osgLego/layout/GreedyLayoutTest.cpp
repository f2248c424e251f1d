#include "LaidMap.h"

#include <Layouts.h>

#include <osgLego/layout/GreedyLayout.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <oneapi/tbb/task_group.h>

namespace osgLego
{

namespace
{

LaidParts lay(const LayoutProblem& problem)
{
    LaidMap laid(problem);
    layGreedily(laid.map, laid.sizes);
    return laid.getParts();
}

/** Layers of cells of one colour. */
LayoutProblem makeBox(std::size_t width, std::size_t depth, std::size_t height)
{
    return drawProblem({height, std::vector<std::string>(depth, std::string(width, 'a'))});
}

TEST(GreedyLayout, TurnsLongPartsInEveryOtherLayer)
{
    EXPECT_EQ(lay(makeBox(8, 8, 3)), (LaidParts{{{0, 0, 0}, {2, 8, 1}, 0},
                                                {{2, 0, 0}, {2, 8, 1}, 0},
                                                {{4, 0, 0}, {2, 8, 1}, 0},
                                                {{6, 0, 0}, {2, 8, 1}, 0},
                                                {{0, 0, 1}, {8, 2, 1}, 0},
                                                {{0, 2, 1}, {8, 2, 1}, 0},
                                                {{0, 4, 1}, {8, 2, 1}, 0},
                                                {{0, 6, 1}, {8, 2, 1}, 0},
                                                {{0, 0, 2}, {2, 8, 1}, 0},
                                                {{2, 0, 2}, {2, 8, 1}, 0},
                                                {{4, 0, 2}, {2, 8, 1}, 0},
                                                {{6, 0, 2}, {2, 8, 1}, 0}}));
}

TEST(GreedyLayout, LaysLargePartsInEitherDirectionAndThenSmallerOnes)
{
    EXPECT_EQ(lay(makeBox(8, 2, 1)), (LaidParts{{{0, 0, 0}, {8, 2, 1}, 0}}));
    EXPECT_EQ(lay(makeBox(5, 1, 1)), (LaidParts{{{0, 0, 0}, {4, 1, 1}, 0}, {{4, 0, 0}, {1, 1, 1}, 0}}));
}

TEST(GreedyLayout, CoversAllCellsEvenIfItsTaskIsCancelled)
{
    const LayoutProblem box = makeBox(8, 8, 3);
    LaidParts parts;
    oneapi::tbb::task_group group;
    group.run_and_wait(
        [&]
        {
            group.cancel();
            parts = lay(box);
        });
    EXPECT_EQ(parts, lay(box));
}

TEST(GreedyLayout, PrefersWideParts)
{
    EXPECT_EQ(lay(drawProblem({{"aaaa", "aa.."}})), (LaidParts{{{0, 0, 0}, {2, 2, 1}, 0}, {{2, 0, 0}, {2, 1, 1}, 0}}));
}

/** Lays parts greedily in a plain way. */
struct PlainGreedyLayout : LaidMap
{
    using LaidMap::LaidMap;

    void layAll(int firstLayer)
    {
        if (sizes.getHeights().size() > 1)
            for (int z = firstLayer; z < problem.size.z; z += 3)
                layLayer(z, 3);
        for (int z = 0; z < problem.size.z; ++z)
            layLayer(z, 1);
    }

private:
    void layLayer(int z, int height)
    {
        constexpr std::array<std::array<int, 2>, 11> SIZES{
            {{2, 8}, {2, 6}, {2, 4}, {1, 8}, {2, 3}, {1, 6}, {2, 2}, {1, 4}, {1, 3}, {1, 2}, {1, 1}}};
        const bool isAlongX = z / height % 2 == 1;
        for (const auto& [shorter, longer] : SIZES)
            for (const bool isLongAlongX : {isAlongX, !isAlongX})
                for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
                    if (lattice.getZ(cell) == z)
                        tryAt(cell, {static_cast<std::uint8_t>(isLongAlongX ? longer : shorter),
                                     static_cast<std::uint8_t>(isLongAlongX ? shorter : longer),
                                     static_cast<std::uint8_t>(height)});
    }

    void tryAt(CellLattice::Index cell, const PartShape& shape)
    {
        std::uint16_t color = LayoutCell::ANY_COLOR;
        std::set<CellLattice::Index> cells;
        for (int z = 0; z < shape.height; ++z)
            for (int y = 0; y < shape.depth; ++y)
                for (int x = 0; x < shape.width; ++x)
                {
                    const CellLattice::Index column = lattice.move(cell, CellLattice::ABOVE, z);
                    const CellLattice::Index row = lattice.move(column, CellLattice::NORTH, y);
                    const CellLattice::Index covered = lattice.move(row, CellLattice::EAST, x);
                    if (covered == CellLattice::NONE || map.getAnchor(covered) != CellLattice::NONE) return;
                    const auto joint = PartSizes::join(color, lattice.getColor(covered));
                    if (!joint) return;
                    color = *joint;
                    cells.insert(covered);
                }
        if (sizes.isAllowed(shape, color) && (shape.height == 1 || !isolates(cells, color))) map.lay(cell, shape);
    }

    /** Whether a brick of these cells would touch no part, although there are cells beside it of its colour. */
    bool isolates(const std::set<CellLattice::Index>& cells, std::uint16_t color) const
    {
        bool isBesideOthers = false;
        for (const CellLattice::Index cell : cells)
            for (int side = 0; side < 6; ++side)
            {
                const CellLattice::Index other = lattice.getNeighbor(cell, static_cast<CellLattice::Side>(side));
                if (other == CellLattice::NONE || cells.contains(other)) continue;
                if (side >= CellLattice::ABOVE) return false;
                if (PartSizes::join(color, lattice.getColor(other))) isBesideOthers = true;
            }
        return isBesideOthers;
    }
};

TEST(GreedyLayout, LaysTheLargestPartThatFitsInEachPlace)
{
    for (unsigned int seed = 0; seed < 30; ++seed)
    {
        LayoutProblem problem = createRandomProblem({14, 12, 7}, seed % 3 == 0 ? "aaaaaaaaaa.*" : "aaaaaaab*", seed);
        problem.isOfPlates = seed % 2 == 1;
        LaidParts fewest;
        for (int firstLayer = 0; firstLayer < 3; ++firstLayer)
        {
            PlainGreedyLayout laid(problem);
            laid.layAll(firstLayer);
            const LaidParts parts = laid.getParts();
            if (firstLayer == 0 || parts.size() < fewest.size()) fewest = parts;
        }
        EXPECT_EQ(lay(problem), fewest) << "model " << seed;
    }
}

TEST(GreedyLayout, LaysBricksAtTheHeightsThatNeedTheFewestParts)
{
    for (std::size_t first = 0; first < 3; ++first)
    {
        std::vector<std::vector<std::string>> layers(first, {"a..."});
        layers.resize(first + 3, {"aaaa", "aaaa"});
        LayoutProblem problem = drawProblem(layers);
        problem.isOfPlates = true;
        const LaidParts parts = lay(problem);
        ASSERT_EQ(parts.size(), first + 1);
        EXPECT_EQ(parts.back(), (LaidPart{{0, 0, static_cast<std::uint16_t>(first)}, {4, 2, 3}, 0}));
    }
}

/** The heights of the parts of a layout of plates. @param rows those of each of three equal layers. */
std::multiset<int> layThreeLayers(const std::vector<std::string>& rows)
{
    LayoutProblem problem = drawProblem({3, rows});
    problem.isOfPlates = true;
    std::multiset<int> heights;
    for (const LaidPart& part : lay(problem))
        heights.insert(part.size[2]);
    return heights;
}

TEST(GreedyLayout, LaysNoBrickThatTouchesNoPartIfPlatesMayReachOthers)
{
    EXPECT_EQ(layThreeLayers({"aaaaaaaaaa"}).count(3), 0u);
    EXPECT_EQ(layThreeLayers({"aaaa", "aaaa"}), (std::multiset<int>{3})) << "cells of one brick";
    EXPECT_EQ(layThreeLayers({"aabb"}), (std::multiset<int>{3, 3})) << "no part covers both colours";
    EXPECT_EQ(layThreeLayers({"aa*bb"}).count(3), 1u) << "a colour that the cell in the middle does not take";
    LayoutProblem table = drawProblem({{"a........."}, {"aaaaaaaaaa"}, {"aaaaaaaaaa"}, {"aaaaaaaaaa"}});
    table.isOfPlates = true;
    const LaidParts parts = lay(table);
    EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [](const LaidPart& part) { return part.size[2] == 3; }))
        << "a brick on the leg, which touches it";
}

} // namespace

} // namespace osgLego
