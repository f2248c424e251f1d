#include <common/RacingCar.h>

#include <LookTest.h>
#include <OnDevices.h>
#include <osglegobench/AllocationCount.h>

#include <osg/Geode>
#include <osg/ShapeDrawable>

namespace osgLego::test
{

namespace
{

/** Counts the uploads to buffers in a context, during its lifetime. */
class UploadCount
{
public:
    explicit UploadCount(osg::GraphicsContext& context) : _extensions(*context.getState()->get<osg::GLExtensions>())
    {
        count = 0;
        bufferData = _extensions.glBufferData;
        bufferSubData = _extensions.glBufferSubData;
        _extensions.glBufferData = [](auto... arguments)
        {
            ++count;
            bufferData(arguments...);
        };
        _extensions.glBufferSubData = [](auto... arguments)
        {
            ++count;
            bufferSubData(arguments...);
        };
    }
    ~UploadCount()
    {
        _extensions.glBufferData = bufferData;
        _extensions.glBufferSubData = bufferSubData;
    }
    UploadCount(const UploadCount&) = delete;
    UploadCount& operator=(const UploadCount&) = delete;

    static inline int count = 0;

private:
    static inline decltype(osg::GLExtensions::glBufferData) bufferData = nullptr;
    static inline decltype(osg::GLExtensions::glBufferSubData) bufferSubData = nullptr;

    osg::GLExtensions& _extensions;
};

/** Frames in which nothing changes. */
class UnchangedFrame : public OnDevices<LookTest>
{
protected:
    /** The number of allocations in many frames, after everything that is created once exists. */
    std::size_t countInFrames(osg::Node& scene)
    {
        draw(scene, {osg::Vec3d(6, -12, 6), osg::Vec3d()});
        for (int frame = 0; frame < 20; ++frame) // more frames than idle passes are kept for
            _viewer.frame();
        const std::size_t before = AllocationCount::getNumAllocations();
        for (int frame = 0; frame < 20; ++frame)
            _viewer.frame();
        return AllocationCount::getNumAllocations() - before;
    }

    osg::ref_ptr<LegoNode> createLego(const std::string& settings) const
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->addChild(createRacingCar());
        return lego;
    }
};

TEST_P(UnchangedFrame, AllocatesNoMoreThanAnOrdinaryNode)
{
    osg::ref_ptr<osg::Geode> box = new osg::Geode;
    box->addDrawable(new osg::ShapeDrawable(new osg::Box));
    const std::size_t expected = countInFrames(*box);
    for (const char* settings : {"20,look=plain,drawing=splats", "20,look=plain,drawing=triangles",
                                 "20,look=full,drawing=splats", "20,look=full,drawing=triangles"})
    {
        const osg::ref_ptr<LegoNode> lego = createLego(settings);
        EXPECT_LE(countInFrames(*lego), expected) << settings;
        expectPictureOfCpu(*_context, *lego, *_viewer.getCamera());
    }
}

TEST_P(UnchangedFrame, MakesNoBricks)
{
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    countInFrames(*lego);
    expectPictureOfCpu(*_context, *lego, *_viewer.getCamera());
    EXPECT_EQ(lego->getStatistics(_context->getState()->getContextID()).numLegolizations, 1u);
}

TEST_P(UnchangedFrame, ProgressAllocatesAndUploadsNothing)
{
    osg::ref_ptr<osg::Geode> box = new osg::Geode;
    box->addDrawable(new osg::ShapeDrawable(new osg::Box));
    const std::size_t expected = countInFrames(*box);
    for (const char* settings : {"20,proportions=brick,drawing=splats", "20,proportions=brick,drawing=triangles"})
    {
        const osg::ref_ptr<LegoNode> lego = createLego(settings);
        lego->setWaiting(true);
        lego->setBuildProgress(0.5);
        draw(*lego, {osg::Vec3d(6, -12, 6), osg::Vec3d()});
        const std::size_t drawn = countDrawn(*readPixels(*_context));
        const auto animate = [&]
        {
            for (int frame = 0; frame < 20; ++frame)
            {
                lego->setBuildProgress(0.05 * frame);
                _viewer.frame();
            }
        };
        animate();
        const UploadCount uploads(*_context);
        const std::size_t before = AllocationCount::getNumAllocations();
        animate();
        EXPECT_LE(AllocationCount::getNumAllocations() - before, expected) << settings;
        lego->setBuildProgress(1.0); // drawn as usual
        _viewer.frame();
        EXPECT_EQ(UploadCount::count, 0) << settings;
        EXPECT_GT(countDrawn(*readPixels(*_context)), drawn) << settings;
    }
}

INSTANTIATE_ON_DEVICES(UnchangedFrame);

} // namespace

} // namespace osgLego::test
