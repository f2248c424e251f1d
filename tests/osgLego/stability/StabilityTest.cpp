#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <Meshes.h>
#include <Settings.h>

#include <osgLego/CpuLegolizer.h>
#include <osgLego/Stability.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double GRAVITY = 9.8e-3; // newtons per gram
// In grams (StableLego).
constexpr double MASS_1X1 = 0.43;
constexpr double MASS_1X3 = 1.18;
constexpr double MASS_1X8 = 3.03;
constexpr double MASS_2X2 = 1.15;

StabilityReport compute(const osg::ref_ptr<const BrickModel>& model, BuildingBase base = BuildingBase::TABLE)
{
    return *computeStability(*model, {base, {}});
}

// The newtons that a contact point bears (StableLego), and bears even if it is worn (Luo et al. 2015).
constexpr double CAPACITY = 0.98;
constexpr double SAFE_CAPACITY = 0.70;

/** The margin if contact points bear up to `tension` newtons. */
double marginOf(double tension)
{
    return 1.0 - tension / CAPACITY;
}

/** The margin by CLP. */
double marginByClp(const BrickModel& model, BuildingBase base)
{
    const std::optional<double> tension = computePlainTension(model, base);
    return tension ? std::max(-1.0, marginOf(*tension)) : -1.0;
}

TEST(Stability, ALargeModelHasTheMarginThatClpFinds)
{
    const osg::ref_ptr<osg::Node> bunny = readBunny();
    if (!bunny) GTEST_SKIP() << "bunny.ply was not downloaded";
    const osg::ref_ptr<const BrickModel> model =
        legolizeOnCpu(*bunny, parseSettings("34,up=y,parts=bricks,palette=ldraw,colors=1,effort=instant"));
    const StabilityReport report = compute(model);
    EXPECT_TRUE(report.stands);
    EXPECT_TRUE(report.safe);
    EXPECT_TRUE(report.falling.empty());
    EXPECT_FALSE(report.isMarginBound);
    EXPECT_NEAR(report.margin, 0.9646, 1e-6); // by computePlainTension(), in five minutes
}

TEST(Stability, FindsTheExactMarginOfHollowModels)
{
    // Their forces can circulate in rings of neighbours.
    for (const char* seed : {"0", "1", "2"})
    {
        const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(
            *createSphere(),
            parseSettings(std::string("24,parts=bricks,palette=ldraw,colors=1,effort=instant,seed=") + seed));
        const StabilityReport report = compute(model, BuildingBase::PLATE);
        EXPECT_FALSE(report.isMarginBound) << seed;
        EXPECT_TRUE(report.unknown.empty()) << seed;
        EXPECT_GT(report.margin, 0.0) << seed;
    }
}

TEST(Stability, AgreesWithClpOnRandomTowers)
{
    int numStanding = 0;
    int numStrained = 0;
    for (unsigned int seed = 1; seed <= 40; ++seed)
        for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
        {
            const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 4 + static_cast<int>(seed));
            const std::optional<double> tension = computePlainTension(*model, base);
            const StabilityReport report = compute(model, base);
            EXPECT_NEAR(report.margin, tension ? std::max(-1.0, marginOf(*tension)) : -1.0, 1e-6) << seed;
            EXPECT_EQ(report.stands, tension && *tension <= CAPACITY) << seed;
            EXPECT_EQ(report.falling.empty(), report.stands) << seed;
            EXPECT_EQ(report.safe, tension && *tension <= SAFE_CAPACITY && !report.tipsEasily()) << seed;
            numStanding += report.stands;
            numStrained += report.stands && report.margin < 0.99;
        }
    EXPECT_GT(numStanding, 20);
    EXPECT_LT(numStanding, 75);
    EXPECT_GT(numStrained, 10);
}

