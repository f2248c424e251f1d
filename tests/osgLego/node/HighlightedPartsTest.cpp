#include <BuildingOrders.h>
#include <LookTest.h>
#include <Meshes.h>
#include <Notices.h>
#include <PartModels.h>

#include <tuple>
#include <vector>

namespace osgLego::test
{

namespace
{

const Viewpoint HIGHLIGHT_VIEW{{24, -30, 22}, {8, 7, 4}, {0, 0, 1}};
constexpr std::array<std::uint8_t, 3> MAGENTA{255, 0, 200};

/** Models of white parts. */
osg::ref_ptr<const BrickModel> createWhite()
{
    PartFilling filling;
    filling.heights = {1, 3};
    filling.colors = {{255, 255, 255}};
    return createParts(createPartGrid({17, 14, 9}, 0.4, UpAxis::Z), filling);
}

std::vector<std::size_t> chooseParts(const BrickModel& model)
{
    std::vector<std::size_t> parts;
    for (std::size_t part = 1; part < model.getParts().size(); part += 7)
        parts.push_back(part);
    return parts;
}

/** The same parts, some of them in another colour. */
osg::ref_ptr<const BrickModel> recolor(const BrickModel& model, const std::vector<std::size_t>& chosen)
{
    std::vector<Part> parts = model.getParts();
    for (const std::size_t part : chosen)
        parts[part].color = MAGENTA;
    return BrickModel::createOfParts(model.getGrid(), parts);
}

/** Pictures of models with highlighted parts, in each drawing and look. */
class HighlightedParts : public LookTest, public ::testing::WithParamInterface<std::tuple<const char*, const char*>>
{
protected:
    static osg::ref_ptr<LegoNode> createNode(const BrickModel& model, double progress = 1.0)
    {
        const osg::ref_ptr<LegoNode> node = createStoredNode(
            model, std::string("20,drawing=") + std::get<0>(GetParam()) + ",look=" + std::get<1>(GetParam()));
        node->setWaiting(true);
        node->setBuildProgress(progress);
        return node;
    }

    osg::ref_ptr<osg::Image> drawIn(LegoNode& node, const std::string& occlusion)
    {
        if (occlusion.empty()) return draw(node, HIGHLIGHT_VIEW);
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup(occlusion, &node);
        return draw(*group, HIGHLIGHT_VIEW);
    }
};

TEST_P(HighlightedParts, LookAsPartsOfThatColor)
{
    const osg::ref_ptr<const BrickModel> model = createWhite();
    const std::vector<std::size_t> parts = chooseParts(*model);
    for (const double progress : {1.0, 0.6})
        for (const char* occlusion : {"", "medium"})
        {
            const osg::ref_ptr<LegoNode> node = createNode(*model, progress);
            const osg::ref_ptr<osg::Image> plain = drawIn(*node, occlusion);
            ASSERT_TRUE(node->setHighlightedParts(parts, MAGENTA));
            const osg::ref_ptr<osg::Image> highlighted = drawIn(*node, occlusion);
            const osg::ref_ptr<LegoNode> expected = createNode(*recolor(*model, parts), progress);
            EXPECT_EQ(countDifferent(*highlighted, *drawIn(*expected, occlusion), 0), 0u) << progress << occlusion;
            EXPECT_GT(countDifferent(*highlighted, *plain, 60), 500u) << "visible on white";
            ASSERT_TRUE(node->setHighlightedParts({}, MAGENTA));
            EXPECT_EQ(countDifferent(*drawIn(*node, occlusion), *plain, 0), 0u) << progress << occlusion;
        }
}

INSTANTIATE_TEST_SUITE_P(DrawingsAndLooks, HighlightedParts,
                         ::testing::Combine(::testing::Values("splats", "triangles"),
                                            ::testing::Values("full", "plain")),
                         [](const auto& parameters)
                         { return std::string(std::get<0>(parameters.param)) + "_" + std::get<1>(parameters.param); });

class HighlightedPartsTest : public LookTest
{
};

TEST_F(HighlightedPartsTest, MayBeCellsWithoutParts)
{
    const osg::ref_ptr<const BrickModel> cells = createCells(*createWhite());
    const osg::ref_ptr<LegoNode> node = createStoredNode(*cells, "20");
    const std::size_t last = cells->getBricks().size() - 1; // at the top
    const osg::ref_ptr<osg::Image> plain = draw(*node, HIGHLIGHT_VIEW);
    ASSERT_TRUE(node->setHighlightedParts(std::vector{last}, MAGENTA));
    std::vector<Brick> bricks = cells->getBricks();
    bricks[last].color = MAGENTA;
    const osg::ref_ptr<LegoNode> expected = createStoredNode(*BrickModel::create(cells->getGrid(), bricks), "20");
    const osg::ref_ptr<osg::Image> highlighted = draw(*node, HIGHLIGHT_VIEW);
    EXPECT_EQ(countDifferent(*highlighted, *draw(*expected, HIGHLIGHT_VIEW), 0), 0u);
    EXPECT_GT(countDifferent(*highlighted, *plain, 60), 5u);
}

TEST_F(HighlightedPartsTest, LastUntilOtherBricksAreShown)
{
    const osg::ref_ptr<LegoNode> node = createBrickBox({8, 8, 8}, "8,device=cpu,parts=bricks", {255, 255, 255, 255});
    node->setWaiting(true);
    ASSERT_TRUE(node->setHighlightedParts(std::vector<std::size_t>{0, 1, 2, 3}, MAGENTA));
    const osg::ref_ptr<osg::Image> highlighted = draw(*node, HIGHLIGHT_VIEW);
    const unsigned int contextID = _context->getState()->getContextID();
    EXPECT_EQ(node->getStatistics(contextID).numLegolizations, 1u) << "nothing is remade";
    node->dirty();
    const osg::ref_ptr<osg::Image> remade = draw(*node, HIGHLIGHT_VIEW);
    EXPECT_GT(countDifferent(*remade, *highlighted, 60), 20u);
    node->setHighlightedParts({}, MAGENTA);
    EXPECT_EQ(countDifferent(*remade, *draw(*node, HIGHLIGHT_VIEW), 0), 0u);
}

TEST_F(HighlightedPartsTest, ThatBricksDoNotHaveAreRefused)
{
    const osg::ref_ptr<const BrickModel> model = createWhite();
    const osg::ref_ptr<LegoNode> node = createStoredNode(*model, "20");
    const std::size_t count = model->getParts().size();
    const std::string notices = noticesOf(
        [&] {
            EXPECT_FALSE(node->setHighlightedParts(std::vector{std::size_t(0), count}, MAGENTA));
        });
    EXPECT_NE(notices.find("expected 0 to " + std::to_string(count - 1)), std::string::npos) << notices;
    const osg::ref_ptr<LegoNode> empty = new LegoNode;
    EXPECT_NE(noticesOf([&] { EXPECT_FALSE(empty->setHighlightedParts(std::vector{std::size_t(0)}, MAGENTA)); })
                  .find("no bricks"),
              std::string::npos);
}

} // namespace

} // namespace osgLego::test
