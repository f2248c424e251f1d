#include <GlTest.h>
#include <Meshes.h>

#include <offscreen/EglContext.h>

#include <utility>
#include <vector>

#include <osg/GLExtensions>
#include <osgViewer/CompositeViewer>

namespace osgLego::test
{

namespace
{

/** Counts the calls that draw bricks in contexts that share objects, during its lifetime. Triangles take one call,
 * splats take several. */
class DrawCount
{
public:
    explicit DrawCount(osg::State& state) : _extensions(*state.get<osg::GLExtensions>())
    {
        count = 0;
        multiDrawArrays = _extensions.glMultiDrawArrays;
        _extensions.glMultiDrawArrays = [](GLenum mode, const GLint* first, const GLsizei* sizes, GLsizei number)
        {
            ++count;
            multiDrawArrays(mode, first, sizes, number);
        };
    }
    ~DrawCount() { _extensions.glMultiDrawArrays = multiDrawArrays; }
    DrawCount(const DrawCount&) = delete;
    DrawCount& operator=(const DrawCount&) = delete;

    static inline int count = 0;

private:
    static inline decltype(osg::GLExtensions::glMultiDrawArrays) multiDrawArrays = nullptr;

    osg::GLExtensions& _extensions;
};

/** A viewer with views whose contexts share their objects, in one thread. */
class SharedContext : public GlTest
{
protected:
    SharedContext()
    {
        _lego->addChild(createSphere(10));
        _lego->setWaiting(true);
        _viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        _contexts.push_back(createContext());
        const osg::ref_ptr<osg::GraphicsContext::Traits> traits =
            new osg::GraphicsContext::Traits(*_contexts[0]->getTraits());
        traits->sharedContext = _contexts[0];
        _contexts.push_back(new EglContext(traits));
        for (const osg::ref_ptr<osg::GraphicsContext>& context : _contexts)
        {
            const osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
            view->getCamera()->setGraphicsContext(context);
            view->getCamera()->setViewport(0, 0, WIDTH, HEIGHT);
            view->getCamera()->setDrawBuffer(GL_BACK);
            view->getCamera()->setReadBuffer(GL_BACK);
            view->getCamera()->setProjectionMatrixAsPerspective(30, static_cast<double>(WIDTH) / HEIGHT, 1, 100);
            view->getCamera()->setViewMatrixAsLookAt(osg::Vec3d(0, -6, 2), osg::Vec3d(), osg::Vec3d(0, 0, 1));
            view->setSceneData(_lego);
            _viewer.addView(view);
        }
        _viewer.realize();
    }

    std::vector<osg::ref_ptr<osg::GraphicsContext>> _contexts;
    osg::ref_ptr<LegoNode> _lego = new LegoNode(parseSettings("12,drawing=splats"));
    osgViewer::CompositeViewer _viewer;
};

TEST_F(SharedContext, EachViewDrawsSplats)
{
    ASSERT_EQ(_contexts[0]->getState()->getContextID(), _contexts[1]->getState()->getContextID());
    _viewer.frame();
    _contexts[0]->makeCurrent();
    const DrawCount draws(*_contexts[0]->getState());
    _viewer.getView(1)->setSceneData(nullptr);
    _viewer.frame();
    const int one = std::exchange(DrawCount::count, 0);
    EXPECT_GT(one, 1) << "no splats";
    _viewer.getView(1)->setSceneData(_lego);
    _viewer.frame();
    EXPECT_EQ(DrawCount::count, 2 * one);
    const osg::ref_ptr<osg::Image> picture = readPixels(*_contexts[0]);
    EXPECT_GT(countDrawn(*picture), 1000u);
    EXPECT_EQ(countDifferent(*readPixels(*_contexts[1]), *picture, 0), 0u);
    _viewer.getView(1)->getCamera()->setViewport(0, 0, WIDTH / 2, HEIGHT);
    _viewer.frame();
    EXPECT_EQ(countDifferent(*readPixels(*_contexts[0]), *picture, 0), 0u);
}

} // namespace

} // namespace osgLego::test