TEST(Stability, PlatesAgreeWithClp)
{
    int numStrained = 0;
    for (unsigned int seed = 300; seed < 320; ++seed)
    {
        const osg::ref_ptr<const BrickModel> model = createPartModel(createRandomTower(seed, 20)->getParts(), 0.4);
        for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
        {
            const double margin = marginByClp(*model, base);
            EXPECT_NEAR(compute(model, base).margin, margin, 1e-6) << seed;
            numStrained += margin > -1.0 && margin < 0.99;
        }
    }
    EXPECT_GT(numStrained, 5);
}

TEST(Stability, QuarterTurnsMirrorImagesAndOtherUpAxesHaveTheSameMargin)
{
    for (unsigned int seed = 100; seed < 120; ++seed)
    {
        const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 25);
        const double margin = compute(model, BuildingBase::PLATE).margin;
        EXPECT_NEAR(compute(turn(*model), BuildingBase::PLATE).margin, margin, 1e-6) << seed;
        EXPECT_NEAR(compute(mirror(*model), BuildingBase::PLATE).margin, margin, 1e-6) << seed;
        EXPECT_NEAR(compute(tilt(*model), BuildingBase::PLATE).margin, margin, 1e-6) << seed;
    }
}

TEST(Stability, ACantileverIsHeldByThreePointsOfItsStud)
{
    // A brick 1 x 8 with its first stud on a brick 1 x 1. It turns about the point a quarter pitch towards its end. The
    // drag on the other side has a lever of 1/2, and two at the sides of 1/4: weight * (3.5 - 1/4) = tension * (1/2 +
    // 2/4). The column below is held in the same way, and its weight helps.
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 1, 1), createBrick({0, 0, 1}, 8, 1)});
    const StabilityReport report = compute(model, BuildingBase::PLATE);
    EXPECT_NEAR(report.margin, marginOf(GRAVITY * MASS_1X8 * 3.25), 1e-6);
    ASSERT_TRUE(report.weakest);
    EXPECT_EQ(report.weakest->lower, 0u);
    EXPECT_EQ(report.weakest->upper, 1u);
    EXPECT_TRUE(report.safe);
    EXPECT_NEAR(report.loads[1], GRAVITY * MASS_1X8 * 3.25 / CAPACITY, 1e-6);

    const StabilityReport onTable = compute(model, BuildingBase::TABLE);
    EXPECT_FALSE(onTable.stands);
    EXPECT_EQ(onTable.margin, -1.0);
    EXPECT_FALSE(onTable.falling.empty());
}

TEST(Stability, JointsBear098NewtonsAnd070Safely)
{
    struct Load
    {
        int numBricks1x3, numBricks1x1;
        double tension; // weight * lever of all bricks, as for a cantilever: the lever of the pile is 7 - 1/4
        bool stands, safe;
    };
    for (const Load& load : {Load{7, 2, 0.6998, true, true}, Load{7, 3, 0.7282, true, false},
                             Load{8, 9, 0.9770, true, false}, Load{8, 10, 1.0054, false, false}})
    {
        const double tension =
            GRAVITY * (MASS_1X8 * 3.25 + (MASS_1X3 * load.numBricks1x3 + MASS_1X1 * load.numBricks1x1) * 6.75);
        ASSERT_NEAR(tension, load.tension, 1e-4);
        const StabilityReport report =
            compute(createLoadedCantilever(load.numBricks1x3, load.numBricks1x1), BuildingBase::PLATE);
        EXPECT_EQ(report.stands, load.stands) << tension;
        EXPECT_EQ(report.safe, load.safe) << tension;
        EXPECT_NEAR(report.margin, marginOf(tension), 1e-6);
    }
}

/** A tower of bricks that are one stud wide, with their first stud above a brick 1 x 1. */
osg::ref_ptr<const BrickModel> createEccentricTower(int height, int length)
{
    std::vector<Part> parts{createBrick({0, 0, 0}, 1, 1)};
    for (int z = 1; z <= height; ++z)
        parts.push_back(createBrick({0, 0, z}, length, 1));
    return createPartModel(std::move(parts));
}

