#include "AmbientOcclusionTest.h"

#include <Notices.h>
#include <common/RacingCar.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <osg/BlendFunc>
#include <osg/MatrixTransform>
#include <osgViewer/CompositeViewer>

namespace osgLego::test
{

namespace
{

using AmbientOcclusionView = AmbientOcclusionTest;

TEST_F(AmbientOcclusionView, AViewportAnywhereShowsTheSamePicture)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    osg::ref_ptr<osg::Geometry> glass =
        createQuad({1, -1, -1}, {6, 0, 0}, {0, 0, 4}, osg::Vec4(0.1f, 0.9f, 0.1f, 0.5f));
    glass->getOrCreateStateSet()->setAttributeAndModes(new osg::BlendFunc);
    glass->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    scene->addChild(glass);
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
    const auto drawAt = [&](int x, int y)
    {
        _viewer.getCamera()->setViewport(x, y, 120, 90);
        draw(*group, MIXED_VIEW);
        osg::ref_ptr<osg::Image> image = new osg::Image;
        _context->makeCurrent();
        image->readPixels(x, y, 120, 90, GL_RGB, GL_UNSIGNED_BYTE);
        return image;
    };
    const osg::ref_ptr<osg::Image> atOrigin = drawAt(0, 0);
    EXPECT_GT(countDrawn(*atOrigin), 1500u);
    EXPECT_LE(countDifferent(*atOrigin, *drawAt(50, 37), 1), FEW_PIXELS / 4);
}

TEST_F(AmbientOcclusionView, AViewportThatChangesItsSizeShowsWhatAFreshOneDoes)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
    for (const int width : {200, 90, 161})
    {
        const int height = width * 3 / 4;
        _viewer.getCamera()->setViewport(0, 0, width, height);
        const osg::ref_ptr<osg::Image> resized = draw(*group, MIXED_VIEW);
        EXPECT_EQ(countDifferent(*resized, *draw(*createGroup("medium", scene), MIXED_VIEW), 1), 0u) << width;
        draw(*group, MIXED_VIEW);
    }
}

TEST_F(AmbientOcclusionView, ViewportsOfNoPixelAndOfOneLeaveLaterPicturesAsTheyWere)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const auto drawInto = [&](AmbientOcclusionScene& group, int width, int height)
    {
        _viewer.getCamera()->setViewport(0, 0, width, height);
        return draw(group, MIXED_VIEW);
    };
    const osg::ref_ptr<osg::Image> expected = drawInto(*createGroup("medium", scene), WIDTH, HEIGHT);
    EXPECT_GT(countDrawn(*expected), 1500u);
    for (const std::pair<int, int>& size : {std::pair{0, 0}, {1, 1}, {0, HEIGHT}, {WIDTH, 1}})
    {
        SCOPED_TRACE(std::to_string(size.first) + " x " + std::to_string(size.second));
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
        for (const char* when : {"before the first whole picture", "between two"})
        {
            EXPECT_EQ(noticesOf([&] { drawInto(*group, size.first, size.second); }), "") << when;
            EXPECT_EQ(countDifferent(*expected, *drawInto(*group, WIDTH, HEIGHT), 0), 0u) << when;
        }
    }
}

