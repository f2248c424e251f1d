#include <common/LayoutBound.h>
#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/layout/LayoutFigures.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr std::array NEIGHBOR_STEPS{glm::ivec3(1, 0, 0),  glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0),
                                    glm::ivec3(0, -1, 0), glm::ivec3(0, 0, 1),  glm::ivec3(0, 0, -1)};

/** Solid models of cells. Cells whose neighbours all exist have any colour. */
class SolidShape
{
public:
    LayoutProblem makeSolid() const
    {
        LayoutProblem problem;
        problem.size = glm::ivec3(SIZE);
        problem.colors.resize(1);
        for (int z = 0; z < problem.size.z; ++z)
            for (int y = 0; y < problem.size.y; ++y)
                for (int x = 0; x < problem.size.x; ++x)
                    if (contains({x, y, z}))
                        problem.cells.push_back({{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                                  static_cast<std::uint16_t>(z)},
                                                 findColor({x, y, z})});
        return problem;
    }

protected:
    static constexpr int SIZE = 17;

    ~SolidShape() = default;
    virtual bool contains(const glm::ivec3& cell) const = 0;

private:
    std::uint16_t findColor(const glm::ivec3& cell) const
    {
        const bool isInside = std::all_of(NEIGHBOR_STEPS.begin(), NEIGHBOR_STEPS.end(),
                                          [&](const glm::ivec3& step) { return contains(cell + step); });
        return isInside ? LayoutCell::ANY_COLOR : std::uint16_t{0};
    }
};

/** A chain of balls five cells wide, most of whose cells are at its surface. */
class BallChain final : public SolidShape
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

private:
    static constexpr int NUM_BALLS = 10;
    static constexpr int SQUARED_RADIUS = 6;

    bool contains(const glm::ivec3& cell) const override
    {
        const auto isNear = [&](const glm::ivec3& center)
        {
            const glm::ivec3 offset = cell - center;
            return offset.x * offset.x + offset.y * offset.y + offset.z * offset.z <= SQUARED_RADIUS;
        };
        return std::any_of(_centers.begin(), _centers.end(), isNear);
    }

    std::vector<glm::ivec3> _centers;
};

/** Ellipsoids of any width from 3 to 13 cells that overlap one another. */
class EllipsoidHeap final : public SolidShape
{
public:
    explicit EllipsoidHeap(std::uint32_t seed)
    {
        std::mt19937 random(seed);
        for (int i = 0; i < NUM_ELLIPSOIDS; ++i)
        {
            Ellipsoid ellipsoid;
            for (int axis = 0; axis < 3; ++axis)
            {
                ellipsoid.radii[axis] = 1.5F + static_cast<float>(random() % 11) / 2.0F;
                ellipsoid.center[axis] = 4.0F + static_cast<float>(random() % (SIZE - 8));
            }
            _ellipsoids.push_back(ellipsoid);
        }
    }

private:
    struct Ellipsoid
    {
        glm::vec3 center;
        glm::vec3 radii;
    };
    static constexpr int NUM_ELLIPSOIDS = 6;

    bool contains(const glm::ivec3& cell) const override
    {
        const bool isInGrid =
            glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, glm::ivec3(SIZE)));
        const auto isInside = [&](const Ellipsoid& ellipsoid)
        {
            const glm::vec3 offset = (glm::vec3(cell) - ellipsoid.center) / ellipsoid.radii;
            return glm::dot(offset, offset) <= 1.0F;
        };
        return isInGrid && std::any_of(_ellipsoids.begin(), _ellipsoids.end(), isInside);
    }

    std::vector<Ellipsoid> _ellipsoids;
};

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
    // The heaps need a low cost of stacked seams.
    const std::array problems{BallChain(0).makeSolid(), BallChain(1).makeSolid(), EllipsoidHeap(13).makeSolid(),
                              EllipsoidHeap(15).makeSolid()};
    for (const LayoutProblem& problem : problems)
    {
        const std::size_t bound = computeBound(problem);
        SCOPED_TRACE(bound);
        const LayoutFigures best = lay(problem, Effort::BEST);
        const LayoutFigures normal = lay(problem, Effort::NORMAL);
        EXPECT_GE(best.parts, bound);
        EXPECT_LE(static_cast<double>(best.parts), 1.03 * static_cast<double>(bound));
        EXPECT_LE(best.parts, normal.parts);
        EXPECT_LE(best.components, normal.components);
    }
}

} // namespace osgLego
