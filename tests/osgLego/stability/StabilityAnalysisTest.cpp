#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/Stability.h>
#include <osgLego/stability/StabilityAnalysis.h>

#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(StabilityAnalysis, SubsetsStandOnTheirOwnLowestLayer)
{
    // A column of three bricks with a beam on top, and a brick beside the third one.
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 2, 2), createBrick({0, 0, 1}, 2, 2), createBrick({0, 0, 2}, 2, 2),
                         createBrick({0, 0, 3}, 8, 1), createBrick({2, 0, 2}, 2, 2)});
    StabilityAnalysis analysis(*model, BuildingBase::PLATE);
    const auto solve = [&](const std::vector<std::uint32_t>& parts) { return *analysis.solve(parts); };
    EXPECT_TRUE(solve({0}).stands);
    EXPECT_EQ(solve({0, 2}).falling, (std::vector<std::uint32_t>{2}));
    EXPECT_TRUE(solve({2, 0, 1}).stands);
    const StabilityReport whole = solve({0, 1, 2, 3, 4});
    EXPECT_NEAR(whole.margin, computeStability(*model, {BuildingBase::PLATE, {}})->margin, 1e-9);
    const StabilityReport upper = solve({4, 2});
    EXPECT_TRUE(upper.stands);
    EXPECT_EQ(upper.loads.size(), model->getParts().size());
    EXPECT_EQ(upper.loads[0], 0.0f);
    // Results that are kept between calls don't change them.
    EXPECT_NEAR(solve({0, 1, 2, 3, 4}).margin, whole.margin, 1e-9);
    EXPECT_NEAR(upper.margin, StabilityAnalysis(*model, BuildingBase::PLATE).solve(std::vector{2u, 4u})->margin, 1e-9);
    EXPECT_TRUE(solve({}).stands);
}

std::vector<std::uint32_t> numberParts(const BrickModel& model)
{
    std::vector<std::uint32_t> parts(model.getParts().size());
    std::iota(parts.begin(), parts.end(), 0u);
    return parts;
}

/** A tower without some of its parts, so that most fall. */
osg::ref_ptr<const BrickModel> createTowerWithGaps(unsigned int seed)
{
    const auto model = createRandomTower(seed, 30);
    std::mt19937 random(seed);
    std::vector<Part> parts;
    for (const Part& part : model->getParts())
        if (random() % 12 != 0) parts.push_back(part);
    return BrickModel::createOfParts(model->getGrid(), parts);
}

TEST(StabilityAnalysis, PartsJoinedToRigidBodiesFallOnlyIfPartsFall)
{
    std::mt19937 random(5);
    int numFalling = 0;
    int numStanding = 0;
    int numUnknown = 0;
    for (unsigned int seed = 1; seed <= 40; ++seed)
    {
        const auto model = createTowerWithGaps(seed);
        const BuildingBase base = seed % 2 == 0 ? BuildingBase::TABLE : BuildingBase::PLATE;
        const std::vector<std::uint32_t> parts = numberParts(*model);
        const std::optional<double> tension = computePlainTension(*model, base);
        const bool stands = tension && *tension <= 0.98;
        StabilityAnalysis analysis(*model, base);
        StabilityAnalysis::RigidBodies bodies = parts;
        const bool areStanding = analysis.findFalling(parts, bodies)->empty();
        EXPECT_TRUE(areStanding || !stands) << seed;
        numUnknown += areStanding && !stands;
        for (const unsigned int numBodies : {20u, 8u, 3u})
        {
            // Any parts may be joined, since that only adds forces between them.
            for (std::uint32_t& body : bodies)
                body = static_cast<std::uint32_t>(random() % numBodies);
            const auto falling = analysis.findFalling(parts, bodies);
            ASSERT_TRUE(falling);
            EXPECT_TRUE(falling->empty() || !stands) << seed << ", " << numBodies;
            ++(falling->empty() ? numStanding : numFalling);
        }
    }
    EXPECT_GT(numFalling, 10);
    EXPECT_GT(numStanding, 10);
    // The solver may not converge for parts that nothing holds.
    EXPECT_LE(numUnknown, 2);
}

TEST(StabilityAnalysis, PartsFallAsTheBodiesThatMovedAsOneDo)
{
    int numFalling = 0;
    int numAgain = 0;
    for (unsigned int seed = 1; seed <= 40; ++seed)
    {
        const auto model = createTowerWithGaps(seed);
        const std::vector<std::uint32_t> parts = numberParts(*model);
        StabilityAnalysis analysis(*model, BuildingBase::TABLE);
        if (analysis.solve(parts)->stands) continue;
        ++numFalling;
        StabilityAnalysis::RigidBodies bodies = analysis.getBodies();
        if (analysis.findFalling(parts, bodies)->empty()) continue;
        ++numAgain;
        EXPECT_LT(std::set(bodies.begin(), bodies.end()).size(), parts.size() / 2) << seed;
    }
    EXPECT_GT(numFalling, 10);
    EXPECT_GE(numAgain, numFalling - 2); // as above
}

TEST(StabilityAnalysis, ARigidBodyTipsAboutTheEdgeOfItsBase)
{
    // A beam on a brick: its part over the edge is shorter than half of it, or longer.
    for (const int start : {0, 3})
    {
        const auto model = createPartModel({createBrick({3, 0, 0}, 2, 2), createBrick({start, 0, 1}, 8, 2)});
        const std::vector<std::uint32_t> parts{0, 1};
        StabilityAnalysis::RigidBodies bodies{0, 0};
        EXPECT_EQ(StabilityAnalysis(*model, BuildingBase::TABLE).findFalling(parts, bodies)->empty(), start == 0);
    }
}

} // namespace

} // namespace osgLego::test