TEST_F(AmbientOcclusionView, SeveralViewsOfOneSceneAreEachAsOneAlone)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const std::vector<Viewpoint> viewpoints{MIXED_VIEW, {{-14, -12, 9}, {4, 4, 1}}};
    const auto setUp = [&](osg::Camera& camera, int index)
    {
        camera.setGraphicsContext(_context);
        camera.setViewport(index * WIDTH / 2, 0, WIDTH / 2, HEIGHT);
        camera.setDrawBuffer(GL_BACK);
        camera.setReadBuffer(GL_BACK);
        viewpoints[static_cast<std::size_t>(index)].apply(camera);
    };
    const auto readHalf = [&](int index)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        _context->makeCurrent();
        image->readPixels(index * WIDTH / 2, 0, WIDTH / 2, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE);
        return image;
    };
    const osg::Vec4 background = _viewer.getCamera()->getClearColor();
    std::vector<osg::ref_ptr<osg::Image>> alone;
    for (int index = 0; index < 2; ++index)
    {
        setUp(*_viewer.getCamera(), index);
        draw(*group, viewpoints[static_cast<std::size_t>(index)]);
        alone.push_back(readHalf(index));
    }
    osgViewer::CompositeViewer viewer;
    for (int index = 0; index < 2; ++index)
    {
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        setUp(*view->getCamera(), index);
        view->getCamera()->setClearColor(background);
        view->setSceneData(group);
        viewer.addView(view);
    }
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer.setReleaseContextAtEndOfFrameHint(false);
    for (int frame = 0; frame < 2; ++frame)
    {
        viewer.frame();
        for (int index = 0; index < 2; ++index)
        {
            EXPECT_GT(countDrawn(*alone[static_cast<std::size_t>(index)]), 1500u);
            EXPECT_LE(countDifferent(*alone[static_cast<std::size_t>(index)], *readHalf(index), 1), FEW_PIXELS / 2);
        }
    }
}

TEST_F(AmbientOcclusionView, TwoParentsAreDrawnAsTwoGroupsAre)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const auto place = [](osg::Node& first, osg::Node& second)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(&first);
        osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(
            osg::Matrix::rotate(0.6, osg::Vec3d(0.2, 0, 1)) * osg::Matrix::translate(5, -6, 3));
        moved->addChild(&second);
        root->addChild(moved);
        return root;
    };
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
    const osg::ref_ptr<osg::Group> shared = place(*group, *group);
    const osg::ref_ptr<osg::Group> apart = place(*createGroup("medium", scene), *createGroup("medium", scene));
    const Viewpoint viewpoint{{16, -34, 26}, {5, 1, 2}};
    const osg::ref_ptr<osg::Image> image = draw(*shared, viewpoint);
    EXPECT_GT(countDrawn(*image), 2000u);
    EXPECT_EQ(countDifferent(*image, *draw(*apart, viewpoint), 0), 0u);
    EXPECT_EQ(countDifferent(*image, *draw(*shared, viewpoint), 0), 0u) << "and so in later frames";
    EXPECT_EQ(countDifferent(*image, *draw(*shared, viewpoint), 0), 0u);
}

TEST_F(AmbientOcclusionView, APictureInATextureIsThatOfTheFrame)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const osg::ref_ptr<osg::Image> frame = draw(*group, MIXED_VIEW);
    const osg::ref_ptr<osg::Image> texture = drawToTexture(*group, MIXED_VIEW, 0);
    EXPECT_LE(countDifferent(*frame, *texture, 2), FEW_PIXELS);
    const osg::ref_ptr<osg::Image> relative = drawToTexture(*group, MIXED_VIEW, 0, osg::Transform::RELATIVE_RF);
    EXPECT_LE(countDifferent(*frame, *relative, 2), FEW_PIXELS);
    const osg::ref_ptr<osg::Image> smooth = drawToTexture(*group, MIXED_VIEW, 4);
    EXPECT_LT(meanDifference(*frame, *smooth), 4.0);
    EXPECT_GT(countDrawn(*smooth), countDrawn(*frame)) << "pixels of which a part is covered";
}

constexpr int FINE = 4;

/** The number of pixels that are brighter, by more than 24 of 255, than the same pixels and those around them in a
 * picture that is FINE times as large. */
unsigned int countSpecks(const osg::Image& image, const osg::Image& fine)
{
    unsigned int count = 0;
    for (int row = 1; row + 1 < image.t(); ++row)
        for (int column = 1; column + 1 < image.s(); ++column)
        {
            double brightest = 0.0;
            for (int y = (row - 1) * FINE; y < (row + 2) * FINE; ++y)
                for (int x = (column - 1) * FINE; x < (column + 2) * FINE; ++x)
                    brightest = std::max(brightest, brightnessAt(fine, x, y));
            count += brightnessAt(image, column, row) > brightest + 24.0 / 255.0;
        }
    return count;
}

