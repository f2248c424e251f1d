#include <osgLego/flattening/KeptLattice.h>

#include <Settings.h>

#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

BrickGrid fitTo(KeptLattice& lattice, const osg::BoundingBoxd& bounds, const std::string& settings)
{
    return BrickGrid::fit(bounds, lattice.apply(bounds, parseSettings(settings)));
}

/** Whether the cells of two grids belong to one lattice. */
void expectOneLattice(const BrickGrid& a, const BrickGrid& b)
{
    EXPECT_EQ(a.cellSize, b.cellSize);
    const glm::dvec3 steps = (a.origin - b.origin) / a.cellSize;
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(steps[axis], std::round(steps[axis]), 1e-9);
}

TEST(KeptLattice, TheFirstGridHasTheResolutionAndIsExtendedByWholeCells)
{
    for (const std::string shape : {"", ",proportions=brick", ",proportions=plate,up=y"})
    {
        KeptLattice lattice;
        const osg::BoundingBoxd bounds(1, 2, 3, 5, 6, 7);
        const BrickGrid fitted = BrickGrid::fit(bounds, parseSettings("8" + shape));
        const BrickGrid first = fitTo(lattice, bounds, "8,anchor=first" + shape);
        EXPECT_EQ(first.dimensions, fitted.dimensions) << shape;
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(first.origin[axis], fitted.origin[axis], 0.01);
        const BrickGrid larger = fitTo(lattice, {-1, 2, 3, 5, 9, 7.1}, "8,anchor=first" + shape);
        expectOneLattice(larger, first);
        EXPECT_LT(larger.origin.x, -0.99);
        EXPECT_GT(larger.dimensions.y, first.dimensions.y);
    }
}

TEST(KeptLattice, CellsAreMultiplesFromTheOriginOfTheModelOrTheWorld)
{
    for (const std::string anchor : {"model", "world"})
    {
        KeptLattice lattice;
        const BrickGrid first = fitTo(lattice, {0.3, 0.3, 0.3, 4.3, 2.3, 1.3}, "8,anchor=" + anchor);
        EXPECT_EQ(first.cellSize, glm::dvec3(0.5));
        EXPECT_EQ(first.origin, glm::dvec3(0.0));
        EXPECT_EQ(first.dimensions, glm::ivec3(9, 5, 3));
        const BrickGrid later = fitTo(lattice, {-7.1, 0.3, 0.3, 4.3, 2.3, 1.3}, "8,anchor=" + anchor);
        EXPECT_EQ(later.cellSize, first.cellSize);
        EXPECT_EQ(later.origin, glm::dvec3(-7.5, 0.0, 0.0));
    }
}

TEST(KeptLattice, SettingsThatGiveOtherBricksForgetTheLattice)
{
    KeptLattice lattice;
    const auto pitchOf = [&](double size, const std::string& settings) {
        return fitTo(lattice, {0, 0, 0, size, size, size}, settings).getPitch();
    };
    EXPECT_EQ(pitchOf(8.0, "8,anchor=model"), 1.0);
    EXPECT_EQ(pitchOf(16.0, "8,anchor=model"), 1.0);
    EXPECT_EQ(pitchOf(16.0, "8,anchor=model,look=plain"), 1.0) << "a setting of the view";
    EXPECT_EQ(pitchOf(16.0, "8,anchor=model,palette=ldraw"), 2.0);
    EXPECT_EQ(pitchOf(32.0, "8,anchor=fit"), 4.0);
    EXPECT_EQ(pitchOf(64.0, "8,anchor=model"), 8.0);
}

TEST(KeptLattice, ASourceThatNoGridCanBeFittedToDeterminesNothing)
{
    KeptLattice lattice;
    EXPECT_EQ(lattice.apply({}, parseSettings("8,anchor=first")), parseSettings("8,anchor=first"));
    EXPECT_EQ(fitTo(lattice, {0, 0, 0, 8, 8, 8}, "8,anchor=model").getPitch(), 1.0);
}

TEST(KeptLattice, ACellAndAnOriginAreUsedAsTheyAre)
{
    KeptLattice lattice;
    const LegoSettings settings = parseSettings("cell=0.5,origin=1:2:3,anchor=world");
    EXPECT_EQ(lattice.apply({0, 0, 0, 8, 8, 8}, settings), settings);
}

} // namespace

} // namespace osgLego::test
