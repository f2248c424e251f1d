#include <osgLego/building/StepBuilder.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using PartList = std::vector<std::uint32_t>;

/** Builds steps of boxes that fall by a rule of the test. */
class Building
{
public:
    /** @param falls whether a part falls if it and others are in place. */
    using Falls = std::function<bool(std::uint32_t part, const std::vector<bool>& isPlaced)>;

    Building(std::vector<BuildingBox> boxes, Falls falls) : _graph(std::move(boxes)), _falls(std::move(falls)) {}

    std::vector<AssemblyStep> build() const
    {
        const auto findFalling = [this](const std::vector<bool>& isPlaced) -> std::optional<PartList>
        {
            PartList falling;
            for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
                if (isPlaced[part] && _falls(part, isPlaced)) falling.push_back(part);
            return falling;
        };
        return StepBuilder(_graph, findFalling, [](std::size_t, bool) { return true; }).build();
    }

private:
    JointGraph _graph;
    Falls _falls;
};

/** Columns of bricks of 2x2, one after the other, and their heights. */
std::vector<BuildingBox> createColumns(const std::vector<std::pair<int, int>>& placesAndHeights)
{
    std::vector<BuildingBox> boxes;
    for (const auto& [x, height] : placesAndHeights)
        for (int z = 0; z < height; ++z)
            boxes.push_back({{x, 0, z}, {x + 2, 2, z + 1}});
    return boxes;
}

/** The steps, each with the parts of its submodels, sorted. */
std::vector<PartList> toPlaced(const std::vector<AssemblyStep>& steps)
{
    std::vector<PartList> placed;
    for (const AssemblyStep& step : steps)
    {
        PartList& parts = placed.emplace_back(step.parts);
        for (const PartList& submodel : step.submodels)
            parts.insert(parts.end(), submodel.begin(), submodel.end());
        std::sort(parts.begin(), parts.end());
    }
    return placed;
}

bool allStand(const std::vector<AssemblyStep>& steps)
{
    return std::all_of(steps.begin(), steps.end(),
                       [](const AssemblyStep& step) { return step.stands && step.isChecked; });
}

bool haveSubmodels(const std::vector<AssemblyStep>& steps)
{
    return std::any_of(steps.begin(), steps.end(), [](const AssemblyStep& step) { return !step.submodels.empty(); });
}

TEST(StepBuilder, ClampsAFallingPartByThePartAboveThatHoldsIt)
{
    // The eighth brick of a column, at which a step ends, falls unless the ninth is on it.
    const Building building(createColumns({{0, 16}}), [](std::uint32_t part, const std::vector<bool>& isPlaced)
                            { return part == 7 && !isPlaced[8]; });
    const std::vector<AssemblyStep> steps = building.build();
    EXPECT_TRUE(allStand(steps));
    EXPECT_FALSE(haveSubmodels(steps));
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].parts, (PartList{0, 1, 2, 3, 4, 5, 6, 7, 8})) << "from below to above";
    EXPECT_EQ(steps[1].parts, (PartList{9, 10, 11, 12, 13, 14, 15}));
}

TEST(StepBuilder, PostponesPartsThatFallWithoutOthersThatNothingConnectsWithThem)
{
    // Two columns; the upper half of the first falls unless the second is in place.
    const Building building(createColumns({{0, 16}, {20, 8}}), [](std::uint32_t part, const std::vector<bool>& isPlaced)
                            { return part >= 8 && part < 16 && !isPlaced[23]; });
    const std::vector<AssemblyStep> steps = building.build();
    EXPECT_TRUE(allStand(steps));
    EXPECT_FALSE(haveSubmodels(steps));
    EXPECT_EQ(toPlaced(steps),
              (std::vector<PartList>{
                  {0, 1, 2, 3, 4, 5, 6, 7}, {16, 17, 18, 19, 20, 21, 22, 23}, {8, 9, 10, 11, 12, 13, 14, 15}}));
}

