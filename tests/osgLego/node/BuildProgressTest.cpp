#include <BuildingOrders.h>
#include <LookTest.h>
#include <PartModels.h>

#include <future>
#include <tuple>

namespace osgLego::test
{

namespace
{

const Viewpoint ABOVE{{24, -30, 22}, {8, 7, 4}, {0, 0, 1}};
const Viewpoint BELOW{{-10, -22, -16}, {8, 7, 4}, {0, 0, 1}};
const std::vector<std::array<std::uint8_t, 3>> COLORS{{200, 30, 30}, {30, 60, 200}, {240, 240, 240}, {20, 20, 20}};

osg::ref_ptr<const BrickModel> createModel(UpAxis up = UpAxis::Z)
{
    PartFilling filling;
    filling.heights = {1, 3};
    filling.colors = COLORS;
    filling.isCovered = [](const glm::ivec3& cell) { return cell.x < 13 || cell.z < 5; };
    return createParts(createPartGrid({17, 14, 9}, 0.4, up), filling);
}

double shareOf(std::size_t numPlaced, const BrickModel& model)
{
    return static_cast<double>(numPlaced) / static_cast<double>(model.getParts().size());
}

/** Pictures of models that are partly built. */
class BuildProgress : public LookTest, public ::testing::WithParamInterface<std::tuple<const char*, const char*>>
{
protected:
    static std::string getSettings()
    {
        return std::string("20,drawing=") + std::get<0>(GetParam()) + ",look=" + std::get<1>(GetParam());
    }

    /** A node that waits for its plan. */
    static osg::ref_ptr<LegoNode> createNode(const BrickModel& model)
    {
        const osg::ref_ptr<LegoNode> node = createStoredNode(model, getSettings());
        node->setWaiting(true);
        // Of a model partly built, it is the share of parts in place of that of the whole model.
        BrickAppearance appearance;
        appearance.distantOcclusion = false;
        node->setAppearance(appearance);
        return node;
    }

    osg::ref_ptr<osg::Image> drawIn(LegoNode& node, const Viewpoint& viewpoint, const std::string& occlusion)
    {
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup(occlusion, &node);
        return draw(*group, viewpoint);
    }

