#include <common/RacingCar.h>
#include <osgLego/AmbientOcclusionScene.h>

#include <GlTest.h>
#include <Meshes.h>
#include <OnDevices.h>

#include <ostream>
#include <stdexcept>
#include <utility>

#include <EGL/egl.h>
#include <osg/GLExtensions>
#include <osg/GLObjects>

namespace osgLego::test
{

namespace
{

constexpr GLuint MOST_NAMES = 5000;
// Textures of the full look: the relief, two maps of the light probe, two tables of occlusion by near cells and by
// studs, the buffer of the cells around bricks, and two of distant occlusion.
constexpr int LOOK_TEXTURES = 8;
// Textures of splats: the nearest bricks, their depths, and the buffer of the bricks.
constexpr int SPLAT_TEXTURES = 3;

/** The number of GL objects of each kind in a context; all kinds of OpenGL 4.0 that have names, except program
 * pipelines. */
struct GlObjects
{
    int buffers = 0;
    int textures = 0;
    int framebuffers = 0;
    int renderbuffers = 0;
    int programs = 0;
    int shaders = 0;
    int queries = 0;
    int transformFeedbacks = 0;
    int vertexArrays = 0;
    int samplers = 0;
    int displayLists = 0;

    static GlObjects count(osg::GraphicsContext& context)
    {
        context.makeCurrent();
        osg::flushAllDeletedGLObjects(context.getState()->getContextID());
        GlObjects result;
        for (const auto& [number, function] :
             {std::pair(&GlObjects::buffers, "glIsBuffer"), std::pair(&GlObjects::textures, "glIsTexture"),
              std::pair(&GlObjects::framebuffers, "glIsFramebuffer"),
              std::pair(&GlObjects::renderbuffers, "glIsRenderbuffer"), std::pair(&GlObjects::programs, "glIsProgram"),
              std::pair(&GlObjects::shaders, "glIsShader"), std::pair(&GlObjects::queries, "glIsQuery"),
              std::pair(&GlObjects::transformFeedbacks, "glIsTransformFeedback"),
              std::pair(&GlObjects::displayLists, "glIsList")})
            result.*number = countNames(function);
        return result;
    }

    bool operator==(const GlObjects&) const = default;

private:
    static int countNames(const char* function)
    {
        using IsObject = GLboolean(GL_APIENTRY*)(GLuint);
        const auto isObject = reinterpret_cast<IsObject>(eglGetProcAddress(function));
        if (!isObject) throw std::runtime_error(std::string("GL has no ") + function);
        int count = 0;
        for (GLuint name = 1; name < MOST_NAMES; ++name)
            count += isObject(name) ? 1 : 0;
        return count;
    }
};

std::ostream& operator<<(std::ostream& stream, const GlObjects& objects)
{
    return stream << objects.buffers << " buffers, " << objects.textures << " textures, " << objects.framebuffers
                  << " frame buffers, " << objects.renderbuffers << " render buffers, " << objects.programs
                  << " programs, " << objects.shaders << " shaders, " << objects.queries << " queries, "
                  << objects.transformFeedbacks << " transform feedbacks, " << objects.vertexArrays
                  << " vertex arrays, " << objects.samplers << " samplers, " << objects.displayLists
                  << " display lists";
}

class GlObjectsTest : public OnDevices<GlTest>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _root = new osg::Group;
        const osg::ref_ptr<osg::Geometry> triangle = createTriangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1});
        // It has no normals.
        triangle->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        _root->addChild(triangle);
        setUpViewer(_viewer, *_context, *_root);
        _viewer.frame();
        _before = GlObjects::count(*_context);
        _lego = new LegoNode(parseSettings("32"));
        _lego->setWaiting(true);
        _lego->addChild(createRacingCar());
        _root->addChild(_lego);
    }

    void drawFrames(int count)
    {
        for (int frame = 0; frame < count; ++frame)
            _viewer.frame();
    }

    /** Expect the bricks, their look and the programs that draw them, and no object of the passes. */
    void expectOnlyBricksAndLook()
    {
        GlObjects expected = _before;
        expected.buffers += 2; // the bricks, and the cells around them
        expected.textures += LOOK_TEXTURES + SPLAT_TEXTURES;
        ++expected.framebuffers; // that of splats
        const GlObjects found = GlObjects::count(*_context);
        // One program draws triangles; those of splats depend on the bricks and lights in view. The passes have more.
        EXPECT_GT(found.programs, _before.programs);
        EXPECT_LE(found.programs, _before.programs + 4);
        expected.programs = found.programs;
        expected.shaders = found.shaders;
        EXPECT_EQ(found, expected);
        expectPictureOfCpu(*_context, *_root, *_viewer.getCamera());
    }

    void expectNoneLeft()
    {
        _viewer.frame();
        EXPECT_EQ(GlObjects::count(*_context), _before);
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<osg::Group> _root;
    osg::ref_ptr<LegoNode> _lego;
    osgViewer::Viewer _viewer;
    GlObjects _before;
};

