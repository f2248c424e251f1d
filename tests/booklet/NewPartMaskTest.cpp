#include <booklet/NewPartMask.h>

#include <PartModels.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr glm::ivec2 PICTURE{400, 300}; // pixels

/** The mask of the last of some parts, in a picture that shows all of them. */
NewPartMask createMask(const std::vector<Part>& parts, int margin)
{
    const auto model = BrickModel::createOfParts(createPartGrid({8, 8, 9}, 1.2), parts);
    const BookletCamera camera(model->getGrid(), {});
    std::vector<std::uint32_t> placed(parts.size());
    std::iota(placed.begin(), placed.end(), 0u);
    // The model sorts its parts by their cells.
    const auto isLast = [&](std::uint32_t index) { return model->getParts()[index] == parts.back(); };
    std::stable_partition(placed.begin(), placed.end(), [&](std::uint32_t index) { return !isLast(index); });
    return NewPartMask::create(*model, placed, 1, camera, camera.findFrame(*model), PICTURE, margin);
}

float sum(const NewPartMask& mask)
{
    return std::accumulate(mask.shares.begin(), mask.shares.end(), 0.0f);
}

} // namespace

TEST(NewPartMask, HasTheVisiblePixelsOfANewPartAndNoneBehindEarlierParts)
{
    const Part brick{{3, 5, 0}, {2, 2, 1}};
    const NewPartMask alone = createMask({brick}, 0);
    EXPECT_EQ(alone.size, PICTURE / NewPartMask::PIXELS) << "the picture shows the part alone";
    // The frame holds the outline of a box and its studs, which is a hexagon of more than half of it.
    EXPECT_GT(sum(alone), 0.5f * static_cast<float>(alone.shares.size()));
    EXPECT_LT(sum(alone), 0.9f * static_cast<float>(alone.shares.size()));
    EXPECT_EQ(sum(createMask({{{0, 2, 0}, {8, 2, 8}}, brick}, 0)), 0.0f) << "behind a wall";
    EXPECT_GT(sum(createMask({{{0, 6, 0}, {8, 2, 8}}, brick}, 0)), 0.0f) << "in front of a wall";
}

TEST(NewPartMask, EndsAtItsMarginOrAtThePicture)
{
    const std::vector<Part> parts{{{0, 6, 0}, {8, 2, 8}}, {{3, 5, 0}, {2, 1, 1}}};
    const NewPartMask tight = createMask(parts, 0);
    const NewPartMask wide = createMask(parts, 5);
    EXPECT_LT(tight.size.x, PICTURE.x / NewPartMask::PIXELS);
    EXPECT_EQ(wide.lowest, glm::max(tight.lowest - 5, glm::ivec2(0)));
    EXPECT_EQ(wide.lowest.x + wide.size.x, tight.lowest.x + tight.size.x + 5);
    EXPECT_EQ(sum(wide), sum(tight));
    EXPECT_EQ(createMask(parts, 1000).size, PICTURE / NewPartMask::PIXELS);
}

} // namespace osgLego::test
