#include "../building/PlanCheck.h"
#include "BrickTowers.h"

#include <osgLego/stability/PartialStability.h>

#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Asks which parts of a model fall if some are in place. */
class Subsets
{
public:
    Subsets(const BrickModel& model, BuildingBase base, std::size_t mostSolved) :
        _model(model), _base(base), _all(model.getParts().size()), _graph(createBuildingBoxes(model)),
        _stability(model, number(_all), _graph, createSetting(base, mostSolved))
    {
    }

    std::optional<std::vector<std::uint32_t>> findFalling(const std::vector<bool>& isPlaced)
    {
        return _stability.findFalling(isPlaced);
    }

    /** Whether they stand by the linear program. */
    bool stands(const std::vector<bool>& isPlaced) const
    {
        std::vector<std::uint32_t> placed;
        for (const std::uint32_t part : _all)
            if (isPlaced[part]) placed.push_back(part);
        return computeStability(*selectParts(_model, placed), {_base, {}})->stands;
    }

private:
    static PartialStability::Setting createSetting(BuildingBase base, std::size_t mostSolved)
    {
        PartialStability::Setting setting;
        setting.base = base;
        setting.mostSolved = mostSolved;
        return setting;
    }

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

TEST(PartialStability, SubsetsThatCountAsStandingStandByTheLinearProgram)
{
    constexpr int NUM_PARTS = 40;
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
        for (const std::size_t mostSolved : {std::size_t(0), PartialStability::MOST_SOLVED})
        {
            int numStanding = 0;
            for (unsigned int seed = 1; seed < 5; ++seed)
            {
                const auto model = createRandomTower(seed, NUM_PARTS);
                Subsets subsets(*model, base, mostSolved);
                std::mt19937 random(seed);
                // Growing subsets, from the lowest layer upwards, with gaps.
                std::vector<bool> isPlaced(model->getParts().size(), false);
                for (std::size_t part = 0; part < isPlaced.size(); ++part)
                {
                    isPlaced[part] = random() % 8 != 0;
                    const auto falling = subsets.findFalling(isPlaced);
                    if (!falling || !falling->empty()) continue;
                    ++numStanding;
                    EXPECT_TRUE(subsets.stands(isPlaced)) << seed << ", " << part;
                }
            }
            EXPECT_GT(numStanding, 5);
        }
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