TEST(Stability, MissingForcesAtLongLeversCountAsMuchAsTension)
{
    // The tower's bricks press on each other, and its weight pulls at the lowest joint: for bricks 1 x 3, with a lever
    // of 1 - 1/4. A force of less than a thousandth of a newton at its top, 150 pitches above the joint, would hold it.
    for (const int height : {112, 126})
    {
        const double tension = GRAVITY * MASS_1X3 * 0.75 * height;
        const StabilityReport report = compute(createEccentricTower(height, 3), BuildingBase::PLATE);
        EXPECT_EQ(report.stands, height == 112);
        EXPECT_NEAR(report.margin, marginOf(tension), 1e-6) << height;
        ASSERT_TRUE(report.weakest) << height;
        EXPECT_EQ(report.weakest->lower, 0u);
        EXPECT_EQ(report.weakest->upper, 1u);
        EXPECT_NEAR(report.loads[1], std::min(tension / CAPACITY, 1.0), 1e-6) << height;
    }
    // Five times the capacity.
    const StabilityReport report = compute(createEccentricTower(100, 6), BuildingBase::PLATE);
    EXPECT_FALSE(report.stands);
    EXPECT_EQ(report.margin, -1.0);
    EXPECT_NEAR(report.loads[1], 1.0f, 1e-6);
    ASSERT_TRUE(report.weakest);
    EXPECT_EQ(report.weakest->lower, 0u);
    EXPECT_EQ(report.weakest->upper, 1u);
}

TEST(Stability, KnowsThatTowersFallForWantOfASmallForceAtALongLever)
{
    for (const int height : {114, 115, 116, 120})
    {
        const StabilityReport report = compute(createEccentricTower(height, 3), BuildingBase::PLATE);
        EXPECT_TRUE(report.unknown.empty()) << height;
        EXPECT_TRUE(report.falls()) << height;
        // The solver misses each force by up to 1e-8 N, at levers of up to the height in bricks.
        EXPECT_NEAR(report.margin, marginOf(GRAVITY * MASS_1X3 * 0.75 * height), 2e-8 * height) << height;
    }
}

TEST(Stability, ArchesBearWhatHangsFromThem)
{
    // A brick 1 x 8 on two columns needs no drag. One 1 x 1 that hangs from its middle is held by the four points of
    // its stud; a second one below it adds its weight.
    std::vector<Part> parts{createBrick({0, 0, 0}, 1, 1), createBrick({7, 0, 0}, 1, 1), createBrick({0, 0, 1}, 1, 1),
                            createBrick({7, 0, 1}, 1, 1), createBrick({0, 0, 2}, 1, 1), createBrick({7, 0, 2}, 1, 1),
                            createBrick({0, 0, 3}, 8, 1)};
    const StabilityReport arch = compute(createPartModel(parts));
    EXPECT_NEAR(arch.margin, 1.0, 1e-6);
    EXPECT_FALSE(arch.weakest);
    parts.push_back(createBrick({3, 0, 2}, 1, 1));
    EXPECT_NEAR(compute(createPartModel(parts)).margin, marginOf(GRAVITY * MASS_1X1 / 4.0), 1e-6);
    parts.push_back(createBrick({3, 0, 1}, 1, 1));
    EXPECT_NEAR(compute(createPartModel(parts)).margin, marginOf(GRAVITY * MASS_1X1 * 2.0 / 4.0), 1e-6);
}

TEST(Stability, FourStudsOfAWidePartHoldAtTwelvePoints)
{
    const std::vector<Part> parts{createBrick({0, 0, 0}, 1, 2), createBrick({5, 0, 0}, 1, 2),
                                  createBrick({0, 0, 1}, 1, 2), createBrick({5, 0, 1}, 1, 2),
                                  createBrick({0, 0, 2}, 6, 2), createBrick({2, 0, 1}, 2, 2)};
    EXPECT_NEAR(compute(createPartModel(parts)).margin, marginOf(GRAVITY * MASS_2X2 / 12.0), 1e-6);
}

