#include <osgLego/store/BrickStore.h>
#include <osgLego/store/ContextBricks.h>
#include <osgLego/store/GridOcclusionTextures.h>

#include <GlTest.h>
#include <Notices.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include <osg/observer_ptr>

namespace osgLego::test
{

namespace
{

class ContextBricksTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _context->makeCurrent();
    }

    const osg::State& getState() const { return *_context->getState(); }

    void upload(const BrickSet& set) { upload(*_bricks, set); }
    void upload(ContextBricks& bricks, const BrickSet& set) const
    {
        const std::lock_guard lock(bricks.getMutex());
        bricks.upload(getState(), set);
    }

    /** The contents of a buffer. */
    std::vector<BrickPoint> read(const GlBuffer& buffer, std::size_t count) const
    {
        std::vector<BrickPoint> points(count);
        const osg::GLExtensions& extensions = *getState().get<osg::GLExtensions>();
        extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
        extensions.glGetBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(BrickPoint)),
                                      points.data());
        extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
        return points;
    }

    /** A buffer as the passes leave it. */
    GpuBricks createGpuBricks(const BrickSet& set, const std::vector<BrickPoint>& points) const
    {
        GpuBricks made;
        made.bricks = &set;
        made.buffer = GlBuffer(getState());
        made.numBricks = static_cast<GLsizei>(points.size());
        const osg::GLExtensions& extensions = *getState().get<osg::GLExtensions>();
        extensions.glBindBuffer(GL_ARRAY_BUFFER, made.buffer.get());
        extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(BrickPoint)),
                                points.data(), GL_STATIC_DRAW);
        extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
        made.statistics.numTriangles = 12;
        return made;
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<ContextBricks> _bricks = new ContextBricks;
};

/** A row of bricks, all of which are visible. */
osg::ref_ptr<const BrickModel> createRow(int count)
{
    BrickGrid grid;
    grid.dimensions = {count, 1, 1};
    std::vector<Brick> bricks;
    for (int x = 0; x < count; ++x)
        bricks.push_back({{static_cast<std::uint16_t>(x), 0, 0}, {10, 20, static_cast<std::uint8_t>(x)}});
    return BrickModel::create(grid, std::move(bricks));
}

osg::ref_ptr<const BrickSet> createSet(std::uint64_t revision, int count)
{
    return new BrickSet(revision, *createRow(count), LegoStatistics());
}

TEST_F(ContextBricksTest, UploadsThePointsOfASet)
{
    const osg::ref_ptr<const BrickSet> set = createSet(3, 20);
    EXPECT_TRUE(_bricks->isEmpty());
    upload(*set);
    EXPECT_TRUE(_bricks->isOf(3));
    EXPECT_FALSE(_bricks->isOf(2));
    EXPECT_FALSE(_bricks->isEmpty());
    EXPECT_EQ(_bricks->bricks, set);
    EXPECT_EQ(_bricks->numBricks, 20);
    EXPECT_EQ(_bricks->getModel(), set->getModel());
    EXPECT_EQ(_bricks->getStatistics().numDrawnBricks, 20u);
    // Blocks of eight cells, of 8, 8 and 4 bricks.
    EXPECT_EQ(_bricks->blocks.size(), 3u);
    const std::vector<BrickPoint> points = read(_bricks->buffer, 20);
    for (std::uint32_t x = 0; x < 20; ++x)
    {
        EXPECT_EQ(points[x][0], x);
        EXPECT_EQ(points[x][2] & 0xffffffu, 10u | 20u << 8 | x << 16) << "the colour";
    }
}

TEST_F(ContextBricksTest, CountsUploadsAndSkipsThoseOfShownAndOlderSets)
{
    const osg::ref_ptr<const BrickSet> newer = createSet(4, 5);
    upload(*newer);
    const GLuint buffer = _bricks->buffer.get();
    upload(*newer);
    upload(*createSet(3, 7));
    EXPECT_EQ(_bricks->buffer.get(), buffer);
    EXPECT_EQ(_bricks->bricks, newer);
    EXPECT_EQ(_bricks->getStatistics().numLegolizations, 1u);
    upload(*createSet(5, 6));
    EXPECT_TRUE(_bricks->isOf(5));
    EXPECT_EQ(_bricks->getStatistics().numLegolizations, 2u);
}

TEST_F(ContextBricksTest, HidesBricksOfOlderSourcesUntilNewOnesCome)
{
    upload(*createSet(4, 5));
    _bricks->hide(6);
    EXPECT_TRUE(_bricks->isEmpty());
    EXPECT_EQ(_bricks->numBricks, 0);
    EXPECT_FALSE(_bricks->bricks);
    EXPECT_EQ(_bricks->buffer.get(), 0u);
    EXPECT_TRUE(_bricks->blocks.empty());
    EXPECT_FALSE(_bricks->getModel());
    upload(*createSet(5, 5));
    EXPECT_TRUE(_bricks->isEmpty());
    const osg::ref_ptr<const BrickSet> old = createSet(5, 5);
    _bricks->show(getState(), createGpuBricks(*old, old->getPoints().points));
    EXPECT_TRUE(_bricks->isEmpty());
    upload(*createSet(6, 5));
    EXPECT_TRUE(_bricks->isOf(6));
    EXPECT_EQ(_bricks->getStatistics().numLegolizations, 2u);
}