TEST_F(AmbientOcclusionView, ADarkCornerBehindASilhouetteDoesNotShine)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("64,device=cpu"));
    lego->addChild(createRacingCar());
    lego->setWaiting(true);
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", lego);
    const osg::Vec3d middle = osg::Vec3d(lego->getBound().center());
    unsigned int count = 0;
    for (const osg::Vec3d direction : {osg::Vec3d(-2, -3, 1), {3, -2, 1}, {2, 3, 1}, {-3, 2, 1}})
    {
        const Viewpoint view{middle + direction * (0.25 * lego->getBound().radius()), middle};
        const osg::ref_ptr<osg::Image> picture = drawToTexture(*group, view, 4);
        EXPECT_GT(countDrawn(*picture), 3000u);
        count += countSpecks(*picture, *drawToTexture(*group, view, 0, osg::Transform::ABSOLUTE_RF, FINE));
    }
    // Those left are on studs in the distance, which no neighbouring pixel shows. Mean light of all samples makes 87.
    EXPECT_LT(count, 20u);
}

TEST_F(AmbientOcclusionView, ACameraForDepthsAloneGetsThem)
{
    osg::ref_ptr<osg::Image> depths = new osg::Image;
    depths->allocateImage(64, 64, 1, GL_DEPTH_COMPONENT, GL_FLOAT);
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setDrawBuffer(GL_NONE);
    camera->setReadBuffer(GL_NONE);
    camera->attach(osg::Camera::DEPTH_BUFFER, depths);
    camera->setViewport(0, 0, 64, 64);
    MIXED_VIEW.apply(*camera);
    camera->addChild(createGroup("medium", createMixedScene()));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(camera);
    draw(*root, MIXED_VIEW);
    const auto depthAt = [&](unsigned int column, unsigned int row)
    { return *reinterpret_cast<const float*>(depths->data(column, row)); };
    EXPECT_LT(depthAt(32, 32), 1.0f);
    EXPECT_GT(depthAt(32, 32), 0.0f);
    EXPECT_EQ(depthAt(0, 63), 1.0f);
}

TEST_F(AmbientOcclusionView, AContextThatIsClosedAndReopenedDrawsItAgain)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const osg::ref_ptr<osg::Image> before = draw(*group, MIXED_VIEW);
    _viewer.getCamera()->setGraphicsContext(nullptr);
    group->releaseGLObjects(_context->getState());
    _context->close(true);
    _context = createContext();
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *_context, *group);
    MIXED_VIEW.apply(*viewer.getCamera());
    viewer.frame();
    EXPECT_EQ(countDifferent(*before, *readPixels(*_context), 0), 0u);
}

class AmbientOcclusionThreading : public GlTest,
                                  public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel>
{
};

TEST_P(AmbientOcclusionThreading, DrawsTheSamePicture)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const auto drawWith = [&](osgViewer::ViewerBase::ThreadingModel model)
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *group);
        MIXED_VIEW.apply(*viewer.getCamera());
        viewer.setThreadingModel(model);
        viewer.realize();
        for (int frame = 0; frame < 4; ++frame)
        {
            // Each frame has a viewport of another size, so that views are created and deleted.
            viewer.getCamera()->setViewport(0, 0, WIDTH - (3 - frame), HEIGHT);
            viewer.frame();
        }
        viewer.stopThreading();
        return readPixels(*context);
    };
    const osg::ref_ptr<osg::Image> expected = drawWith(osgViewer::ViewerBase::SingleThreaded);
    EXPECT_GT(countDrawn(*expected), 3000u);
    EXPECT_EQ(countDifferent(*expected, *drawWith(GetParam()), 0), 0u);
}

INSTANTIATE_TEST_SUITE_P(Models, AmbientOcclusionThreading,
                         ::testing::Values(osgViewer::ViewerBase::CullDrawThreadPerContext,
                                           osgViewer::ViewerBase::DrawThreadPerContext,
                                           osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext));

} // namespace

} // namespace osgLego::test