TEST(StepBuilder, HangsPartsFromOneAboveThatIsTooFarForTheSameStep)
{
    // On a base stand two columns of more parts than a step, which a beam joins. One falls until the beam holds it.
    constexpr int HEIGHT = 14;
    std::vector<BuildingBox> boxes{{{0, 0, HEIGHT + 1}, {8, 2, HEIGHT + 2}}, {{0, 0, 0}, {8, 2, 1}}};
    constexpr std::uint32_t BEAM = 0;
    PartList hanging{BEAM};
    for (const int x : {0, 6})
        for (int z = 1; z <= HEIGHT; ++z)
        {
            if (x == 0) hanging.push_back(static_cast<std::uint32_t>(boxes.size()));
            boxes.push_back({{x, 0, z}, {x + 2, 2, z + 1}});
        }
    const Building building(boxes, [&hanging](std::uint32_t part, const std::vector<bool>& isPlaced)
                            { return std::binary_search(hanging.begin(), hanging.end(), part) && !isPlaced[BEAM]; });
    const std::vector<AssemblyStep> steps = building.build();
    EXPECT_TRUE(allStand(steps));
    std::vector<PartList> submodels;
    for (const AssemblyStep& step : steps)
        submodels.insert(submodels.end(), step.submodels.begin(), step.submodels.end());
    EXPECT_EQ(submodels, std::vector<PartList>{hanging});
}

TEST(StepBuilder, PartsThatFallWhateverIsDoneArePlacedOnce)
{
    // The upper half of a column falls. Nothing else depends on it.
    const Building building(createColumns({{0, 16}}),
                            [](std::uint32_t part, const std::vector<bool>&) { return part >= 8; });
    const std::vector<AssemblyStep> steps = building.build();
    PartList all;
    for (const PartList& placed : toPlaced(steps))
        all.insert(all.end(), placed.begin(), placed.end());
    std::sort(all.begin(), all.end());
    PartList expected(16);
    for (std::uint32_t part = 0; part < expected.size(); ++part)
        expected[part] = part;
    EXPECT_EQ(all, expected);
    EXPECT_TRUE(steps.front().stands);
    EXPECT_FALSE(steps.back().stands);
    EXPECT_TRUE(steps.back().isChecked);
}

TEST(StepBuilder, StepsOfWhichNothingIsKnownStandUnchecked)
{
    constexpr int HEIGHT = 40;
    constexpr int KNOWN = 20;
    std::vector<BuildingBox> boxes;
    for (int z = 0; z < HEIGHT; ++z)
        boxes.push_back({{0, 0, z}, {2, 2, z + 1}});
    const JointGraph graph(boxes);
    const auto findFalling = [](const std::vector<bool>& isPlaced) -> std::optional<std::vector<std::uint32_t>>
    {
        if (std::count(isPlaced.begin(), isPlaced.end(), true) > KNOWN) return std::nullopt;
        return std::vector<std::uint32_t>();
    };
    std::size_t numPlaced = 0;
    for (const AssemblyStep& step : StepBuilder(graph, findFalling, [](std::size_t, bool) { return true; }).build())
    {
        numPlaced += step.parts.size();
        EXPECT_TRUE(step.stands);
        EXPECT_EQ(step.isChecked, numPlaced <= KNOWN) << numPlaced;
    }
    EXPECT_EQ(numPlaced, static_cast<std::size_t>(HEIGHT));
}

TEST(StepBuilder, IsGivenUpAfterAStepIfItMayNotProceed)
{
    const JointGraph graph(createColumns({{0, 32}}));
    std::vector<std::size_t> numPlaced;
    const auto proceed = [&numPlaced](std::size_t number, bool)
    {
        numPlaced.push_back(number);
        return numPlaced.size() < 2;
    };
    EXPECT_TRUE(StepBuilder(graph, nullptr, proceed).build().empty());
    EXPECT_EQ(numPlaced, (std::vector<std::size_t>{8, 16}));
}