    /** Splats of adjacent bricks overlap by 0.002 pixels; where they do, the one that is drawn first is shown. */
    static std::size_t getTolerance() { return std::get<0>(GetParam()) == std::string("splats") ? 6 : 0; }
};

TEST_P(BuildProgress, ShowsAModelOfThePartsInPlace)
{
    for (const UpAxis up : {UpAxis::Z, UpAxis::Y})
    {
        const osg::ref_ptr<const BrickModel> model = createModel(up);
        const std::vector<std::uint32_t> order = createRandomOrder(*model, 7);
        const std::size_t numParts = order.size();
        const osg::ref_ptr<LegoNode> node = createNode(*model);
        node->setBuildingPlan(createPlan(order).get());
        for (const std::size_t numPlaced : {std::size_t(0), std::size_t(1), numParts / 3, numParts / 2, numParts - 1})
        {
            ASSERT_TRUE(node->setBuildProgress(shareOf(numPlaced, *model)));
            const osg::ref_ptr<LegoNode> placed = createNode(*createPlacedModel(*model, order, numPlaced));
            for (const Viewpoint& viewpoint : {ABOVE, BELOW})
                EXPECT_LE(countDifferent(*draw(*node, viewpoint), *draw(*placed, viewpoint), 0), getTolerance())
                    << numPlaced << " of " << numParts;
            EXPECT_LE(countDifferent(*drawIn(*node, ABOVE, "medium,distant=off"),
                                     *drawIn(*placed, ABOVE, "medium,distant=off"), 1),
                      getTolerance())
                << numPlaced << " of " << numParts << ", occluded";
        }
    }
}

TEST_P(BuildProgress, TheCellsInPlaceOccludeEachOther)
{
    const osg::ref_ptr<const BrickModel> model = createModel();
    const std::vector<std::uint32_t> order = createRandomOrder(*model, 8);
    const auto createOccluded = [](const BrickModel& shown, BrickOcclusion occlusion)
    {
        osg::ref_ptr<LegoNode> node = createNode(shown);
        BrickAppearance appearance;
        appearance.occlusion = occlusion;
        appearance.distantOcclusion = false;
        node->setAppearance(appearance);
        return node;
    };
    const osg::ref_ptr<LegoNode> node = createOccluded(*model, BrickOcclusion::GRID);
    node->setBuildingPlan(createPlan(order).get());
    for (const std::size_t numPlaced : {order.size() / 2, order.size() / 5, order.size() - 1})
    {
        node->setBuildProgress(shareOf(numPlaced, *model));
        const osg::ref_ptr<const BrickModel> placed = createPlacedModel(*model, order, numPlaced);
        for (const Viewpoint& viewpoint : {ABOVE, BELOW})
        {
            const osg::ref_ptr<osg::Image> picture = draw(*createOccluded(*placed, BrickOcclusion::GRID), viewpoint);
            if (std::get<1>(GetParam()) == std::string("full"))
            {
                EXPECT_GT(countDifferent(*picture, *draw(*createOccluded(*placed, BrickOcclusion::OFF), viewpoint), 8),
                          50u);
            }
            EXPECT_LE(countDifferent(*draw(*node, viewpoint), *picture, 1), getTolerance())
                << numPlaced << " of " << order.size();
        }
    }
}

TEST_P(BuildProgress, ShowsBricksWithoutPartsFromBottomToTop)
{
    const osg::ref_ptr<const BrickModel> cells = createCells(*createModel());
    const osg::ref_ptr<LegoNode> node = createNode(*cells);
    const std::size_t numPlaced = cells->getBricks().size() / 2;
    node->setBuildProgress(static_cast<double>(numPlaced) / static_cast<double>(cells->getBricks().size()));
    const std::vector<Brick> lower(cells->getBricks().begin(),
                                   cells->getBricks().begin() + static_cast<std::ptrdiff_t>(numPlaced));
    const osg::ref_ptr<LegoNode> placed = createNode(*BrickModel::create(cells->getGrid(), lower));
    EXPECT_LE(countDifferent(*draw(*node, ABOVE), *draw(*placed, ABOVE), 0), getTolerance());
}

TEST_P(BuildProgress, TheWholeModelLooksAsWithoutProgress)
{
    const osg::ref_ptr<const BrickModel> model = createModel();
    const osg::ref_ptr<LegoNode> node = createNode(*model);
    node->setBuildProgress(0.3);
    const osg::ref_ptr<osg::Image> some = draw(*node, ABOVE);
    const osg::ref_ptr<osg::Image> all = draw(*createNode(*model), ABOVE);
    EXPECT_GT(countDifferent(*some, *all, 8), 1000u);
    // All parts, but still drawn from the points for incomplete models.
    node->setBuildProgress(1.0 - 1e-9);
    EXPECT_LE(countDifferent(*draw(*node, ABOVE), *all, 0), getTolerance());
    node->setBuildProgress(1.0);
    EXPECT_EQ(countDifferent(*draw(*node, ABOVE), *all, 0), 0u);
    const osg::ref_ptr<osg::Image> occluded = drawIn(*node, ABOVE, "medium");
    EXPECT_EQ(countDifferent(*occluded, *drawIn(*createNode(*model), ABOVE, "medium"), 0), 0u);
}

TEST_P(BuildProgress, NewPartsKeepTheirColorsAndEarlierPartsFade)
{
    // Seen from above: the left part is earlier than the right one.
    std::vector<Part> parts(2);
    for (Part& part : parts)
    {
        part.size = {4, 4, 1};
        part.color = {200, 20, 20};
    }
    parts[1].cell = {6, 0, 0};
    const osg::ref_ptr<const BrickModel> model = BrickModel::createOfParts(createPartGrid({10, 4, 1}), parts);
    const osg::ref_ptr<LegoNode> node = createNode(*model);
    BrickAppearance appearance;
    appearance.variation = 0.0;
    node->setAppearance(appearance);
    node->setBuildingPlan(createPlan({0, 1}).get());
    const Viewpoint viewpoint{{5, 2, 50}, {5, 2, 0}, {0, 1, 0}, 12};
    const auto colorsOf = [&](const osg::Image& image) {
        return std::pair(colorAt(image, {2, 2, 1}), colorAt(image, {8, 2, 1}));
    };
    const auto [left, right] = colorsOf(*draw(*node, viewpoint));
    EXPECT_NEAR(left.y(), right.y(), 0.02);
    node->setNumNewParts(1);
    const auto [faded, added] = colorsOf(*draw(*node, viewpoint));
    EXPECT_LT((added - right).length(), 0.03);
    EXPECT_GT(faded.y(), left.y() + 0.2) << "paler";
    EXPECT_GT(faded.x(), faded.y() + 0.08) << "still red";
    node->setNumNewParts(2);
    EXPECT_NEAR(colorsOf(*draw(*node, viewpoint)).first.y(), left.y(), 0.02);
    node->setNumNewParts(1000);
    EXPECT_NEAR(colorsOf(*draw(*node, viewpoint)).first.y(), left.y(), 0.02);
}

/** The number of pixels in a row of a picture, at a world position, that differ from their neighbourhood: those of a
 * line that crosses the row. */
double lineWidthAt(const osg::Image& image, int row, int first, int last)
{
    const double face = brightnessAt(image, first, row);
    const double ink = face > 0.4 ? 0.0 : 1.0;
    double extreme = face;
    for (int column = first; column <= last; ++column)
        if (std::abs(brightnessAt(image, column, row) - face) > std::abs(extreme - face))
            extreme = brightnessAt(image, column, row);
    EXPECT_LT(std::abs(extreme - ink), std::abs(face - ink)) << "dark on light parts, light on dark ones";
    double width = 0.0;
    for (int column = first; column <= last; ++column)
        width += (brightnessAt(image, column, row) - face) / (extreme - face);
    return width;
}

TEST_P(BuildProgress, OutlinesHaveAConstantWidthBetweenPartsAndNoneIsInsideAPart)
{
    for (const std::uint8_t shade : {std::uint8_t(230), std::uint8_t(10)})
        for (const double height : {6.0, 3.0}) // of the picture, in cells
        {
            // A wall of two parts, four cells long each, with the joint between them in the middle of the picture.
            std::vector<Part> parts(2);
            for (Part& part : parts)
            {
                part.size = {4, 1, 4};
                part.color = {shade, shade, shade};
            }
            parts[1].cell = {4, 0, 0};
            const osg::ref_ptr<LegoNode> node =
                createNode(*BrickModel::createOfParts(createPartGrid({8, 1, 4}), parts));
            BrickAppearance appearance;
            appearance.variation = 0.0;
            appearance.joints = false;
            appearance.outline = 4.0;
            ASSERT_TRUE(node->setAppearance(appearance));
            const osg::ref_ptr<osg::Image> image = draw(*node, {{4, -30, 2}, {4, 0, 2}, {0, 0, 1}, height});
            const int cell = static_cast<int>(HEIGHT / height);
            const int row = HEIGHT / 2 + cell / 4;
            EXPECT_NEAR(lineWidthAt(*image, row, WIDTH / 2 - cell / 3, WIDTH / 2 + cell / 3), 4.0, 0.3)
                << int(shade) << " " << height;
            const double face = brightnessAt(*image, WIDTH / 2 - cell / 2, row);
            EXPECT_NEAR(brightnessAt(*image, WIDTH / 2 - cell, row), face, 0.02) << "between cells of a part";
        }
}

TEST_P(BuildProgress, OutlinesShowPartsHollowFromBelow)
{
    std::vector<Part> parts(3);
    parts[0].size = {4, 2, 1};
    parts[1].cell = {0, 2, 0};
    parts[1].size = {4, 1, 1};
    parts[2].cell = {4, 0, 0};
    parts[2].size = {1, 3, 1};
    for (Part& part : parts)
        part.color = {200, 200, 200};
    const osg::ref_ptr<LegoNode> node = createNode(*BrickModel::createOfParts(createPartGrid({5, 3, 1}), parts));
    BrickAppearance appearance;
    appearance.variation = 0.0;
    appearance.joints = false;
    const Viewpoint below{{2.5, 1.5, -30}, {2.5, 1.5, 0}, {0, 1, 0}, 4};
    const auto brightnessOf = [&](float outline)
    {
        appearance.outline = outline;
        EXPECT_TRUE(node->setAppearance(appearance));
        const osg::ref_ptr<osg::Image> image = draw(*node, below);
        return [this, image](double x, double y) { return colorAt(*image, {x, y, 0.0}).y(); };
    };
    const auto flat = brightnessOf(0.0f);
    const auto drawn = brightnessOf(0.5f);
    const auto isHollow = [&](double x, double y)
    {
        const double relative = drawn(x, y) / flat(x, y);
        EXPECT_TRUE(std::abs(relative - 1.0) < 0.1 || relative < 0.85) << x << " " << y << ": " << relative;
        return relative < 0.85;
    };
    for (const double x : {1.0, 2.0, 3.0})
    {
        EXPECT_TRUE(isHollow(x, 1.0)) << "the hole of a tube";
        EXPECT_FALSE(isHollow(x + 0.354, 1.0)) << "a tube";
        EXPECT_FALSE(isHollow(x, 0.646)) << "a tube";
        EXPECT_FALSE(isHollow(x, 2.5)) << "a pin";
    }
    for (const double x : {0.5, 1.5, 2.5, 3.5})
    {
        EXPECT_TRUE(isHollow(x, 0.4)) << "between walls and tubes";
        EXPECT_TRUE(isHollow(x, 2.5)) << "between pins";
        for (const double y : {0.09, 1.91, 2.09, 2.91})
            EXPECT_FALSE(isHollow(x, y)) << "a wall";
    }
    for (const double y : {1.0, 2.0})
        EXPECT_FALSE(isHollow(4.5, y)) << "a pin";
    for (const double y : {0.5, 1.5, 2.5})
        EXPECT_TRUE(isHollow(4.5, y)) << "between pins";
}

TEST_P(BuildProgress, OutlinesAreLeftOutWhereCellsAreAsSmallAsLines)
{
    const osg::ref_ptr<LegoNode> node = createNode(*createModel());
    const Viewpoint far{{8, -300, 4}, {8, 0, 4}, {0, 0, 1}, HEIGHT / 2.5}; // 2.5 pixels per cell
    const osg::ref_ptr<osg::Image> without = draw(*node, far);
    BrickAppearance appearance = node->getAppearance();
    appearance.outline = 1.0;
    node->setAppearance(appearance);
    EXPECT_EQ(countDifferent(*draw(*node, far), *without, 0), 0u);
}

TEST_P(BuildProgress, FollowsASourceThatChanges)
{
    const auto createBox = [](float width)
    {
        const osg::ref_ptr<LegoNode> node = createBrickBox({width, 10, 8}, getSettings() + ",progress=0.5,device=cpu");
        node->setWaiting(true);
        return node;
    };
    const osg::ref_ptr<LegoNode> node = createBox(10);
    const osg::ref_ptr<osg::Image> before = draw(*node, ABOVE);
    const osg::ref_ptr<LegoNode> other = createBox(15);
    node->setChild(0, other->getChild(0));
    const osg::ref_ptr<osg::Image> after = draw(*node, ABOVE);
    EXPECT_GT(countDifferent(*after, *before, 8), 500u);
    EXPECT_EQ(countDifferent(*after, *draw(*other, ABOVE), 0), 0u);
}

/** Tells when it is called. */
class Announcement : public LegoNode::BricksCallback
{
public:
    void ready() override { _promise.set_value(); }
    void wait() { _promise.get_future().wait(); }

private:
    ~Announcement() override = default;

    std::promise<void> _promise;
};

TEST_P(BuildProgress, AppearsInTheFrameAfterItsOrderWasAnnounced)
{
    const osg::ref_ptr<const BrickModel> model = createModel();
    const osg::ref_ptr<LegoNode> waiting = createNode(*model);
    waiting->setBuildProgress(0.5);
    const osg::ref_ptr<LegoNode> node = createStoredNode(*model, getSettings());
    node->setAppearance(waiting->getAppearance());
    const osg::ref_ptr<Announcement> announcement = new Announcement;
    node->setBricksCallback(announcement);
    node->setBuildProgress(0.5);
    draw(*node, ABOVE); // all parts, or those in place
    announcement->wait();
    EXPECT_EQ(countDifferent(*draw(*node, ABOVE), *draw(*waiting, ABOVE), 0), 0u);
}

INSTANTIATE_TEST_SUITE_P(Drawings, BuildProgress,
                         ::testing::Combine(::testing::Values("triangles", "splats"),
                                            ::testing::Values("full", "plain")),
                         [](const auto& instance)
                         { return std::string(std::get<0>(instance.param)) + "_" + std::get<1>(instance.param); });

} // namespace

} // namespace osgLego::test
