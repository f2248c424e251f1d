#include <common/RacingCar.h>
#include <osgLego/AmbientOcclusionScene.h>

#include <GlTest.h>
#include <Meshes.h>

#include <EGL/egl.h>
#include <osg/GLExtensions>
#include <osg/GLObjects>

namespace osgLego::test
{

namespace
{

constexpr GLuint MOST_NAMES = 5000;
// Textures of the full look: the relief, and two maps of the light probe.
constexpr int LOOK_TEXTURES = 3;

/** The number of GL objects of each kind in a context. */
struct GlObjects
{
    int buffers = 0;
    int textures = 0;
    int framebuffers = 0;

    static GlObjects count(osg::GraphicsContext& context)
    {
        context.makeCurrent();
        osg::flushAllDeletedGLObjects(context.getState()->getContextID());
        const osg::GLExtensions& extensions = *context.getState()->get<osg::GLExtensions>();
        using IsFramebuffer = GLboolean(GL_APIENTRY*)(GLuint);
        const auto isFramebuffer = reinterpret_cast<IsFramebuffer>(eglGetProcAddress("glIsFramebuffer"));
        GlObjects result;
        for (GLuint name = 1; name < MOST_NAMES; ++name)
        {
            result.buffers += extensions.glIsBuffer(name) ? 1 : 0;
            result.textures += glIsTexture(name) ? 1 : 0;
            result.framebuffers += isFramebuffer(name) ? 1 : 0;
        }
        return result;
    }
};

class GlObjectsTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _root = new osg::Group;
        _root->addChild(createTriangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1}));
        setUpViewer(_viewer, *_context, *_root);
        _viewer.frame();
        _before = GlObjects::count(*_context);
        const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        _drawsSplats = renderer.find("llvmpipe") != std::string::npos;
        _lego = new LegoNode(parseSettings("32"));
        _lego->addChild(createRacingCar());
        _root->addChild(_lego);
    }

    void drawFrames(int count)
    {
        for (int frame = 0; frame < count; ++frame)
            _viewer.frame();
    }

    void expectNoneLeft()
    {
        _viewer.frame();
        const GlObjects after = GlObjects::count(*_context);
        EXPECT_EQ(after.buffers, _before.buffers);
        EXPECT_EQ(after.textures, _before.textures);
        EXPECT_EQ(after.framebuffers, _before.framebuffers);
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<LegoNode> _lego;
    osgViewer::Viewer _viewer;
    GlObjects _before;
    bool _drawsSplats = false; // splats keep a frame buffer object with two textures
};

TEST_F(GlObjectsTest, AfterLegolizationOnlyTheBricksAndTheirLookRemain)
{
    drawFrames(1);
    EXPECT_GT(GlObjects::count(*_context).framebuffers, _before.framebuffers)
        << "the passes should have some while they run";
    drawFrames(12);
    const GlObjects after = GlObjects::count(*_context);
    EXPECT_EQ(after.buffers, _before.buffers + 1);
    EXPECT_EQ(after.textures, _before.textures + LOOK_TEXTURES + (_drawsSplats ? 2 : 0));
    EXPECT_EQ(after.framebuffers, _before.framebuffers + (_drawsSplats ? 1 : 0));
}

TEST_F(GlObjectsTest, ThePlainLookKeepsNoTextures)
{
    _lego->setSettings(parseSettings("32,look=plain"));
    drawFrames(12);
    EXPECT_EQ(GlObjects::count(*_context).textures, _before.textures + (_drawsSplats ? 2 : 0));
}

TEST_F(GlObjectsTest, AnAmbientOcclusionSceneThatIsRemovedLeavesNothing)
{
    _root->removeChild(_lego);
    osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    scene->addChild(_lego);
    _root->addChild(scene);
    drawFrames(2);
    EXPECT_GT(GlObjects::count(*_context).framebuffers, _before.framebuffers);
    _root->removeChild(scene);
    scene = nullptr;
    _lego = nullptr;
    expectNoneLeft();
}

TEST_F(GlObjectsTest, ADisabledAmbientOcclusionSceneCreatesNothing)
{
    drawFrames(12);
    const GlObjects alone = GlObjects::count(*_context);
    _root->removeChild(_lego);
    osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    scene->setEnabled(false);
    scene->addChild(_lego);
    _root->addChild(scene);
    drawFrames(12);
    const GlObjects after = GlObjects::count(*_context);
    EXPECT_EQ(after.textures, alone.textures);
    EXPECT_EQ(after.framebuffers, alone.framebuffers);
}

TEST_F(GlObjectsTest, ANodeThatIsRemovedLeavesNothing)
{
    drawFrames(2);
    _root->removeChild(_lego);
    _lego = nullptr;
    expectNoneLeft();
}

TEST_F(GlObjectsTest, ReleasingLeavesNothing)
{
    drawFrames(2);
    _root->removeChild(_lego);
    _context->makeCurrent();
    _lego->releaseGLObjects(_context->getState());
    expectNoneLeft();
}

TEST_F(GlObjectsTest, ManyLegolizationsLeaveNoMoreThanOne)
{
    for (int repeat = 0; repeat < 10; ++repeat)
    {
        _lego->setSettings(parseSettings(std::to_string(20 + repeat) + (repeat % 2 ? ",method=points" : "")));
        drawFrames(1);
    }
    drawFrames(12);
    const GlObjects after = GlObjects::count(*_context);
    EXPECT_EQ(after.buffers, _before.buffers + 1);
    EXPECT_EQ(after.textures, _before.textures + LOOK_TEXTURES + (_drawsSplats ? 2 : 0));
    EXPECT_EQ(after.framebuffers, _before.framebuffers + (_drawsSplats ? 1 : 0));
}

} // namespace

} // namespace osgLego::test
