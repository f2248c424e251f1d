#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/stability/PartialStability.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Asks which parts of a model fall if some are in place. */
class Subsets
{
public:
    Subsets(const BrickModel& model, BuildingBase base, std::size_t mostSolved = PartialStability::MOST_SOLVED) :
        _model(model), _base(base), _all(model.getParts().size()), _graph(createBuildingBoxes(model)),
        _stability(model, number(_all), _graph, {false, base, {}, mostSolved})
    {
    }

    std::optional<std::vector<std::uint32_t>> findFalling(const std::vector<bool>& isPlaced)
    {
        return _stability.findFalling(isPlaced);
    }

    /** Whether they stand by CLP. */
    bool stands(const std::vector<bool>& isPlaced) const
    {
        std::vector<Part> placed;
        for (const std::uint32_t part : _all)
            if (isPlaced[part]) placed.push_back(_model.getParts()[part]);
        if (placed.empty()) return true;
        const std::optional<double> tension =
            computePlainTension(*BrickModel::createOfParts(_model.getGrid(), std::move(placed)), _base);
        return tension && *tension <= 0.98;
    }

private:
    static const std::vector<std::uint32_t>& number(std::vector<std::uint32_t>& parts)
    {
        std::iota(parts.begin(), parts.end(), 0u);
        return parts;
    }

    const BrickModel& _model;
    BuildingBase _base;
    std::vector<std::uint32_t> _all;
    JointGraph _graph;
    PartialStability _stability;
};

/** Call visit(isPlaced) for subsets of parts that grow from the lowest layer upwards, with gaps. */
void visitSubsets(std::size_t numParts, unsigned int seed, const std::function<void(const std::vector<bool>&)>& visit)
{
    std::mt19937 random(seed);
    std::vector<bool> isPlaced(numParts, false);
    for (std::size_t part = 0; part < numParts; ++part)
    {
        isPlaced[part] = random() % 8 != 0;
        visit(isPlaced);
    }
}

constexpr int NUM_PARTS = 30;
constexpr unsigned int NUM_TOWERS = 6;

TEST(PartialStability, PartsStandExactlyIfTheyDoByClp)
{
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
    {
        int numStanding = 0;
        int numFalling = 0;
        for (unsigned int seed = 1; seed <= NUM_TOWERS; ++seed)
        {
            const auto tower = createRandomTower(seed, NUM_PARTS);
            const osg::ref_ptr<const BrickModel> model = seed % 2 == 0 ? tilt(*tower) : tower;
            Subsets subsets(*model, base);
            visitSubsets(model->getParts().size(), seed,
                         [&](const std::vector<bool>& isPlaced)
                         {
                             const auto falling = subsets.findFalling(isPlaced);
                             ASSERT_TRUE(falling);
                             const bool stands = subsets.stands(isPlaced);
                             EXPECT_EQ(falling->empty(), stands) << seed;
                             for (const std::uint32_t part : *falling)
                                 EXPECT_TRUE(isPlaced[part]) << seed << ", " << part;
                             ++(stands ? numStanding : numFalling);
                         });
        }
        EXPECT_GT(numStanding, 20);
        EXPECT_GT(numFalling, 20);
    }
}

TEST(PartialStability, WithoutLinearProgramsOnlyPartsThatStandByClpStandAndMostOfThemDo)
{
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
    {
        int numStanding = 0;
        int numFound = 0;
        for (unsigned int seed = 1; seed <= NUM_TOWERS; ++seed)
        {
            const auto model = createRandomTower(seed, NUM_PARTS);
            Subsets subsets(*model, base, 0);
            visitSubsets(model->getParts().size(), seed,
                         [&](const std::vector<bool>& isPlaced)
                         {
                             const auto falling = subsets.findFalling(isPlaced);
                             const bool stands = subsets.stands(isPlaced);
                             EXPECT_TRUE(stands || !falling) << seed;
                             EXPECT_TRUE(!falling || falling->empty()) << seed;
                             numStanding += stands;
                             numFound += falling.has_value();
                         });
        }
        EXPECT_GE(100 * numFound, 95 * numStanding);
        EXPECT_GT(numStanding, 20);
    }
}

TEST(PartialStability, ALoadThatOnlyALinearProgramProvesMayGrowUpToTheCapacity)
{
    // Forces that are spread evenly pull twice as much as needed. Each brick 1 x 1 adds 0.0284 N to the pull at the
    // joint and at the plate, which is 0.6429 N without them: 11 of them are held by 0.98 N, and 12 are not.
    const osg::ref_ptr<const BrickModel> model = createLoadedCantilever(7, 16);
    const std::size_t numParts = model->getParts().size();
    for (const std::size_t first : {1, 2 + 7 + 10})
    {
        Subsets subsets(*model, BuildingBase::PLATE);
        for (std::size_t count = first; count <= numParts; ++count)
        {
            std::vector<bool> isPlaced(numParts, false);
            std::fill_n(isPlaced.begin(), count, true);
            const auto falling = subsets.findFalling(isPlaced);
            ASSERT_TRUE(falling);
            EXPECT_EQ(falling->empty(), count <= 2 + 7 + 11) << first << ", " << count;
            EXPECT_EQ(falling->empty(), subsets.stands(isPlaced)) << first << ", " << count;
        }
    }
}

TEST(PartialStability, PartsAreAddedToThoseThatALinearProgramProvesWithoutAnother)
{
    // As above: 0.6429 N, which only the linear program finds, and then three times 0.0568 N of forces spread evenly.
    const osg::ref_ptr<const BrickModel> model = createLoadedCantilever(7, 3);
    Subsets subsets(*model, BuildingBase::PLATE, 1);
    std::vector<bool> isPlaced(model->getParts().size(), false);
    std::fill_n(isPlaced.begin(), 2 + 7, true);
    EXPECT_EQ(Subsets(*model, BuildingBase::PLATE, 0).findFalling(isPlaced), std::nullopt);
    EXPECT_EQ(subsets.findFalling(isPlaced), std::vector<std::uint32_t>());
    isPlaced.assign(isPlaced.size(), true);
    EXPECT_EQ(subsets.findFalling(isPlaced), std::vector<std::uint32_t>());
}

TEST(PartialStability, NothingIsKnownOfPartsThatFallIfTheLinearProgramIsNotSolved)
{
    const auto model = createPartModel({createBrick({0, 0, 0}, 2, 2), createBrick({0, 0, 1}, 8, 2)});
    EXPECT_EQ(Subsets(*model, BuildingBase::TABLE, 0).findFalling({true, true}), std::nullopt);
    EXPECT_EQ(Subsets(*model, BuildingBase::TABLE, 0).findFalling({true, false}), std::vector<std::uint32_t>());
    const auto falling = Subsets(*model, BuildingBase::TABLE, 1).findFalling({true, true});
    EXPECT_TRUE(falling && !falling->empty());
}

} // namespace

} // namespace osgLego::test
