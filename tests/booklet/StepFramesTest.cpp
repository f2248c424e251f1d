#include "BookletModels.h"

#include <booklet/StepFrames.h>

#include <PartModels.h>
#include <common/BasePlate.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr std::size_t NUM_STEPS = 20;
constexpr std::size_t LOW_STEP = 18;
constexpr double HEIGHT = 1.2; // of bricks, in pitches

/** A tower of 40 bricks, two in each step, and a brick beside it, which a late step places on the ground. */
BookletModel createHighTower()
{
    std::vector<Part> parts;
    for (std::uint16_t layer = 0; layer < 2 * NUM_STEPS; ++layer)
        parts.push_back({{0, 0, layer}, {2, 2, 1}, {180, 0, 0}, 4});
    parts.push_back({{4, 0, 0}, {2, 2, 1}, {180, 0, 0}, 4});
    const auto bricks = BrickModel::createOfParts(createPartGrid({6, 2, 2 * NUM_STEPS}, HEIGHT), parts);
    std::vector<BuildingStep> steps;
    for (std::uint16_t step = 0; step < NUM_STEPS; ++step)
    {
        steps.emplace_back();
        for (const int layer : {2 * step, 2 * step + 1})
            steps.back().parts.push_back(
                static_cast<std::uint32_t>(bricks->findPart({0, 0, layer}) - bricks->getParts().data()));
    }
    steps[LOW_STEP].parts.push_back(
        static_cast<std::uint32_t>(bricks->findPart({4, 0, 0}) - bricks->getParts().data()));
    return {*bricks, *BuildingPlan::create(parts.size(), steps), Palette::getKnownColors()};
}

std::vector<BookletBlock> createBlocks(std::size_t first)
{
    std::vector<BookletBlock> blocks;
    for (std::size_t step = first; step < NUM_STEPS; ++step)
    {
        blocks.emplace_back();
        blocks.back().step = step;
    }
    return blocks;
}

/** The height of the bottom of a layer of the tower in a picture, at its front corner. */
double findBottom(const StepFrames& frames, const BookletModel& model, std::size_t layer)
{
    const BookletChapter& chapter = model.getMainChapter();
    return frames.createCamera(chapter, chapter.steps[0]).project({0.0, 0.0, static_cast<double>(layer)}).y;
}

} // namespace

TEST(StepFrames, PicturesShowAllPartsInPlaceWithoutSections)
{
    const BookletModel model = createHighTower();
    const StepFrames frames(model, nullptr, {});
    for (std::size_t step = 0; step < NUM_STEPS; ++step)
    {
        EXPECT_FALSE(frames.isCut(0, step));
        EXPECT_LE(frames.findFrame(0, step).lowest.y, findBottom(frames, model, 0));
        EXPECT_GE(frames.findFrame(0, step).highest.y, findBottom(frames, model, 2 * step + 2));
    }
}

TEST(StepFrames, PicturesOfASectionLeaveOutWhatIsFarBelowItsParts)
{
    const BookletModel model = createHighTower();
    StepFrames frames(model, nullptr, {});
    const StepFrames::Scale whole = frames.getScale(0);
    frames.setSection(0, createBlocks(14));
    for (std::size_t step = 14; step < NUM_STEPS; ++step)
    {
        const BookletFrame frame = frames.findFrame(0, step);
        EXPECT_DOUBLE_EQ(frame.getSize().x, whole.size.x) << step;
        EXPECT_GE(frame.highest.y, findBottom(frames, model, 2 * step + 2)) << step;
        if (step == LOW_STEP) continue;
        EXPECT_TRUE(frames.isCut(0, step)) << step;
        EXPECT_LT(frame.lowest.y, findBottom(frames, model, 2 * step) - 3.0) << "what the new parts are on";
        EXPECT_GT(frame.lowest.y, findBottom(frames, model, 2 * 14) - 8.0) << "not the layers of other sections";
    }
    EXPECT_LE(frames.findFrame(0, LOW_STEP).lowest.y, findBottom(frames, model, 0)) << "its part on the ground";
    EXPECT_FALSE(frames.isCut(0, LOW_STEP));
}

TEST(StepFrames, TheFirstStepShowsTheWholeBasePlate)
{
    const BookletModel model = createHighTower();
    const osg::ref_ptr<const BrickModel> plate = BasePlate(*model.getMainChapter().model).createModel(false);
    StepFrames frames(model, plate, {});
    frames.setSection(0, createBlocks(0));
    const BookletChapter& chapter = model.getMainChapter();
    EXPECT_LE(frames.findFrame(0, 0).lowest.y,
              frames.createCamera(chapter, chapter.steps[0]).findFrame(*plate).lowest.y);
    EXPECT_FALSE(frames.isCut(0, 0));
    EXPECT_TRUE(frames.isCut(0, NUM_STEPS - 1));
}

TEST(StepFrames, PicturesOfASectionHaveALargerScaleUntilTheNextOne)
{
    const BookletModel model = createHighTower();
    StepFrames frames(model, nullptr, {});
    const double whole = frames.getScale(0).pixels;
    std::vector<BookletBlock> blocks = createBlocks(14);
    std::erase_if(blocks, [](const BookletBlock& block) { return block.step == LOW_STEP; });
    frames.setSection(0, blocks);
    EXPECT_GT(frames.getScale(0).pixels, 1.3 * whole);
    frames.setSection(0, {});
    EXPECT_EQ(frames.getScale(0).pixels, whole);
    EXPECT_FALSE(frames.isCut(0, NUM_STEPS - 1));
}

TEST(StepFrames, SectionsThatWouldHardlyBeLowerShowAll)
{
    const BookletModel model = createHighTower();
    StepFrames frames(model, nullptr, {});
    for (const std::size_t first : {2, 12})
    {
        std::vector<BookletBlock> blocks = createBlocks(first);
        blocks.resize(5);
        frames.setSection(0, blocks);
        for (std::size_t step = first; step < first + 5; ++step)
            EXPECT_EQ(frames.isCut(0, step), first == 12) << "after step 2, few pitches of many would be left out";
    }
}

} // namespace osgLego::test
