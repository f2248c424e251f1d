#include "BookletModels.h"

#include <booklet/BookletBags.h>

#include <PartModels.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Steps = std::vector<BuildingStep>;

/** Makes plans for a row of bricks of 1x1, and what is built by them. */
class Row
{
public:
    /** Steps that place parts one after the other. */
    Steps createSteps(const std::vector<std::size_t>& sizes)
    {
        Steps steps;
        for (const std::size_t size : sizes)
        {
            steps.emplace_back();
            for (std::size_t index = 0; index < size; ++index)
                steps.back().parts.push_back(_numParts++);
        }
        return steps;
    }

    /** A step that attaches submodels, each of some steps. */
    BuildingStep createAttachment(const std::vector<std::vector<std::size_t>>& submodels)
    {
        BuildingStep step;
        for (const std::vector<std::size_t>& sizes : submodels)
        {
            step.submodels.push_back(static_cast<std::uint32_t>(_submodels.size()));
            _submodels.push_back({createSteps(sizes)});
        }
        return step;
    }

    /** Steps, one that attaches a submodel, and more steps. */
    Steps createStepsAround(const std::vector<std::size_t>& before, const std::vector<std::size_t>& submodel,
                            const std::vector<std::size_t>& after)
    {
        Steps steps = createSteps(before);
        steps.push_back(createAttachment({submodel}));
        const Steps last = createSteps(after);
        steps.insert(steps.end(), last.begin(), last.end());
        return steps;
    }

    std::vector<BookletBlock> createBlocks(Steps steps) const
    {
        std::vector<Part> parts;
        for (std::uint32_t part = 0; part < _numParts; ++part)
            parts.push_back({{static_cast<std::uint16_t>(part), 0, 0}, {1, 1, 1}, {180, 0, 0}, 4});
        const auto bricks =
            BrickModel::createOfParts(createPartGrid({static_cast<int>(_numParts), 1, 1}, 1.2), std::move(parts));
        const auto plan = BuildingPlan::create(_numParts, std::move(steps), _submodels);
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        return BookletBlocks(model, std::vector<bool>(model.getChapters().size(), false)).getBlocks();
    }

private:
    std::uint32_t _numParts = 0;
    std::vector<Submodel> _submodels;
};

std::vector<BookletBag> createBagsOfRow(const std::vector<std::size_t>& sizes)
{
    Row row;
    return createBags(row.createBlocks(row.createSteps(sizes)));
}

/** The numbers of parts in bags. */
std::vector<std::size_t> countParts(const std::vector<BookletBag>& bags)
{
    std::vector<std::size_t> numbers;
    for (const BookletBag& bag : bags)
        numbers.push_back(bag.countParts());
    return numbers;
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
            EXPECT_EQ(bag.firstBlock, next);
            EXPECT_EQ(bag.countParts(), 8 * (bag.endBlock - bag.firstBlock));
            EXPECT_GE(bag.countParts(), 100u);
            EXPECT_LE(bag.countParts(), 200u);
            next = bag.endBlock;
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

TEST(BookletBagsTest, ALargeSubmodelIsDividedAtItsSteps)
{
    Row row;
    Steps steps = row.createStepsAround({8, 8}, std::vector<std::size_t>(50, 8), {8, 8, 8});
    const std::vector<BookletBlock> blocks = row.createBlocks(std::move(steps));
    const std::vector<BookletBag> bags = createBags(blocks);
    EXPECT_EQ(bags.size(), 3u);
    for (const BookletBag& bag : bags)
    {
        EXPECT_GE(bag.countParts(), 100u);
        EXPECT_LE(bag.countParts(), 200u);
        EXPECT_FALSE(blocks[bag.endBlock - 1].isContents) << "a submodel begins in the bag of its first step";
    }
}

TEST(BookletBagsTest, ASmallSubmodelIsNotDivided)
{
    // Equal bags would divide it; a bag may end when it is built, before it is attached.
    Row row;
    Steps steps = row.createStepsAround(std::vector<std::size_t>(16, 8), std::vector<std::size_t>(6, 8),
                                        std::vector<std::size_t>(16, 8));
    EXPECT_EQ(countParts(createBags(row.createBlocks(std::move(steps)))), (std::vector<std::size_t>{128, 176}));
}

TEST(BookletBagsTest, ASubmodelIsNotDividedForAFewParts)
{
    // 96 parts, a submodel of 48, and 64 parts: the limits would be kept by a bag that begins within the submodel.
    Row row;
    Steps steps = row.createStepsAround(std::vector<std::size_t>(12, 8), std::vector<std::size_t>(6, 8),
                                        std::vector<std::size_t>(8, 8));
    EXPECT_EQ(countParts(createBags(row.createBlocks(std::move(steps)))), (std::vector<std::size_t>{96, 112}));
}

TEST(BookletBagsTest, ASubmodelThatIsBuiltTwiceIsNotDivided)
{
    Row row;
    Steps steps = row.createSteps(std::vector<std::size_t>(13, 8));
    steps.push_back(row.createAttachment({std::vector<std::size_t>(20, 8), std::vector<std::size_t>(20, 8)}));
    const std::vector<BookletBlock> blocks = row.createBlocks(std::move(steps));
    EXPECT_EQ(blocks[13].quantity, 2u);
    EXPECT_EQ(countParts(createBags(blocks)), (std::vector<std::size_t>{104, 320}));
}

} // namespace osgLego::test
