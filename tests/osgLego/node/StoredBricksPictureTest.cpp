#include <common/RacingCar.h>
#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>

#include <GlTest.h>
#include <Meshes.h>

#include <memory>

namespace osgLego::test
{

namespace
{

/** A node with a car and one with only its bricks, in contexts of their own. */
class StoredBricksPicture : public GlTest
{
protected:
    osg::ref_ptr<LegoNode> createCar(const std::string& settings)
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->addChild(createRacingCar());
        lego->setWaiting(true);
        return lego;
    }

    osg::ref_ptr<LegoNode> createStored(const LegoNode& lego)
    {
        osg::ref_ptr<LegoNode> stored = new LegoNode(lego.getSettings());
        stored->setStoredBricks(lego.getBricks().get());
        return stored;
    }

    /** The picture of a scene after a few frames. */
    osg::ref_ptr<osg::Image> draw(osg::Node& scene)
    {
        _viewer = std::make_unique<osgViewer::Viewer>();
        _context = createContext();
        setUpViewer(*_viewer, *_context, scene);
        for (int frame = 0; frame < 2; ++frame)
            _viewer->frame();
        return readPixels(*_context);
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    std::unique_ptr<osgViewer::Viewer> _viewer; // of the last picture
};

TEST_F(StoredBricksPicture, EveryLookIsThatOfTheBricksOfASource)
{
    for (const char* settings : {"20,device=cpu,drawing=triangles", "20,device=cpu,drawing=splats",
                                 "20,device=cpu,look=plain", "16,device=cpu,proportions=plate,up=y"})
    {
        const osg::ref_ptr<LegoNode> lego = createCar(settings);
        const osg::ref_ptr<LegoNode> stored = createStored(*lego);
        BrickAppearance appearance;
        appearance.joints = false;
        for (LegoNode* node : {lego.get(), stored.get()})
            node->setAppearance(appearance);
        const osg::ref_ptr<osg::Image> expected = draw(*lego);
        EXPECT_GT(countDrawn(*expected), 3000u);
        EXPECT_EQ(countDifferent(*draw(*stored), *expected, 1), 0u) << settings;
    }
}

TEST_F(StoredBricksPicture, AmbientOcclusionIsThatOfTheBricksOfASource)
{
    const osg::ref_ptr<LegoNode> lego = createCar("20,device=cpu");
    osg::ref_ptr<osg::Image> pictures[2];
    for (int index = 0; index < 2; ++index)
    {
        const osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
        scene->addChild(index == 0 ? lego : createStored(*lego));
        pictures[index] = draw(*scene);
    }
    EXPECT_EQ(countDifferent(*pictures[0], *pictures[1], 1), 0u);
}

TEST_F(StoredBricksPicture, PartsHaveTheColorsOfTheirLoadIfTheSettingsAskForIt)
{
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, 1.2};
    grid.dimensions = {12, 12, 4};
    const auto createBlock = [&grid](const std::array<std::uint8_t, 3>& color)
    {
        // So many parts that their loads are not known before the first frame, unless it waits for them.
        std::vector<Part> parts;
        for (std::uint16_t z = 0; z < 4; ++z)
            for (std::uint16_t y = 0; y < 12; y += 2)
                for (std::uint16_t x = 0; x < 12; x += 2)
                    parts.push_back({{x, y, z}, {2, 2, 1}, color});
        return BrickModel::createOfParts(grid, std::move(parts));
    };
    const osg::ref_ptr<LegoNode> blue = new LegoNode;
    blue->setStoredBricks(createBlock({49, 84, 190})); // the colour of parts that nothing pulls at
    const std::array<std::uint8_t, 3> own{200, 0, 0};
    const osg::ref_ptr<LegoNode> red = new LegoNode;
    red->setStoredBricks(createBlock(own));
    red->setWaiting(true);
    const osg::ref_ptr<osg::Image> expected = draw(*blue);
    EXPECT_GT(countDrawn(*expected), 1000u);
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *_context, *red);
    const auto drawNext = [&]
    {
        viewer.frame();
        return readPixels(*_context);
    };
    EXPECT_GT(countDifferent(*drawNext(), *expected, 1), 1000u);
    LegoSettings settings;
    settings.view.show = Show::LOAD;
    red->setSettings(settings);
    EXPECT_EQ(countDifferent(*drawNext(), *expected, 1), 0u) << "the first frame";
    EXPECT_TRUE(red->isLegolized(_context->getState()->getContextID()));
    EXPECT_EQ(red->getBricks()->getParts()[0].color, own);
    red->setSettings({});
    EXPECT_GT(countDifferent(*drawNext(), *expected, 1), 1000u);
}

TEST_F(StoredBricksPicture, StatisticsSayThatTheyAreStored)
{
    const osg::ref_ptr<LegoNode> stored = createStored(*createCar("20"));
    stored->setReadBack(true);
    EXPECT_GT(countDrawn(*draw(*stored)), 3000u);
    const unsigned int contextID = _context->getState()->getContextID();
    EXPECT_TRUE(stored->isLegolized(contextID));
    const LegoStatistics statistics = stored->getStatistics(contextID);
    EXPECT_TRUE(statistics.isStored);
    EXPECT_FALSE(statistics.isFromCpu);
    EXPECT_EQ(statistics.numTriangles, 0u);
    EXPECT_EQ(statistics.numLegolizations, 1u);
    EXPECT_EQ(statistics.numDrawnBricks, stored->getStoredBricks()->getNumVisible());
    EXPECT_EQ(stored->getBricks(contextID), stored->getStoredBricks());
}

TEST_F(StoredBricksPicture, TheNextFrameShowsWhatWasSet)
{
    osg::ref_ptr<LegoNode> lego = createCar("20,device=cpu");
    const osg::ref_ptr<const BrickModel> bricks = lego->getBricks();
    osgViewer::Viewer viewer;
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    setUpViewer(viewer, *context, *lego);
    const auto drawNext = [&]
    {
        viewer.frame();
        return readPixels(*context);
    };
    const osg::ref_ptr<osg::Image> car = drawNext();
    const osg::BoundingSphere bound = lego->getBound();
    lego->setStoredBricks(BrickModel::create(BrickGrid(), {}));
    EXPECT_EQ(countDrawn(*drawNext()), 0u) << "no bricks";
    lego->setStoredBricks(bricks);
    EXPECT_EQ(countDifferent(*drawNext(), *car, 1), 0u) << "stored bricks";
    lego->setStoredBricks(BrickModel::create(BrickGrid(), {}));
    EXPECT_EQ(countDrawn(*drawNext()), 0u) << "no bricks again";
    lego->setStoredBricks(nullptr);
    EXPECT_EQ(countDifferent(*drawNext(), *car, 1), 0u) << "the source";
    viewer.frame();
    EXPECT_EQ(lego->getBound(), bound);
}

} // namespace

} // namespace osgLego::test
