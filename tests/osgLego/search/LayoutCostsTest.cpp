#include <osgLego/search/LayoutCosts.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Some cells, the first of which are interior. */
LayoutProblem makeProblem(std::size_t numCells, std::size_t numInside)
{
    LayoutProblem problem;
    problem.cells.resize(numCells);
    for (std::size_t cell = numInside; cell < numCells; ++cell)
        problem.cells[cell].color = 0;
    return problem;
}

TEST(LayoutCosts, HalfAStackedSeamCostsLessInSmallSolidModels)
{
    EXPECT_EQ(LayoutCosts::getHalfSeam(makeProblem(995, 200)), 500);
    EXPECT_EQ(LayoutCosts::getHalfSeam(makeProblem(995, 199)), 1000);
    EXPECT_EQ(LayoutCosts::getHalfSeam(makeProblem(999, 999)), 500);
    EXPECT_EQ(LayoutCosts::getHalfSeam(makeProblem(1000, 999)), 1000);
}

TEST(LayoutCosts, APartThatHangsOnASingleOneCostsMoreInHollowShells)
{
    const auto getLeaf = [](std::size_t numInside, bool isHollow)
    {
        LayoutProblem problem = makeProblem(100, numInside);
        problem.isHollow = isHollow;
        return LayoutCosts::getLeaf(problem);
    };
    EXPECT_EQ(getLeaf(0, true), 2000);
    EXPECT_EQ(getLeaf(1, true), 9000);
    EXPECT_EQ(getLeaf(49, true), 9000);
    EXPECT_EQ(getLeaf(50, true), 2000);
    for (const std::size_t numInside : {0, 1, 49, 50})
        EXPECT_EQ(getLeaf(numInside, false), 2000);
}

} // namespace

} // namespace osgLego
