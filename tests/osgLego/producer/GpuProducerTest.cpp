#include <osgLego/data/BrickNeighbors.h>
#include <osgLego/node/LegoPipeline.h>

#include <common/RacingCar.h>

#include <GlTest.h>
#include <Meshes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <osg/Group>
#include <osgUtil/CullVisitor>

namespace osgLego::test
{

namespace
{

/** Draws only the bricks that a pipeline makes of a source. */
class PipelineNode : public osg::Node
{
public:
    PipelineNode(LegoPipeline& pipeline, osg::Node& source) : _pipeline(&pipeline), _source(&source)
    {
        setCullingActive(false);
        setNumChildrenRequiringUpdateTraversal(1);
    }

    void traverse(osg::NodeVisitor& visitor) override
    {
        if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR)
        {
            _pipeline->refresh(*_source);
            _pipeline->update(visitor);
        }
        else if (osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor())
            _pipeline->cull(*cullVisitor);
    }
    osg::BoundingSphere computeBound() const override { return _source->getBound(); }

private:
    osg::ref_ptr<LegoPipeline> _pipeline;
    osg::ref_ptr<osg::Node> _source;
};

class GpuProducerTest : public GlTest
{
};

TEST_F(GpuProducerTest, BlocksArriveWithoutABlockingReadBack)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    const osg::ref_ptr<osg::Node> source = createSphere(20);
    const osg::ref_ptr<LegoPipeline> pipeline = new LegoPipeline(parseSettings("40"), {});
    osg::ref_ptr<PipelineNode> node = new PipelineNode(*pipeline, *source);
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *node);
    viewer.frame();
    const osg::ref_ptr<osg::Image> whole = readPixels(*context);
    const osg::ref_ptr<ContextBricks> bricks = pipeline->getStore().getContext(context->getState()->getContextID());
    ASSERT_FALSE(bricks->isEmpty());

    // All commands of the first frame are complete now, since its pixels have been read.
    viewer.frame();
    std::set<std::tuple<int, int, int>> places;
    int next = 0;
    for (const BrickBlock& block : bricks->blocks)
    {
        EXPECT_EQ(block.first, next);
        next += block.count;
        const glm::ivec3 place = block.minimum / BrickPoints::BLOCK_SIDE;
        EXPECT_TRUE(places.insert({place.x, place.y, place.z}).second) << "the bricks of a block are not consecutive";
    }
    EXPECT_EQ(next, bricks->numBricks);
    EXPECT_EQ(countDifferent(*whole, *readPixels(*context), 0), 0u);
}

/** The first values of a buffer. */
template <typename Value>
std::vector<Value> readBuffer(const osg::State& state, GLuint buffer, std::size_t count)
{
    std::vector<Value> values(count);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    extensions.glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(Value)),
                                  values.data());
    extensions.glBindBuffer(GL_COPY_READ_BUFFER, 0);
    return values;
}

/** The neighbours of each covered cell, found on the CPU. */
std::map<std::array<std::uint16_t, 3>, BrickNeighbors> findNeighborsOnCpu(const BrickModel& model)
{
    std::vector<Brick> cells = model.getBricks();
    const auto blockOf = [](const Brick& brick)
    {
        const glm::ivec3 block = brick.getCell() / BrickPoints::BLOCK_SIDE;
        return std::tuple(block.z, block.y, block.x);
    };
    std::ranges::stable_sort(cells, {}, blockOf);
    std::vector<BrickPoint> points;
    for (const Brick& brick : cells)
        points.push_back(packBrick(brick));
    const std::vector<BrickNeighbors> neighbors = createBrickNeighbors(points);
    std::map<std::array<std::uint16_t, 3>, BrickNeighbors> result;
    for (std::size_t index = 0; index < cells.size(); ++index)
        result[cells[index].cell] = neighbors[index];
    return result;
}

TEST_F(GpuProducerTest, NeighboursAreThoseThatTheCpuFinds)
{
    for (const char* settings : {"20", "33,up=y,proportions=plate", "24,method=points", "20,edge=1"})
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        const osg::ref_ptr<osg::Node> source = createRacingCar();
        const osg::ref_ptr<LegoPipeline> pipeline = new LegoPipeline(parseSettings(settings), {});
        pipeline->setReadBack(true);
        BrickAppearance appearance;
        appearance.occlusion = BrickOcclusion::GRID;
        appearance.distantOcclusion = false; // which the CPU finds
        pipeline->getDisplay().setAppearance(appearance);
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *new PipelineNode(*pipeline, *source));
        viewer.frame();
        const osg::State& state = *context->getState();
        const osg::ref_ptr<ContextBricks> bricks = pipeline->getStore().getContext(state.getContextID());
        const osg::ref_ptr<const BrickModel> model = bricks->getModel();
        ASSERT_TRUE(model) << settings;
        ASSERT_TRUE(context->makeCurrent());
        {
            const std::lock_guard lock(bricks->getMutex());
            const auto count = static_cast<std::size_t>(bricks->numBricks);
            ASSERT_GT(count, 300u);
            const std::vector<BrickPoint> points = readBuffer<BrickPoint>(state, bricks->buffer.get(), count);
            const GridOcclusionTextures* occlusion = bricks->findGridOcclusion(state);
            ASSERT_TRUE(occlusion);
            const std::vector<BrickNeighbors> found = readBuffer<BrickNeighbors>(state, occlusion->getBuffer(), count);
            const auto expected = findNeighborsOnCpu(*model);
            for (std::size_t index = 0; index < count; ++index)
                ASSERT_EQ(found[index], expected.at(unpackBrick(points[index]).cell)) << settings << ", " << index;
        }
        context->releaseContext();
    }
}

} // namespace

} // namespace osgLego::test
