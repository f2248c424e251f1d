#include <common/PictureRenderer.h>

#include <offscreen/OffscreenContext.h>

#include <new>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <osg/Drawable>
#include <osg/FrameStamp>
#include <osg/Geode>
#include <osg/State>

namespace osgLego::test
{

namespace
{

/** A drawable for which there is not enough memory. */
class LargeDrawable : public osg::Drawable
{
public:
    LargeDrawable() { setUseDisplayList(false); }

    osg::Object* cloneType() const override { return new LargeDrawable; }
    osg::Object* clone(const osg::CopyOp&) const override { return new LargeDrawable; }
    osg::BoundingBox computeBoundingBox() const override { return {-1.0f, -1.0f, -1.0f, 1.0f, 1.0f, 1.0f}; }
    void drawImplementation(osg::RenderInfo&) const override { throw std::bad_alloc(); }
};

/** Makes the simulation time of each frame known. */
class TimedDrawable : public LargeDrawable
{
public:
    explicit TimedDrawable(std::vector<double>& times) : _times(times) {}

    void drawImplementation(osg::RenderInfo& info) const override
    {
        _times.push_back(info.getState()->getFrameStamp()->getSimulationTime());
    }

private:
    std::vector<double>& _times;
};

TEST(PictureRenderer, AnimationsStandStillInAllFramesOfPictures)
{
    std::string error;
    const osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(16, 16, error);
    ASSERT_TRUE(context) << error;
    std::vector<double> times;
    const osg::ref_ptr<osg::Geode> scene = new osg::Geode;
    scene->addDrawable(new TimedDrawable(times));
    PictureRenderer renderer(*context, 1);
    renderer.setScene(*scene);
    renderer.getCamera().setViewMatrixAsLookAt({0.0, -5.0, 0.0}, {}, {0.0, 0.0, 1.0});
    renderer.getCamera().setProjectionMatrixAsPerspective(40.0, 1.0, 1.0, 10.0);
    renderer.drawTransparent({64, 64});
    renderer.timeFrame();
    EXPECT_EQ(times, std::vector<double>(3, 0.0)); // a transparent picture is drawn over two backgrounds
}

TEST(PictureRenderer, AFailedPictureLeavesNoStateOfItsScene)
{
    std::string error;
    const osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(16, 16, error);
    ASSERT_TRUE(context) << error;
    {
        const osg::ref_ptr<osg::Geode> scene = new osg::Geode;
        scene->addDrawable(new LargeDrawable);
        scene->getOrCreateStateSet()->setMode(GL_BLEND, osg::StateAttribute::ON);
        PictureRenderer renderer(*context, 1);
        renderer.setScene(*scene);
        renderer.getCamera().setViewMatrixAsLookAt({0.0, -5.0, 0.0}, {}, {0.0, 0.0, 1.0});
        renderer.getCamera().setProjectionMatrixAsPerspective(40.0, 1.0, 1.0, 10.0);
        EXPECT_THROW(renderer.draw({64, 64}, {0.0f, 0.0f, 0.0f, 1.0f}), std::bad_alloc);
    }
    EXPECT_EQ(context->getState()->getStateSetStackSize(), 0u);
}

} // namespace

} // namespace osgLego::test