TEST(StepBuilder, AClampedStepContainsTheOtherPartsOfTheStepToo)
{
    // A column of six bricks, and a higher one whose second brick falls unless the third is on it.
    const Building building(createColumns({{0, 6}, {20, 16}}), [](std::uint32_t part, const std::vector<bool>& isPlaced)
                            { return part == 7 && !isPlaced[8]; });
    const std::vector<AssemblyStep> steps = building.build();
    EXPECT_TRUE(allStand(steps));
    EXPECT_EQ(toPlaced(steps).front(), (PartList{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(StepBuilder, StepsAreNotRepairedAfterAPartThatFallsWhateverIsDone)
{
    // The lowest part of a column falls, and a part in the middle, which might hang from those above it.
    const Building building(createColumns({{0, 24}}),
                            [](std::uint32_t part, const std::vector<bool>&) { return part == 0 || part == 12; });
    const std::vector<AssemblyStep> steps = building.build();
    EXPECT_FALSE(haveSubmodels(steps));
    EXPECT_EQ(toPlaced(steps),
              (std::vector<PartList>{
                  {0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11, 12, 13, 14, 15}, {16, 17, 18, 19, 20, 21, 22, 23}}));
}

TEST(StepBuilder, PartsThatFallWhateverIsDoneArePlacedWhenNoOthersCanBe)
{
    // Three columns; the second part of the first one falls, and the parts above it with it.
    const std::vector<BuildingBox> boxes = createColumns({{0, 8}, {12, 8}, {24, 8}});
    const auto steps =
        Building(boxes, [](std::uint32_t part, const std::vector<bool>&) { return part > 0 && part < 8; }).build();
    const std::vector<PartList> placed = toPlaced(steps);
    std::size_t numPlaced = 0;
    for (std::size_t index = 0; index < steps.size(); ++index)
    {
        const bool falls = numPlaced >= 17;
        numPlaced += placed[index].size();
        EXPECT_EQ(steps[index].stands, !falls) << numPlaced;
        for (const std::uint32_t part : placed[index])
            EXPECT_EQ(part > 0 && part < 8, falls) << part;
    }
    EXPECT_EQ(numPlaced, boxes.size());
}

TEST(StepBuilder, TheLastStepHasMoreThanOnePart)
{
    // Two columns, and on the first one a beam from which three bricks hang: a submodel. The brick on the beam comes
    // after it.
    std::vector<BuildingBox> boxes = createColumns({{0, 3}, {12, 4}});
    boxes.push_back({{4, 0, 1}, {8, 2, 2}});
    boxes.push_back({{6, 0, 2}, {8, 2, 3}});
    boxes.push_back({{4, 0, 2}, {6, 2, 3}});
    boxes.push_back({{0, 0, 3}, {6, 2, 4}});
    boxes.push_back({{2, 0, 4}, {4, 2, 5}});
    const std::size_t number = boxes.size();
    const Building building(std::move(boxes), [](std::uint32_t, const std::vector<bool>&) { return false; });
    const std::vector<AssemblyStep> steps = building.build();
    EXPECT_TRUE(haveSubmodels(steps));
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps.back().parts.size(), 2u);
    EXPECT_EQ(steps.back().parts.back(), number - 1);
    EXPECT_EQ(toPlaced(steps)[0].size() + toPlaced(steps)[1].size(), number);
    EXPECT_TRUE(allStand(steps));
}

TEST(StepBuilder, PartsOnTheBaseDoNotHang)
{
    // The lowest part of a column falls. The parts on it could only hold it if something held them.
    const JointGraph graph(createColumns({{0, 16}}));
    const auto findFalling = [](const std::vector<bool>&) { return std::optional<PartList>(PartList{0}); };
    std::vector<std::size_t> numPlaced;
    const auto proceed = [&numPlaced](std::size_t number, bool)
    {
        numPlaced.push_back(number);
        return true;
    };
    EXPECT_EQ(StepBuilder(graph, findFalling, proceed).build().size(), 2u);
    EXPECT_EQ(numPlaced, (std::vector<std::size_t>{0, 8, 16})) << "others are sought, but not grouped again";
}

} // namespace

} // namespace osgLego::test