TEST(Stability, AStairOf19BricksStandsAndOneOf20Falls)
{
    // As built by StableLego's authors (Figure 1): each brick 2 x 4 overlaps the one below by half.
    for (const int count : {19, 20})
    {
        std::vector<Part> parts;
        for (int z = 0; z < count; ++z)
            parts.push_back(createBrick({2 * z, 0, z}, 4, 2));
        const osg::ref_ptr<const BrickModel> model = createPartModel(std::move(parts));
        const StabilityReport report = compute(model, BuildingBase::PLATE);
        EXPECT_EQ(report.stands, count == 19);
        EXPECT_NEAR(report.margin, marginByClp(*model, BuildingBase::PLATE), 1e-6);
    }
}

TEST(Stability, AddedWeightsActAtTheMiddleOfTheirParts)
{
    // The cantilever of ACantileverIsHeldByThreePointsOfItsStud. Weights on the lower brick do not load its stud.
    constexpr double LEVER = 3.25;
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 1, 1), createBrick({0, 0, 1}, 8, 1)});
    const auto computeWith = [&](std::vector<AddedWeight> weights) {
        return *computeStability(*model, {BuildingBase::PLATE, {}, std::move(weights)});
    };
    EXPECT_NEAR(computeWith({{1, 10.0}}).margin, marginOf(GRAVITY * (MASS_1X8 + 10.0) * LEVER), 1e-6);
    EXPECT_NEAR(computeWith({{1, 10.0}, {0, 500.0}, {1, 5.0}}).margin, marginOf(GRAVITY * (MASS_1X8 + 15.0) * LEVER),
                1e-6);
    EXPECT_TRUE(computeWith({{1, 27.7}}).stands);
    EXPECT_FALSE(computeWith({{1, 27.8}}).stands);
}

TEST(Stability, AgreesWithClpOnRandomTowersWithWeights)
{
    int numStrained = 0;
    int numFallen = 0;
    for (unsigned int seed = 400; seed < 420; ++seed)
        for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
        {
            const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 15);
            const std::vector<AddedWeight> weights{{14, 3.0 * (seed - 399)}, {seed % 15, 20.0}};
            const std::optional<double> tension = computePlainTension(*model, base, weights);
            const StabilityReport report = *computeStability(*model, {base, {}, weights});
            EXPECT_NEAR(report.margin, tension ? std::max(-1.0, marginOf(*tension)) : -1.0, 1e-6) << seed;
            numStrained += report.stands && report.margin < 0.99;
            numFallen += report.falls() && computeStability(*model, {base, {}})->stands;
        }
    EXPECT_GT(numStrained, 3);
    EXPECT_GT(numFallen, 3);
}

TEST(Stability, RejectsWeightsThatAreOnNoPartOrImpossible)
{
    const osg::ref_ptr<const BrickModel> model = createPartModel({createBrick({0, 0, 0}, 2, 2)});
    for (const AddedWeight weight :
         {AddedWeight{1, 5.0}, AddedWeight{0, -1.0}, AddedWeight{0, std::numeric_limits<double>::infinity()}})
        EXPECT_THROW(computeStability(*model, {BuildingBase::TABLE, {}, {weight}}), std::invalid_argument);
}

TEST(Stability, ATallColumnOnATableStandsButNotSafely)
{
    std::vector<Part> parts;
    for (int z = 0; z < 60; ++z)
        parts.push_back(createBrick({3, 4, z}, 1, 1));
    const StabilityReport report = compute(createPartModel(std::move(parts)));
    EXPECT_TRUE(report.stands);
    EXPECT_FALSE(report.safe) << "it tips at a degree";
    EXPECT_NEAR(report.margin, 1.0, 1e-6);
    EXPECT_EQ(report.numComponents, 1u);
}