TEST_P(GlObjectsTest, AfterLegolizationOnlyTheBricksAndTheirLookRemain)
{
    drawFrames(1);
    const bool hasPasses = GlObjects::count(*_context).framebuffers > _before.framebuffers + 1;
    EXPECT_EQ(hasPasses, !_lego->getStatistics(_context->getState()->getContextID()).isFromCpu);
    drawFrames(12);
    expectOnlyBricksAndLook();
}

TEST_P(GlObjectsTest, ThePlainLookKeepsNoTextures)
{
    _lego->setSettings(parseSettings("32,look=plain"));
    drawFrames(12);
    EXPECT_EQ(GlObjects::count(*_context).textures, _before.textures + SPLAT_TEXTURES);
}

TEST_P(GlObjectsTest, AnAmbientOcclusionSceneThatIsRemovedLeavesNothing)
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

TEST_P(GlObjectsTest, ADisabledAmbientOcclusionSceneCreatesNothing)
{
    drawFrames(12);
    const GlObjects alone = GlObjects::count(*_context);
    _root->removeChild(_lego);
    osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    scene->setEnabled(false);
    scene->addChild(_lego);
    _root->addChild(scene);
    drawFrames(12);
    EXPECT_EQ(GlObjects::count(*_context), alone);
}

TEST_P(GlObjectsTest, ANodeThatIsRemovedLeavesNothing)
{
    drawFrames(2);
    _root->removeChild(_lego);
    _lego = nullptr;
    expectNoneLeft();
}

TEST_P(GlObjectsTest, ProgressNeedsFourMoreBuffersAndLeavesNothing)
{
    drawFrames(12);
    const int buffers = GlObjects::count(*_context).buffers;
    _lego->setBuildProgress(0.5);
    drawFrames(2);
    EXPECT_EQ(GlObjects::count(*_context).buffers, buffers + 4);
    _lego->setNumNewParts(3);
    drawFrames(1);
    _lego->setBuildProgress(0.25);
    drawFrames(1);
    EXPECT_EQ(GlObjects::count(*_context).buffers, buffers + 4);
    _root->removeChild(_lego);
    _context->makeCurrent();
    _lego->releaseGLObjects(_context->getState());
    expectNoneLeft();
}

TEST_P(GlObjectsTest, ReleasingLeavesNothing)
{
    drawFrames(2);
    _root->removeChild(_lego);
    _context->makeCurrent();
    _lego->releaseGLObjects(_context->getState());
    expectNoneLeft();
}

TEST_P(GlObjectsTest, APaletteThatIsReleasedLeavesNothing)
{
    for (const char* settings : {"32,palette=ldraw", "32,palette=ldraw,dither=on,method=points"})
    {
        _lego->setSettings(parseSettings(settings));
        drawFrames(2);
    }
    _root->removeChild(_lego);
    _context->makeCurrent();
    _lego->releaseGLObjects(_context->getState());
    expectNoneLeft();
}

TEST_P(GlObjectsTest, APaletteRemainsOnlyInTheColoursOfTheBricks)
{
    _lego->setSettings(parseSettings("32,palette=ldraw,dither=on"));
    drawFrames(13);
    expectOnlyBricksAndLook();
}

TEST_P(GlObjectsTest, ManyLegolizationsLeaveNoMoreThanOne)
{
    drawFrames(13);
    const GlObjects one = GlObjects::count(*_context);
    for (int repeat = 0; repeat < 11; ++repeat)
    {
        _lego->setSettings(parseSettings(std::to_string(20 + repeat) + (repeat % 2 ? ",method=points" : "") +
                                         (repeat % 3 ? ",palette=ldraw,dither=on" : "")));
        drawFrames(1);
    }
    drawFrames(12);
    EXPECT_EQ(GlObjects::count(*_context), one);
    expectOnlyBricksAndLook();
}

INSTANTIATE_ON_DEVICES(GlObjectsTest);

} // namespace

} // namespace osgLego::test
