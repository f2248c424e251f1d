#include "BookletModels.h"

#include <booklet/BookletBags.h>

#include <PartModels.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** The bags of a row of bricks of 1x1 in steps of some sizes. */
std::vector<BookletBag> createBagsOfRow(const std::vector<std::size_t>& sizes)
{
    std::vector<Part> parts;
    std::vector<BuildingStep> steps;
    for (const std::size_t size : sizes)
    {
        steps.emplace_back();
        for (std::size_t index = 0; index < size; ++index)
        {
            steps.back().parts.push_back(static_cast<std::uint32_t>(parts.size()));
            parts.push_back({{static_cast<std::uint16_t>(parts.size()), 0, 0}, {1, 1, 1}, {180, 0, 0}, 4});
        }
    }
    const std::size_t number = parts.size();
    const auto bricks =
        BrickModel::createOfParts(createPartGrid({static_cast<int>(number), 1, 1}, 1.2), std::move(parts));
    const auto plan = BuildingPlan::create(number, std::move(steps));
    return createBags(BookletModel(*bricks, *plan, Palette::getKnownColors()));
}

} // namespace

TEST(BookletBagsTest, HaveOneToTwoHundredPartsAndAllSteps)
{
    for (const std::size_t numSteps : {26, 37, 50, 71, 128})
    {
        const std::vector<BookletBag> bags = createBagsOfRow(std::vector<std::size_t>(numSteps, 8));
        std::size_t next = 0;
        std::size_t numParts = 0;
        for (const BookletBag& bag : bags)
        {
            EXPECT_EQ(bag.firstStep, next);
            EXPECT_EQ(bag.countParts(), 8 * (bag.endStep - bag.firstStep));
            EXPECT_GE(bag.countParts(), 100u);
            EXPECT_LE(bag.countParts(), 200u);
            next = bag.endStep;
            numParts += bag.countParts();
        }
        EXPECT_EQ(next, numSteps);
        EXPECT_EQ(numParts, 8 * numSteps);
    }
}

TEST(BookletBagsTest, ModelsBelow200PartsHaveNone)
{
    EXPECT_TRUE(createBagsOfRow(std::vector<std::size_t>(19, 10)).empty());
    EXPECT_EQ(createBagsOfRow(std::vector<std::size_t>(20, 10)).size(), 2u);
}

TEST(BookletBagsTest, AStepIsInOneBagHoweverManyPartsItHas)
{
    const std::vector<BookletBag> bags = createBagsOfRow({10, 500, 10, 10});
    ASSERT_EQ(bags.size(), 2u);
    EXPECT_EQ(bags[0].countParts() + bags[1].countParts(), 530u);
    EXPECT_TRUE(createBagsOfRow({300}).empty()) << "one bag is none";
}

} // namespace osgLego::test
