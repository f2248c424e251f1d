#include <common/RacingCar.h>

#include <LookTest.h>
#include <osglegobench/AllocationCount.h>

#include <osg/Geode>
#include <osg/ShapeDrawable>

namespace osgLego::test
{

namespace
{

/** Frames in which nothing changes. */
class UnchangedFrame : public LookTest
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

    static osg::ref_ptr<LegoNode> createLego(const std::string& settings)
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->addChild(createRacingCar());
        return lego;
    }
};

TEST_F(UnchangedFrame, AllocatesNoMoreThanAnOrdinaryNode)
{
    osg::ref_ptr<osg::Geode> box = new osg::Geode;
    box->addDrawable(new osg::ShapeDrawable(new osg::Box));
    const std::size_t expected = countInFrames(*box);
    for (const char* settings : {"20,look=plain,drawing=splats", "20,look=plain,drawing=triangles",
                                 "20,look=full,drawing=splats", "20,look=full,drawing=triangles"})
        EXPECT_LE(countInFrames(*createLego(settings)), expected) << settings;
}

TEST_F(UnchangedFrame, RunsNoPass)
{
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    countInFrames(*lego);
    EXPECT_EQ(lego->getStatistics(_context->getState()->getContextID()).numLegolizations, 1u);
}

} // namespace

} // namespace osgLego::test
