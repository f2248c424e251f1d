#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/node/LegoPipeline.h>

#include <GlTest.h>
#include <Meshes.h>

#include <future>
#include <string>

#include <osgUtil/UpdateVisitor>

namespace osgLego::test
{

namespace
{

/** A node that draws the bricks of a pipeline, and never updates them. */
class PipelineNode : public osg::Node
{
public:
    explicit PipelineNode(LegoPipeline& pipeline) : _pipeline(&pipeline) { setCullingActive(false); }

    osg::BoundingSphere computeBound() const override { return {osg::Vec3(), 2.0f}; }

    void traverse(osg::NodeVisitor& visitor) override
    {
        if (osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor()) _pipeline->cull(*cullVisitor);
    }

private:
    ~PipelineNode() override = default;

    osg::ref_ptr<LegoPipeline> _pipeline;
};

using LegoPipelineTest = GlTest;

TEST_F(LegoPipelineTest, DistantOcclusionIsComputedBeforeTheFrameThatShowsIt)
{
    for (const BrickOcclusion occlusion : {BrickOcclusion::OFF, BrickOcclusion::GRID, BrickOcclusion::SCREEN})
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        const osg::ref_ptr<LegoPipeline> pipeline =
            new LegoPipeline(parseSettings("12,device=cpu,meanwhile=nothing"), SettingsPalette());
        std::promise<void> announced;
        pipeline->setAnnouncement([&] { announced.set_value(); });
        pipeline->refresh(*createSphere(12));
        BrickAppearance appearance;
        appearance.occlusion = occlusion;
        pipeline->getDisplay().setAppearance(appearance);
        const osg::ref_ptr<osg::Group> scene = new AmbientOcclusionScene;
        scene->addChild(new PipelineNode(*pipeline));
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *scene);
        viewer.frame();
        announced.get_future().wait();
        ASSERT_FALSE(pipeline->getStore().getBricks());
        pipeline->update(osgUtil::UpdateVisitor());
        ASSERT_TRUE(pipeline->getStore().getBricks());
        const BrickSet& bricks = *pipeline->getStore().getBricks();
        EXPECT_EQ(bricks.hasDistantOcclusion(NearOcclusion::PICTURE), occlusion == BrickOcclusion::SCREEN);
        EXPECT_EQ(bricks.hasDistantOcclusion(NearOcclusion::GRID), occlusion == BrickOcclusion::GRID);
    }
}

} // namespace

} // namespace osgLego::test
