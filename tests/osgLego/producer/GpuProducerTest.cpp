#include <osgLego/node/LegoPipeline.h>

#include <GlTest.h>
#include <Meshes.h>

#include <set>
#include <tuple>

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

} // namespace

} // namespace osgLego::test
