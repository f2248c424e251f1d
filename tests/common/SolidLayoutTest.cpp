#include <common/LayoutBound.h>
#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/layout/LayoutFigures.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr std::array NEIGHBOR_STEPS{glm::ivec3(1, 0, 0),  glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0),
                                    glm::ivec3(0, -1, 0), glm::ivec3(0, 0, 1),  glm::ivec3(0, 0, -1)};

/** A chain of balls five cells wide: a solid model, most of whose cells are at its surface. Those whose neighbours all
 * exist have any colour. */
class BallChain
{
public:
    explicit BallChain(std::uint32_t seed)
    {
        std::mt19937 random(seed);
        const auto choose = [&] { return static_cast<int>(random() % 9) - 4; };
        glm::ivec3 center(8, 8, 8);
        for (int i = 0; i < NUM_BALLS; ++i)
        {
            _centers.push_back(center);
            const int x = choose();
            const int y = choose();
            const glm::ivec3 step(x, y, choose());
            center = glm::clamp(center + step, 4, SIZE - 5);
        }
    }

    LayoutProblem makeSolid() const
    {
        LayoutProblem problem;
        problem.size = glm::ivec3(SIZE);
        problem.colors.resize(1);
        for (int z = 0; z < problem.size.z; ++z)
            for (int y = 0; y < problem.size.y; ++y)
                for (int x = 0; x < problem.size.x; ++x)
                    if (contain({x, y, z}))
                        problem.cells.push_back({{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                                  static_cast<std::uint16_t>(z)},
                                                 findColor({x, y, z})});
        return problem;
    }

private:
    static constexpr int SIZE = 17;
    static constexpr int NUM_BALLS = 10;
    static constexpr int SQUARED_RADIUS = 6;

    bool contain(const glm::ivec3& cell) const
    {
        const auto isNear = [&](const glm::ivec3& center)
        {
            const glm::ivec3 offset = cell - center;
            return offset.x * offset.x + offset.y * offset.y + offset.z * offset.z <= SQUARED_RADIUS;
        };
        return std::any_of(_centers.begin(), _centers.end(), isNear);
    }

    std::uint16_t findColor(const glm::ivec3& cell) const
    {
        const bool isInside = std::all_of(NEIGHBOR_STEPS.begin(), NEIGHBOR_STEPS.end(),
                                          [&](const glm::ivec3& step) { return contain(cell + step); });
        return isInside ? LayoutCell::ANY_COLOR : std::uint16_t{0};
    }

    std::vector<glm::ivec3> _centers;
};

constexpr std::uint32_t NUM_MODELS = 5;

LayoutFigures lay(const LayoutProblem& problem, Effort effort)
{
    LayoutOptions options;
    options.effort = effort;
    const LaidParts parts = layOut(problem, options);
    EXPECT_EQ(findLayoutError(problem, parts), "");
    return computeLayoutFigures(problem, parts);
}

std::size_t computeBound(const LayoutProblem& problem)
{
    std::size_t sum = 0;
    for (const LayerBound& layer : boundLayers(problem, {}, {}))
        sum += layer.parts;
    return sum;
}

} // namespace

TEST(SolidLayout, HasAtMostThreePercentMorePartsThanItsLayersNeedAndNoMoreThanWithNormalEffort)
{
    for (std::uint32_t seed = 0; seed < NUM_MODELS; ++seed)
    {
        const LayoutProblem problem = BallChain(seed).makeSolid();
        const std::size_t bound = computeBound(problem);
        const LayoutFigures best = lay(problem, Effort::BEST);
        const LayoutFigures normal = lay(problem, Effort::NORMAL);
        EXPECT_GE(best.parts, bound);
        EXPECT_LE(static_cast<double>(best.parts), 1.03 * static_cast<double>(bound)) << seed << ": " << bound;
        EXPECT_LE(best.parts, normal.parts) << seed;
        EXPECT_LE(best.components, normal.components) << seed;
    }
}

} // namespace osgLego
