#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/Stability.h>
#include <osgLego/stability/LargeComponent.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A block of bricks 2 x 4, with their long sides along x and y in alternate layers, in a running bond. */
void addBlock(std::vector<Part>& bricks, const glm::ivec3& low, const glm::ivec3& size)
{
    for (int z = 0; z < size.z; ++z)
    {
        const int along = z % 2;
        const int start = z % 4 < 2 ? 0 : -2;
        for (int row = 0; row < size[1 - along]; row += 2)
            for (int place = start; place < size[along]; place += 4)
            {
                glm::ivec3 from(row, row, z);
                glm::ivec2 extent(2, 2);
                from[along] = std::max(place, 0);
                extent[along] = std::min(place + 4, size[along]) - from[along];
                bricks.push_back(createBrick(low + from, extent.x, extent.y));
            }
    }
}

/** A solid block of some 10,000 bricks. @param overhang how far a slab on it reaches beyond it, in studs. */
osg::ref_ptr<const BrickModel> createSolid(int overhang)
{
    std::vector<Part> bricks;
    addBlock(bricks, {0, 0, 0}, {48, 48, 36});
    if (overhang > 0) addBlock(bricks, {0, 0, 36}, {48 + overhang, 48, 4});
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, 1.2};
    grid.dimensions = {400, 64, 64};
    return BrickModel::createOfParts(grid, std::move(bricks));
}

struct Component
{
    explicit Component(const BrickModel& model) :
        boxes(findPartBoxes(model)), parts(boxes.size()), contacts(findContacts(model))
    {
        std::iota(parts.begin(), parts.end(), 0u);
        for (const std::uint32_t part : parts)
            if (boxes[part].low.z == 0) contacts.push_back({Contact::BASE, part, Contact::TABLE});
    }

    std::optional<ComponentStability> solve(const std::function<bool()>& isCancelled = {}) const
    {
        return solveLargeComponent(boxes, parts, contacts, isCancelled);
    }

    std::vector<PartBox> boxes;
    std::vector<std::uint32_t> parts;
    std::vector<Contact> contacts;
};

TEST(LargeComponent, ThatStandsHasABoundOfItsTension)
{
    const Component solid(*createSolid(8));
    ASSERT_GT(solid.parts.size(), 10'000u);
    const std::optional<ComponentStability> result = solid.solve();
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->isKnown);
    EXPECT_TRUE(result->falling.empty());
    EXPECT_GT(result->tension, ComponentStability::TENSION_TOLERANCE);
    EXPECT_LE(result->tension, StabilityReport::SAFE_CAPACITY);
    EXPECT_TRUE(result->isTensionBound);
    ASSERT_EQ(result->loads.size(), solid.parts.size());
    EXPECT_NEAR(*std::max_element(result->loads.begin(), result->loads.end()),
                result->tension / StabilityReport::CAPACITY, 1e-6);
    // The weakest joint is one of those that bear most.
    ASSERT_TRUE(result->weakest);
    EXPECT_NEAR(result->loads[result->weakest->upper], result->tension / StabilityReport::CAPACITY, 1e-6);
}

TEST(LargeComponent, ThatFallsHasGroupsThatFall)
{
    const StabilityReport report = *computeStability(*createSolid(240));
    EXPECT_TRUE(report.falls());
    EXPECT_EQ(report.margin, -1.0);
    EXPECT_TRUE(report.isMarginBound);
    for (const std::uint32_t part : report.falling)
        EXPECT_EQ(report.loads[part], 1.0f);
}

TEST(LargeComponent, EndsSoonWheneverItIsCancelled)
{
    const Component solid(*createSolid(0));
    for (const int last : {1, 2, 30, 100})
    {
        int numCalls = 0;
        EXPECT_FALSE(solid.solve([&] { return ++numCalls >= last; })) << last;
        EXPECT_LT(numCalls, last + 5);
    }
}

TEST(FallOfGroups, MeansThatPartsFallByClp)
{
    int numFalling = 0;
    int numFound = 0;
    for (unsigned int seed = 1; seed <= 120; ++seed)
    {
        const osg::ref_ptr<const BrickModel> tower = createRandomTower(seed, 10 + static_cast<int>(seed) % 30);
        const Component component(*tower);
        const std::optional<double> tension = computePlainTension(*tower, BuildingBase::TABLE);
        const bool falls = !tension || *tension > StabilityReport::CAPACITY;
        const std::optional<ComponentStability> fall =
            findFallOfGroups(component.boxes, component.parts, component.contacts, {4, 4, 6}, {});
        numFalling += falls;
        numFound += fall.has_value();
        if (!fall) continue;
        EXPECT_TRUE(falls) << seed;
        EXPECT_FALSE(fall->falling.empty()) << seed;
        EXPECT_TRUE(std::isinf(fall->tension));
        EXPECT_TRUE(fall->isTensionBound);
        ASSERT_EQ(fall->loads.size(), component.parts.size());
        EXPECT_TRUE(std::isnan(fall->loads[0]));
        EXPECT_EQ(fall->bodies.size(), component.parts.size());
    }
    EXPECT_GT(numFound, 5);
    EXPECT_GT(3 * numFound, numFalling);
}

TEST(LargeComponent, ThatIsSmallIsLeftToItsLinearProgram)
{
    std::vector<Part> bricks;
    addBlock(bricks, {0, 0, 0}, {16, 16, 8});
    EXPECT_FALSE(Component(*createPartModel(bricks)).solve());
}

} // namespace

} // namespace osgLego::test
