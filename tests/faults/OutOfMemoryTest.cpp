#include "Shortages.h"
#include "SmallModel.h"

#include <osgLego/BuildingPlanner.h>
#include <osgLego/LegoNode.h>
#include <osgLego/Stability.h>
#include <osgLego/producer/BackgroundJob.h>

#include <future>
#include <new>
#include <optional>
#include <string>

namespace osgLego::test
{

namespace
{

class OutOfMemory : public ::testing::TestWithParam<Scarcity>
{
};

INSTANTIATE_TEST_SUITE_P(Scarcities, OutOfMemory,
                         ::testing::Combine(::testing::Values(MemoryFaults::Extent::ONE,
                                                              MemoryFaults::Extent::ALL_AFTER),
                                            ::testing::Values(1, 2)),
                         nameOf);

/** Work that takes long, so that only some of the scarcities are tried. */
class OutOfMemoryInLongWork : public OutOfMemory
{
};

INSTANTIATE_TEST_SUITE_P(Scarcities, OutOfMemoryInLongWork,
                         ::testing::Values(Scarcity(MemoryFaults::Extent::ONE, 1),
                                           Scarcity(MemoryFaults::Extent::ALL_AFTER, 2)),
                         nameOf);

// Pieces are joined, in a way that remains when the parts are laid again.
constexpr const char* SETTINGS = "3,proportions=plate,parts=bricks,fill=shell,connect=on";

/** A model whose plan needs linear programs, since parts of it hang. */
osg::ref_ptr<const BrickModel> createHangingModel()
{
    return legolizeOnCpu(*createSphere(4), parseSettings("4,proportions=plate,parts=bricks"));
}

TEST_P(OutOfMemory, OnTheCpuThrows)
{
    const osg::ref_ptr<osg::Node> sphere = createSphere(4);
    const LegoSettings settings = parseSettings(SETTINGS);
    osg::ref_ptr<const BrickModel> model;
    surviveShortages({.mayThrow = true,
                      .work = [&] { model = legolizeOnCpu(*sphere, settings); },
                      .getResult = [&] { return encode(model); }},
                     GetParam());
}

TEST_P(OutOfMemory, IsTheObstacleOfANode)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(SETTINGS));
    lego->addChild(createSphere(4));
    osg::ref_ptr<const BrickModel> model;
    surviveShortages({.prepare = [&] { lego->dirty(); },
                      .work = [&] { model = lego->getBricks(); },
                      .getResult = [&] { return encode(model); },
                      .getMessage = [&] { return lego->getObstacle(); }},
                     GetParam());
}

TEST_P(OutOfMemory, WhileSettingsChangeThrowsAndTheNextChangeSucceeds)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(SETTINGS));
    lego->addChild(createSphere(4));
    const LegoSettings others = parseSettings("6,proportions=brick,palette=ldraw");
    bool isSet = false;
    surviveShortages({.mayThrow = true,
                      .prepare = [&] { lego->setSettings(parseSettings(SETTINGS)); },
                      .work = [&] { isSet = lego->setSettings(others); },
                      .getResult = [&] { return isSet ? encode(lego->getBricks()) : std::string(); }},
                     GetParam());
}

TEST_P(OutOfMemoryInLongWork, WhileAPlanIsMadeThrows)
{
    const osg::ref_ptr<const BrickModel> model = createHangingModel();
    osg::ref_ptr<const BuildingPlan> plan;
    const auto print = [&]
    {
        std::string text;
        for (const std::uint32_t part : plan->getOrder())
            text += std::to_string(part) + " ";
        return text;
    };
    surviveShortages({.mayThrow = true, .work = [&] { plan = planBuilding(*model); }, .getResult = print}, GetParam());
}

TEST_P(OutOfMemory, WhileStabilityIsComputedThrows)
{
    const osg::ref_ptr<const BrickModel> model = createHangingModel();
    std::optional<StabilityReport> report;
    surviveShortages({.mayThrow = true,
                      .work = [&] { report = computeStability(*model); },
                      .getResult = [&] { return report ? report->toString() : std::string(); }},
                     GetParam());
}

TEST_P(OutOfMemory, WhileBricksAreEncodedAndDecodedThrows)
{
    const osg::ref_ptr<const BrickModel> model = createSmallModel();
    osg::ref_ptr<const BrickModel> decoded;
    std::string error;
    surviveShortages({.mayThrow = true,
                      .work = [&] { decoded = decodeBricks(encodeBricks(*model), error); },
                      .getResult = [&] { return encode(decoded); }},
                     GetParam());
}

TEST(OutOfMemoryInAJob, ForANewRunLeavesTheLastOneOrNone)
{
    for (std::size_t call = 0, hasFailed = 1; hasFailed; ++call)
    {
        std::promise<void> release;
        BackgroundJob<int> job({});
        const auto createWork = [] { return [](auto&, std::string&) { return 1; }; };
        const auto createWaiting = [future = release.get_future().share()]
        {
            return [future](auto&, std::string&)
            {
                future.wait();
                return 1;
            };
        };
        job.request(1, true, createWaiting);
        MemoryFaults::begin(call, MemoryFaults::Extent::ONE);
        try
        {
            job.request(2, true, createWork);
        }
        catch (const std::bad_alloc&)
        {
        }
        hasFailed = MemoryFaults::end();
        release.set_value();
        const auto run = job.request(1, true, createWork).run;
        run->wait();
        EXPECT_EQ(run->getOutcome(), BackgroundJob<int>::Outcome::MADE) << "call " << call;
    }
}

} // namespace

} // namespace osgLego::test
