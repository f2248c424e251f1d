#include <booklet/BookletCamera.h>
#include <booklet/BookletModel.h>
#include <booklet/HiddenParts.h>

#include <common/BrickRayCaster.h>
#include <common/RacingCar.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLego/CpuLegolizer.h>

#include <PartModels.h>
#include <Settings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Whether any ray from a part reaches the eye. */
bool isSeen(const BrickRayCaster& caster, const Part& part, const glm::dvec3& toEye)
{
    constexpr int SAMPLES = 8; // along each edge of a cell
    const BrickGrid& grid = caster.getModel().getGrid();
    const glm::dvec3 scale = grid.cellSize / grid.getPitch();
    for (int axis = 0; axis < 3; ++axis)
    {
        if (std::abs(toEye[axis]) < 1e-6) continue; // edge-on
        glm::ivec3 counts = SAMPLES * part.getSize();
        counts[axis] = 1;
        for (int z = 0; z < counts.z; ++z)
            for (int y = 0; y < counts.y; ++y)
                for (int x = 0; x < counts.x; ++x)
                {
                    glm::dvec3 place = (glm::dvec3(x, y, z) + 0.5) / static_cast<double>(SAMPLES);
                    place[axis] = toEye[axis] > 0.0 ? part.getSize()[axis] : 0;
                    const glm::dvec3 start = (glm::dvec3(part.getCell()) + place) * scale + 1e-4 * toEye;
                    if (!caster.findNearest(start, toEye, std::numeric_limits<double>::infinity())) return true;
                }
    }
    return false;
}

/** The parts that are placed by steps and not seen there, and those of them that get an arrow. */
struct Unseen
{
    std::size_t number = 0;
    std::size_t numWithArrows = 0;
    std::size_t numArrows = 0;
};

Unseen countUnseen(const BrickModel& bricks, const BuildingView& view = {})
{
    PlanningOptions options;
    options.checksStability = false;
    options.view = view;
    const osg::ref_ptr<const BuildingPlan> plan = planBuilding(bricks, options);
    const BookletModel model(bricks, *plan, Palette::getKnownColors());
    Unseen unseen;
    for (const BookletChapter& chapter : model.getChapters())
        for (const BookletStep& step : chapter.steps)
        {
            const BookletCamera camera(bricks.getGrid(), {step.turns, step.isUpsideDown, view});
            const std::span<const std::uint32_t> placed = std::span(chapter.plan->getOrder()).first(step.numPlaced);
            const auto shown = placed.last(step.numNew).first(step.numDirect);
            const std::vector<std::uint32_t> arrows = findHiddenParts(*chapter.model, placed, shown, camera.getToEye());
            unseen.numArrows += arrows.size();
            std::vector<Part> parts;
            for (const std::uint32_t part : placed)
                parts.push_back(chapter.model->getParts()[part]);
            const BrickRayCaster caster(*BrickModel::createOfParts(bricks.getGrid(), parts));
            for (const std::uint32_t part : shown)
            {
                if (isSeen(caster, chapter.model->getParts()[part], camera.getToEye())) continue;
                ++unseen.number;
                unseen.numWithArrows += std::find(arrows.begin(), arrows.end(), part) != arrows.end() ? 1 : 0;
            }
        }
    return unseen;
}

} // namespace

TEST(HiddenPartsTest, APartBehindAWallIsHiddenAndOneOnItIsNot)
{
    const auto model = BrickModel::createOfParts(
        createPartGrid({8, 8, 9}, 1.2), {{{0, 2, 0}, {8, 2, 8}}, {{3, 5, 0}, {2, 2, 1}}, {{3, 2, 8}, {2, 2, 1}}});
    std::vector<std::uint32_t> all(3);
    std::iota(all.begin(), all.end(), 0u);
    const BookletCamera camera(model->getGrid(), {});
    const std::vector<std::uint32_t> hidden = findHiddenParts(*model, all, all, camera.getToEye());
    ASSERT_EQ(hidden.size(), 1u);
    EXPECT_EQ(model->getParts()[hidden[0]].getCell(), glm::ivec3(3, 5, 0));
    const BookletCamera behind(model->getGrid(), {2, false});
    EXPECT_TRUE(findHiddenParts(*model, all, all, behind.getToEye()).empty());
}

TEST(HiddenPartsTest, APartOfWhichOnlyFacesEdgeOnAreOpenIsHidden)
{
    const auto model = BrickModel::createOfParts(
        createPartGrid({2, 10, 3}, 1.2), {{{0, 0, 0}, {2, 2, 3}}, {{0, 2, 0}, {2, 8, 1}}, {{0, 2, 1}, {2, 8, 1}}});
    std::vector<std::uint32_t> all(3);
    std::iota(all.begin(), all.end(), 0u);
    for (const double azimuth : {0.0, 4.0})
    {
        const BookletCamera straight(model->getGrid(), {0, false, {azimuth, 20.0}});
        const std::vector<std::uint32_t> hidden = findHiddenParts(*model, all, all, straight.getToEye());
        ASSERT_EQ(hidden.size(), 1u) << azimuth;
        EXPECT_EQ(model->getParts()[hidden[0]].getCell(), glm::ivec3(0, 2, 0)) << azimuth;
    }
    const BookletCamera oblique(model->getGrid(), {0, false, {20.0, 20.0}});
    EXPECT_TRUE(findHiddenParts(*model, all, all, oblique.getToEye()).empty());
}

TEST(HiddenPartsTest, EveryNewPartIsSeenInTheStepThatPlacesItOrHasAnArrow)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    for (const char* settings : {"20,proportions=brick,parts=bricks", "28,proportions=brick,parts=bricks,fill=shell"})
    {
        const osg::ref_ptr<const BrickModel> bricks = legolizeOnCpu(*car, parseSettings(settings));
        for (const BuildingView& view : {BuildingView(), BuildingView{0.0, 20.0}})
        {
            const Unseen unseen = countUnseen(*bricks, view);
            EXPECT_EQ(unseen.number, unseen.numWithArrows) << settings << ' ' << view.azimuth;
            // An arrow is the exception.
            EXPECT_LE(unseen.numArrows * 50, bricks->getParts().size()) << settings << ' ' << view.azimuth;
        }
    }
}

} // namespace osgLego::test