TEST_F(ContextBricksTest, AStoreHidesTheBricksOfEveryContext)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    for (const unsigned int contextID : {0u, 1u})
        upload(*store->getContext(contextID), *createSet(4, 5));
    store->clear(5);
    EXPECT_TRUE(store->getContext(0)->isEmpty());
    EXPECT_TRUE(store->getContext(1)->isEmpty());
}

TEST_F(ContextBricksTest, AStoreReleasesTheContextOfAStateOrAll)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    const unsigned int own = getState().getContextID();
    for (const unsigned int contextID : {own, own + 1})
        upload(*store->getContext(contextID), *createSet(4, 5));
    store->releaseGLObjects(_context->getState());
    EXPECT_TRUE(store->getContext(own)->isEmpty());
    EXPECT_FALSE(store->getContext(own + 1)->isEmpty());
    store->releaseGLObjects(nullptr);
    EXPECT_TRUE(store->getContext(own + 1)->isEmpty());
}

TEST_F(ContextBricksTest, FindsTheBlocksOfBricksMadeOnTheGpu)
{
    const osg::ref_ptr<const BrickModel> model = createRow(20);
    const osg::ref_ptr<const BrickSet> set = new BrickSet(7, model->getGrid(), [model] { return model; });
    _bricks->show(getState(), createGpuBricks(*set, createBrickPoints(*model).points));
    EXPECT_TRUE(_bricks->isOf(7));
    EXPECT_EQ(_bricks->getStatistics().numTriangles, 12u);
    EXPECT_EQ(_bricks->getStatistics().numDrawnBricks, 20u);
    const std::lock_guard lock(_bricks->getMutex());
    EXPECT_TRUE(_bricks->blocks.empty()) << "until they have been read";
    glFinish();
    _bricks->pollBlocks(getState());
    EXPECT_EQ(_bricks->blocks.size(), 3u);
}

TEST_F(ContextBricksTest, DistantOcclusionWaitsForBricksMadeOnTheGpu)
{
    {
        const std::lock_guard lock(_bricks->getMutex());
        EXPECT_FALSE(_bricks->findDistantOcclusion(getState(), NearOcclusion::PICTURE)) << "there are no bricks";
    }
    const osg::ref_ptr<const BrickModel> model = createRow(20);
    const osg::ref_ptr<const BrickSet> set = new BrickSet(7, model->getGrid(), [model] { return model; });
    _bricks->show(getState(), createGpuBricks(*set, createBrickPoints(*model).points));
    const std::lock_guard lock(_bricks->getMutex());
    const DistantOcclusionTexture* occlusion = _bricks->findDistantOcclusion(getState(), NearOcclusion::PICTURE);
    ASSERT_TRUE(occlusion);
    EXPECT_EQ(_bricks->findDistantOcclusion(getState(), NearOcclusion::PICTURE), occlusion) << "created once";
    EXPECT_EQ(_bricks->blocks.size(), 3u) << "read on the way";
}

TEST_F(ContextBricksTest, TablesOfGridOcclusionRemainForTheNextViewer)
{
    osg::observer_ptr<osg::Image> table;
    osg::observer_ptr<osg::Image> studs;
    {
        BrickGrid grid;
        grid.cellSize = {1.0, 1.0, 1.3}; // a height that no other test has
        const std::vector<BrickNeighbors> neighbors(1);
        const osg::ref_ptr<GridOcclusionTextures> textures = new GridOcclusionTextures(getState(), grid, neighbors);
        table = textures->getTable().getImage();
        studs = textures->getStuds().getImage();
    }
    EXPECT_TRUE(table.valid());
    EXPECT_TRUE(studs.valid());
}

TEST_F(ContextBricksTest, GridsShareTablesUnlessTheirCellsHaveOtherProportions)
{
    const auto create = [this](double pitch, double height)
    {
        BrickGrid grid;
        grid.cellSize = {pitch, pitch, height};
        const std::vector<BrickNeighbors> neighbors(1);
        return osg::ref_ptr<GridOcclusionTextures>(new GridOcclusionTextures(getState(), grid, neighbors));
    };
    const osg::ref_ptr<GridOcclusionTextures> plates = create(1.0, 0.4);
    for (const double pitch : {0.1, 0.3, 0.7, 1.1, 3.3, 6.9})
        EXPECT_EQ(&create(pitch, 0.4 * pitch)->getTable(), &plates->getTable()) << pitch;
    EXPECT_NE(&create(1.0, 1.2)->getTable(), &plates->getTable());
    // In cells that are as flat as this, rays would meet a million of them within the radius.
    const osg::ref_ptr<GridOcclusionTextures> flat = create(1.0, 1e-6);
    EXPECT_EQ(&create(1.0, 0.1)->getTable(), &flat->getTable());
}