TEST(Stability, PartsThatNothingConnectsToTheBaseFall)
{
    const osg::ref_ptr<const BrickModel> model =
        createPartModel({createBrick({0, 0, 0}, 2, 2), createBrick({8, 0, 1}, 2, 2), createBrick({2, 0, 0}, 2, 2),
                         createBrick({8, 0, 2}, 4, 2), createBrick({10, 0, 1}, 1, 1)});
    const StabilityReport report = compute(model);
    EXPECT_FALSE(report.stands);
    EXPECT_FALSE(report.safe);
    EXPECT_EQ(report.margin, -1.0);
    EXPECT_EQ(report.falling, (std::vector<std::uint32_t>{2, 3, 4}));
    EXPECT_EQ(report.loads[2], 1.0f);
    EXPECT_EQ(report.loads[0], 0.0f);
    EXPECT_EQ(report.numComponents, 2u);
}

TEST(Stability, APartBesideAnotherIsNotHeldByIt)
{
    const StabilityReport report = compute(
        createPartModel({createBrick({0, 0, 0}, 2, 2), createBrick({0, 0, 1}, 2, 2), createBrick({2, 0, 1}, 2, 2)}));
    EXPECT_EQ(report.falling, (std::vector<std::uint32_t>{2}));
    EXPECT_EQ(report.numComponents, 1u);
}

TEST(Stability, OnePartStandsAndSoDoesNone)
{
    const StabilityReport one = compute(createPartModel({createBrick({0, 0, 5}, 2, 4)}));
    EXPECT_TRUE(one.stands && one.safe);
    EXPECT_NEAR(one.margin, 1.0, 1e-6);
    EXPECT_FALSE(one.weakest);
    const StabilityReport none = compute(createPartModel({}));
    EXPECT_TRUE(none.stands && none.safe);
    EXPECT_EQ(none.margin, 1.0);
    EXPECT_EQ(none.numComponents, 0u);
    EXPECT_TRUE(none.loads.empty());
}

TEST(Stability, TwoCopiesHaveTheMarginOfOne)
{
    for (unsigned int seed = 200; seed < 205; ++seed)
    {
        const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 20);
        std::vector<Part> parts = model->getParts();
        for (const Part& part : model->getParts())
            parts.push_back(createBrick(part.getCell() + glm::ivec3(20, 0, 0), part.size[0], part.size[1]));
        const StabilityReport once = compute(model, BuildingBase::PLATE);
        const StabilityReport twice = compute(createPartModel(std::move(parts)), BuildingBase::PLATE);
        EXPECT_NEAR(twice.margin, once.margin, 1e-6) << seed;
        EXPECT_EQ(twice.numComponents, 2 * once.numComponents) << seed;
        EXPECT_EQ(twice.falling.size(), 2 * once.falling.size()) << seed;
    }
}

TEST(Stability, TheWeakestJointIsThatOfTheWorstPieceEvenIfAnotherPartIsInTheAir)
{
    // Two cantilevers, the second one of which is longer, and a brick that nothing holds.
    const std::vector<Part> parts{createBrick({0, 0, 0}, 1, 1), createBrick({0, 9, 0}, 1, 1),
                                  createBrick({0, 0, 1}, 4, 1), createBrick({0, 9, 1}, 8, 1)};
    std::vector<Part> inTheAir = parts;
    inTheAir.push_back(createBrick({20, 20, 4}, 2, 2));
    for (const std::vector<Part>& model : {parts, inTheAir})
    {
        const StabilityReport report = compute(createPartModel(model), BuildingBase::PLATE);
        EXPECT_EQ(report.stands, model.size() == parts.size());
        ASSERT_TRUE(report.weakest);
        EXPECT_EQ(report.weakest->lower, 1u);
        EXPECT_EQ(report.weakest->upper, 3u);
    }
}

TEST(Stability, ACancelledComputationGivesNothing)
{
    const osg::ref_ptr<const BrickModel> model = createRandomTower(1, 10);
    EXPECT_FALSE(computeStability(*model, {BuildingBase::TABLE, [] { return true; }}));
}

} // namespace

} // namespace osgLego::test
