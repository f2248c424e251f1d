#include <osgLegoBooklet/Booklet.h>

#include <Meshes.h>
#include <PartModels.h>
#include <offscreen/OffscreenContext.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <osg/Shape>
#include <osg/ShapeDrawable>
#include <unistd.h>

namespace osgLego
{

namespace
{

using Reason = BookletError::Reason;

/** Two bricks 2x4 and one across both. */
osg::ref_ptr<LegoNode> createNode()
{
    const auto createPart = [](std::array<std::uint16_t, 3> cell, std::array<std::uint8_t, 3> size)
    {
        Part part;
        part.cell = cell;
        part.size = size;
        part.color = {180, 0, 0};
        part.colorCode = 4;
        return part;
    };
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->setStoredBricks(BrickModel::createOfParts(
        test::createPartGrid({8, 4, 2}, 1.2),
        {createPart({0, 0, 0}, {2, 4, 1}), createPart({4, 0, 0}, {2, 4, 1}), createPart({1, 0, 1}, {4, 2, 1})}));
    return lego;
}

std::string readAll(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

class BookletTest : public testing::Test
{
protected:
    BookletTest() { std::filesystem::create_directory(_folder); }
    ~BookletTest() override { std::filesystem::remove_all(_folder); }

    /** Write a booklet; all booklets of a test are drawn in the same context. */
    std::optional<BookletError> write(const LegoNode& lego, const std::string& name, const BookletOptions& options = {})
    {
        std::string error;
        if (!_context) _context = createOffscreenContext(16, 16, error);
        return writeBooklet(lego, pathOf(name), *_context, options);
    }

    std::string pathOf(const std::string& name) const { return (_folder / name).string(); }

    std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("osglego-booklet-" + std::to_string(getpid()));

private:
    osg::ref_ptr<osg::GraphicsContext> _context;
};

TEST_F(BookletTest, WritesTheSamePageTwiceInOneContext)
{
    const osg::ref_ptr<LegoNode> lego = createNode();
    std::vector<double> shares;
    BookletOptions options;
    options.progress = [&shares](double share, const std::string&) { shares.push_back(share); };
    EXPECT_FALSE(write(*lego, "new/small_tower.html", options));
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GE(shares.size(), 4u); // the cover, a part, a step, and the finished model
    EXPECT_FALSE(lego->getBuildingPlan());

    const std::string page = readAll(pathOf("new/small_tower.html"));
    EXPECT_NE(page.find("<h1>Small Tower</h1>"), std::string::npos);
    EXPECT_NE(page.find("<dt>Parts</dt><dd>3</dd>"), std::string::npos);
    EXPECT_NE(page.find("download=\"small_tower.mpd\""), std::string::npos);
    EXPECT_FALSE(write(*lego, "small_tower.html"));
    EXPECT_TRUE(readAll(pathOf("small_tower.html")) == page) << "the second page differs";
}

TEST_F(BookletTest, KeepsTheOlderFileAndLeavesNoFolderIfItIsCancelled)
{
    const osg::ref_ptr<LegoNode> lego = createNode();
    std::ofstream(pathOf("old.html")) << "older";
    BookletOptions options;
    bool isCancelled = false;
    options.isCancelled = [&isCancelled] { return isCancelled; };
    options.progress = [&isCancelled](double, const std::string& work) { isCancelled = work.starts_with("step"); };
    for (const char* file : {"old.html", "new/old.html"})
    {
        isCancelled = false;
        const std::optional<BookletError> error = write(*lego, file, options);
        ASSERT_TRUE(error);
        EXPECT_EQ(error->reason, Reason::CANCELLED);
    }
    EXPECT_EQ(readAll(pathOf("old.html")), "older");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(_folder), {}), 1);
}

TEST_F(BookletTest, GivesTheReasonForAFailure)
{
    const osg::ref_ptr<LegoNode> lego = createNode();
    std::optional<BookletError> error = checkBookletFile(pathOf("no/folder/tower.html"));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->reason, Reason::BAD_FILE);
    EXPECT_NE(error->message.find("can't write '" + pathOf("no/folder/tower.html") + "': there is no folder"),
              std::string::npos);
    EXPECT_FALSE(checkBookletFile(pathOf("new/tower.html")));
    error = checkBookletFile(pathOf("new/" + std::string(251, 'a') + ".html"));
    ASSERT_TRUE(error);
    EXPECT_NE(error->message.find("File name too long; expected another name"), std::string::npos) << error->message;
    EXPECT_FALSE(std::filesystem::exists(pathOf("new")));

    BookletOptions options;
    options.modelName = "'tower.mpd'";
    options.steps = {2, 3};
    error = write(*lego, "new/tower.html", options);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->reason, Reason::BAD_STEPS);
    EXPECT_EQ(error->message, "'tower.mpd' has no steps 2-3; expected FIRST-LAST from 1 to 1, the number of steps");

    options.steps = {3, 2};
    error = write(*lego, "new/tower.html", options);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->reason, Reason::BAD_STEPS);
    EXPECT_EQ(error->message, "'tower.mpd' has no steps 3-2; expected FIRST-LAST, counted from 1");

    const osg::ref_ptr<LegoNode> empty = new LegoNode;
    error = write(*empty, "new/tower.html");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->reason, Reason::BAD_MODEL);
    EXPECT_EQ(error->message, "the model has no parts to build; expected parts=bricks among its settings");
    EXPECT_TRUE(std::filesystem::is_empty(_folder));
}