TEST_F(ContextBricksTest, BricksInQuickSuccessionKeepTheirDistantOcclusion)
{
    const auto show = [this](std::uint64_t revision)
    {
        const osg::ref_ptr<const BrickModel> model = createRow(20);
        const osg::ref_ptr<const BrickSet> set = new BrickSet(revision, model->getGrid(), [model] { return model; });
        _bricks->show(getState(), createGpuBricks(*set, createBrickPoints(*model).points));
        const std::lock_guard lock(_bricks->getMutex());
        return osg::ref_ptr<DistantOcclusionTexture>(_bricks->findDistantOcclusion(getState(), NearOcclusion::GRID));
    };
    const osg::ref_ptr<DistantOcclusionTexture> first = show(7);
    ASSERT_TRUE(first);
    EXPECT_EQ(show(8), first);
    EXPECT_EQ(show(9), first);
    _bricks->setAwaited(true);
    const osg::ref_ptr<DistantOcclusionTexture> awaited = show(10);
    ASSERT_TRUE(awaited);
    EXPECT_NE(awaited, first);
    _bricks->setAwaited(false);
    upload(*createSet(11, 5));
    const std::lock_guard lock(_bricks->getMutex());
    EXPECT_EQ(_bricks->findDistantOcclusion(getState(), NearOcclusion::GRID), awaited) << "not computed yet";
    const osg::ref_ptr<const BrickSet> computed = createSet(12, 5);
    computed->getDistantOcclusion(NearOcclusion::GRID);
    _bricks->upload(getState(), *computed);
    EXPECT_NE(_bricks->findDistantOcclusion(getState(), NearOcclusion::GRID), awaited);
}

TEST_F(ContextBricksTest, AFailureIsReportedOncePerSourceAndEndsItsUploads)
{
    const auto fail = [this] { _bricks->fail(4, "there is no memory"); };
    EXPECT_NE(noticesOf(fail).find("there is no memory"), std::string::npos);
    EXPECT_EQ(noticesOf(fail), "");
    EXPECT_EQ(_bricks->getFailedRevision(), 4u);
    EXPECT_EQ(_bricks->getFailure(), "there is no memory");
    upload(*createSet(4, 5));
    EXPECT_TRUE(_bricks->isEmpty());
    upload(*createSet(5, 5));
    EXPECT_TRUE(_bricks->isOf(5));
    EXPECT_EQ(_bricks->getFailure(), "");
}

TEST_F(ContextBricksTest, ReleasingForgetsFailuresSoThatTheyMayBeTriedAgain)
{
    upload(*createSet(3, 5));
    noticesOf(
        [this]
        {
            _bricks->fail(4, "there is no memory");
            _bricks->markUnsupported(getState().getContextID(), "this context is too old");
        });
    EXPECT_TRUE(_bricks->isUnsupported());
    _bricks->release();
    EXPECT_TRUE(_bricks->isEmpty());
    EXPECT_FALSE(_bricks->isUnsupported());
    EXPECT_EQ(_bricks->getFailedRevision(), 0u);
    upload(*createSet(4, 5));
    EXPECT_TRUE(_bricks->isOf(4));
}

TEST_F(ContextBricksTest, NodesInOneContextReportOnceThatItIsUnsupported)
{
    constexpr const char* WHY = "this context lacks everything";
    const osg::ref_ptr<ContextBricks> other = new ContextBricks;
    EXPECT_NE(noticesOf([this] { _bricks->markUnsupported(90, WHY); }).find(WHY), std::string::npos);
    EXPECT_EQ(noticesOf([&other] { other->markUnsupported(90, WHY); }), "");
    EXPECT_TRUE(other->isUnsupported());
    EXPECT_NE(noticesOf([&other] { other->markUnsupported(91, WHY); }).find(WHY), std::string::npos);
}

TEST_F(ContextBricksTest, UploadsASetForDrawingPartlyBuiltOnce)
{
    const osg::ref_ptr<const BrickModel> model = createRow(6);
    const osg::ref_ptr<const BuildingSet> set = new BuildingSet(4, *model, nullptr);
    const std::lock_guard lock(_bricks->getMutex());
    EXPECT_TRUE(_bricks->upload(getState(), *set));
    EXPECT_EQ(_bricks->building, set);
    const GLuint buffer = _bricks->buildingBuffer.get();
    EXPECT_NE(buffer, 0u);
    EXPECT_NE(_bricks->rankBuffer.get(), 0u);
    EXPECT_EQ(read(_bricks->buildingBuffer, set->getPoints().points.size()), set->getPoints().points);
    EXPECT_TRUE(_bricks->upload(getState(), *set));
    EXPECT_EQ(_bricks->buildingBuffer.get(), buffer);
}

} // namespace

} // namespace osgLego::test
