#include <osgLego/building/StepBuilder.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

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
    for (const AssemblyStep& step : StepBuilder(graph, findFalling, [](std::size_t) { return true; }).build())
    {
        numPlaced += step.parts.size();
        EXPECT_TRUE(step.stands);
        EXPECT_EQ(step.isChecked, numPlaced <= KNOWN) << numPlaced;
    }
    EXPECT_EQ(numPlaced, static_cast<std::size_t>(HEIGHT));
}

} // namespace

} // namespace osgLego::test