TEST_F(BookletTest, ReportsMissingPartsBeforeBricksAreMade)
{
    struct Counter : LegoNode::BricksCallback
    {
        void ready() override { ++numReady; }
        int numReady = 0;
    };
    const osg::ref_ptr<Counter> counter = new Counter;
    for (const bool isBooklet : {true, false})
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode;
        lego->addChild(new osg::ShapeDrawable(new osg::Sphere));
        lego->setBricksCallback(counter);
        if (isBooklet)
            EXPECT_TRUE(write(*lego, "ball.html"));
        else
            EXPECT_TRUE(lego->getBricks());
        lego = nullptr; // waits for the thread that calls ready()
        EXPECT_EQ(counter->numReady, isBooklet ? 0 : 1);
    }
}

TEST_F(BookletTest, GivesTheObstacleIfThereAreNoBricks)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    LegoSettings settings;
    settings.grid.cellPitch = 1e-9;
    settings.grid.proportions = Proportions::BRICK;
    settings.parts.set = PartSet::BRICKS;
    lego->setSettings(settings);
    lego->addChild(test::createSphere(4));
    const std::string obstacle = lego->getObstacle();
    ASSERT_FALSE(obstacle.empty());
    const std::optional<BookletError> error = write(*lego, "tower.html");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->message, "the model has no bricks: " + obstacle);
}

TEST_F(BookletTest, StoredBricksNeedNoPalette)
{
    const osg::ref_ptr<LegoNode> lego = createNode();
    LegoSettings settings = lego->getSettings();
    settings.colors.palette = "no-such-palette.csv";
    ASSERT_TRUE(lego->setSettings(settings));
    EXPECT_FALSE(write(*lego, "tower.html"));
}

TEST_F(BookletTest, PrintsTheStabilityThatIsKnown)
{
    StabilityReport unsafe;
    unsafe.safe = false;
    BookletOptions options;
    options.stability = unsafe;
    EXPECT_FALSE(write(*createNode(), "tower.html", options));
    EXPECT_NE(readAll(pathOf("tower.html")).find("parts that are worn may not hold it"), std::string::npos);
    EXPECT_FALSE(write(*createNode(), "tower.html"));
    EXPECT_EQ(readAll(pathOf("tower.html")).find("parts that are worn may not hold it"), std::string::npos);
}

TEST_F(BookletTest, FollowsAPlanOfItsPartsAndNoOther)
{
    const osg::ref_ptr<LegoNode> lego = createNode();
    EXPECT_FALSE(write(*lego, "own/tower.html"));
    const std::string own = readAll(pathOf("own/tower.html"));

    // Parts one by one, in another order than that of the planner.
    const auto createSteps = [](const std::vector<std::uint32_t>& parts)
    {
        std::vector<BuildingStep> steps;
        for (const std::uint32_t part : parts)
            steps.emplace_back().parts = {part};
        return steps;
    };
    BookletOptions options;
    options.plan = BuildingPlan::create(3, createSteps({1, 0, 2}));
    std::string works;
    options.progress = [&works](double, const std::string& work) { works += work + '\n'; };
    EXPECT_FALSE(write(*lego, "given/tower.html", options));
    const std::string given = readAll(pathOf("given/tower.html"));
    EXPECT_EQ(works.find("planning"), std::string::npos) << works;
    EXPECT_EQ(own.find("id=\"step-3\""), std::string::npos);
    EXPECT_NE(given.find("id=\"step-3\""), std::string::npos);

    options.plan = BuildingPlan::create(2, createSteps({0, 1}));
    EXPECT_FALSE(write(*lego, "other/tower.html", options));
    EXPECT_EQ(readAll(pathOf("other/tower.html")), own);
}

TEST(BookletNameTest, NamesBookletsAfterTheModelAndNotItsSettings)
{
    EXPECT_EQ(nameBooklet("models/bunny.ply"), "bunny");
    EXPECT_EQ(nameBooklet("models/bunny.ply.64.legolize"), "bunny");
    EXPECT_EQ(nameBooklet("bunny.ply.(64,palette=/a/b.csv).legolize"), "bunny");
    EXPECT_EQ(nameBooklet("bunny.ply.[64,edge=0.5].legolize"), "bunny");
    EXPECT_EQ(nameBooklet("models.64/bunny.legolize"), "bunny");
    EXPECT_EQ(nameBooklet("bunny.ply.8.LEGOLIZE.(16,up=y).legolize"), "bunny");
    EXPECT_EQ(nameBooklet("tower.mpd"), "tower");
    EXPECT_EQ(nameBooklet("models/mug.ply.90,0,0.rot"), "mug");
    EXPECT_EQ(nameBooklet("mug.ply.(0.5,0.5,0.5).scale.0,0,1.TRANS.24.legolize"), "mug");
    EXPECT_EQ(nameBooklet("mug.rot"), "mug");
    EXPECT_EQ(nameBooklet("models.64/mug.rot"), "mug");
}

} // namespace osgLego
