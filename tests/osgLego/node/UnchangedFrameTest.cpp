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

INSTANTIATE_ON_DEVICES(UnchangedFrame);

} // namespace

} // namespace osgLego::test
