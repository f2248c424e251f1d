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

TEST(LayoutCosts, APartThatHangsOnASingleOneCostsMoreInShells)
{
    EXPECT_EQ(LayoutCosts::getLeaf(makeProblem(100, 0)), 2000);
    EXPECT_EQ(LayoutCosts::getLeaf(makeProblem(100, 1)), 9000);
    EXPECT_EQ(LayoutCosts::getLeaf(makeProblem(100, 49)), 9000);
    EXPECT_EQ(LayoutCosts::getLeaf(makeProblem(100, 50)), 2000);
}

} // namespace

} // namespace osgLego
