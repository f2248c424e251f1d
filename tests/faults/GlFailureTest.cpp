#include "GlFaults.h"

#include <osgLego/CpuLegolizer.h>
#include <osgLego/LegoNode.h>

#include <GlDebug.h>
#include <GlTest.h>
#include <Meshes.h>
#include <Notices.h>

#include <cstddef>
#include <string>
#include <vector>

#include <EGL/egl.h>
#include <osg/GLObjects>

namespace osgLego::test
{

namespace
{

using Kind = GlFaults::Kind;

/** Settings, and the calls that fail with them. */
struct Case
{
    const char* name;
    const char* settings;
    Kind kind;
    bool isCore = false; //!< whether the context has the core profile
};

/** The GL objects of a context that exist, of all kinds that nodes create. */
std::size_t countGlObjects(osg::GraphicsContext& context)
{
    constexpr GLuint MOST_NAMES = 1000;
    context.makeCurrent();
    osg::flushAllDeletedGLObjects(context.getState()->getContextID());
    std::size_t count = 0;
    for (const char* function : {"glIsBuffer", "glIsTexture", "glIsFramebuffer", "glIsRenderbuffer", "glIsProgram",
                                 "glIsShader", "glIsQuery", "glIsTransformFeedback"})
    {
        const auto isObject = reinterpret_cast<GLboolean(GL_APIENTRY*)(GLuint)>(eglGetProcAddress(function));
        for (GLuint name = 1; name < MOST_NAMES; ++name)
            count += isObject(name) ? 1 : 0;
    }
    return count;
}

std::ptrdiff_t countWarnings(const std::string& notices)
{
    const std::string start = "osgLego: ";
    std::ptrdiff_t result = 0;
    for (std::size_t place = notices.find(start); place != std::string::npos; place = notices.find(start, place + 1))
        ++result;
    return result;
}

void drawFrames(osgViewer::Viewer& viewer, int count)
{
    for (int frame = 0; frame < count; ++frame)
        viewer.frame();
}

class GlFailure : public GlTest, public ::testing::WithParamInterface<Case>
{
protected:
    static constexpr std::size_t MOST_CALLS = 200;

    /** Fail a call in the first frame of a new node, and change the node afterwards.
     * @return false if there are fewer calls. */
    bool failCall(std::size_t call)
    {
        const bool isCore = GetParam().isCore;
        const osg::ref_ptr<osg::GraphicsContext> context = isCore ? createCoreContext("4.1") : createContext();
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(GetParam().settings));
        lego->setWaiting(true);
        lego->addChild(createSphere(6));
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *lego);
        context->makeCurrent();
        GlFaults::begin(*context, GetParam().kind, call);
        const std::string notices = noticesOf([&] { drawFrames(viewer, 2); });
        const bool hasFailed = GlFaults::end();
        expectOneMessage(*context, *lego, notices);
        if (!isCore) expectSourceOrBricks(*context, viewer, notices);
        lego->setSettings(lego->getSettings());
        lego->dirty();
        drawFrames(viewer, 10); // after which passes are released
        const unsigned int contextID = context->getState()->getContextID();
        EXPECT_TRUE(lego->isLegolized(contextID)) << lego->getFailure(contextID);
        _numObjects.push_back(countGlObjects(*context));
        expectPictureOfCpu(*context, *lego, *viewer.getCamera());
        // OSG uses fixed functions in the core profile, too; CoreProfile.* tests the other errors.
        if (isCore) takeGlMessages();
        return hasFailed;
    }

    /** The objects that were left after each failCall(). */
    const std::vector<std::size_t>& getNumObjects() const { return _numObjects; }

private:
    static void expectOneMessage(const osg::GraphicsContext& context, const LegoNode& lego, const std::string& notices)
    {
        const unsigned int contextID = context.getState()->getContextID();
        const std::string failure = lego.getFailure(contextID);
        EXPECT_NE(lego.isLegolized(contextID), !failure.empty()) << failure;
        EXPECT_LE(countWarnings(notices), 1) << notices;
        if (failure.empty()) return;
        EXPECT_NE(notices.find(failure + "; the source is drawn instead of bricks"), std::string::npos) << notices;
    }

    /** Expect the bricks, or any picture if there was a message, without errors. */
    static void expectSourceOrBricks(osg::GraphicsContext& context, const osgViewer::Viewer& viewer,
                                     const std::string& notices)
    {
        if (countWarnings(notices) == 0) expectPictureOfCpu(context, *viewer.getSceneData(), *viewer.getCamera());
        EXPECT_GT(countDrawn(*readPixels(context)), 1000u);
        // osgUtil::GLObjectsVisitor uses programs that could not be linked.
        for (const std::string& message : takeGlMessages())
            EXPECT_NE(message.find("not linked"), std::string::npos) << message;
    }

    std::vector<std::size_t> _numObjects;
};

TEST_P(GlFailure, OfACallIsOneMessageAndTheNextChangeSucceeds)
{
    std::size_t call = 0;
    while (call < MOST_CALLS && failCall(call))
    {
        ASSERT_FALSE(HasFailure()) << "call " << call;
        ++call;
    }
    EXPECT_GT(call, 0u);
    EXPECT_LT(call, MOST_CALLS);
    RecordProperty("failures", static_cast<int>(call));
    // Nothing has failed in the last one.
    for (const std::size_t numObjects : getNumObjects())
        EXPECT_LE(numObjects, getNumObjects().back());
}

INSTANTIATE_TEST_SUITE_P(Calls, GlFailure,
                         ::testing::Values(Case{"ShaderOnGpu", "16,device=gpu", Kind::SHADER},
                                           Case{"ProgramOnGpu", "16,device=gpu", Kind::PROGRAM},
                                           Case{"FramebufferOnGpu", "16,device=gpu", Kind::FRAMEBUFFER},
                                           Case{"BufferOnGpu", "16,device=gpu", Kind::BUFFER},
                                           Case{"MappingOnGpu", "16,device=gpu", Kind::MAPPING},
                                           Case{"QueryOnGpu", "16,device=gpu", Kind::QUERY},
                                           Case{"ProgramWithPalette", "16,device=gpu,palette=ldraw", Kind::PROGRAM},
                                           Case{"FramebufferWithPalette", "16,device=gpu,palette=ldraw",
                                                Kind::FRAMEBUFFER},
                                           Case{"ShaderInCoreProfile", "16,device=gpu", Kind::SHADER, true},
                                           Case{"ProgramOnCpu", "16,device=cpu", Kind::PROGRAM},
                                           Case{"FramebufferOnCpu", "16,device=cpu", Kind::FRAMEBUFFER},
                                           Case{"BufferOnCpu", "16,device=cpu", Kind::BUFFER}),
                         [](const auto& failing) { return failing.param.name; });

/** Several nodes whose bricks are remade in every frame, in contexts in which every call fails. */
class GlFailures : public GlTest, public ::testing::WithParamInterface<Case>
{
protected:
    static constexpr std::size_t NUM_NODES = 3;

    /** Open a new context whose calls fail. @return the number of calls that have failed in some frames. */
    std::size_t failInNewContext()
    {
        _context = createContext();
        setUpViewer(_viewer, *_context, *_scene);
        _context->makeCurrent();
        GlFaults::beginAll(*_context, GetParam().kind);
        return failInFrames(3);
    }

    std::size_t failInFrames(int count)
    {
        const std::size_t before = GlFaults::getNumFailed();
        _notices += noticesOf([&] { drawFrames(_viewer, count); });
        return GlFaults::getNumFailed() - before;
    }

    void expectFailure(const LegoNode& lego) const
    {
        const unsigned int contextID = _context->getState()->getContextID();
        EXPECT_FALSE(lego.getFailure(contextID).empty());
        EXPECT_FALSE(lego.isLegolized(contextID));
    }

    LegoNode& getNode(unsigned int index) { return dynamic_cast<LegoNode&>(*_scene->getChild(index)); }

    void SetUp() override
    {
        for (std::size_t index = 0; index < NUM_NODES; ++index)
        {
            const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(GetParam().settings));
            lego->setWaiting(true);
            lego->setUpdateMode(LegoNode::UpdateMode::EVERY_FRAME);
            lego->addChild(createSphere(6));
            _scene->addChild(lego);
        }
    }

    const std::string& getNotices() const { return _notices; }

private:
    const osg::ref_ptr<osg::Group> _scene = new osg::Group;
    osg::ref_ptr<osg::GraphicsContext> _context;
    osgViewer::Viewer _viewer;
    std::string _notices;
};

TEST_P(GlFailures, AreNotTriedAgainBeforeTheSettingsAreSet)
{
    const std::size_t numFirst = failInNewContext();
    EXPECT_GT(numFirst, 0u);
    EXPECT_EQ(failInFrames(5), 0u);
    for (unsigned int index = 0; index < NUM_NODES; ++index)
        expectFailure(getNode(index));
    EXPECT_EQ(countWarnings(getNotices()), static_cast<std::ptrdiff_t>(NUM_NODES)) << getNotices();
    getNode(0).setSettings(getNode(0).getSettings());
    const std::size_t numAgain = failInFrames(1);
    EXPECT_GT(numAgain, 0u);
    EXPECT_LE(numAgain, numFirst);
    EXPECT_EQ(failInFrames(5), 0u);
    expectFailure(getNode(0));
    GlFaults::end();
    for (unsigned int index = 0; index < NUM_NODES; ++index)
        getNode(index).setSettings(getNode(index).getSettings());
    failInFrames(2);
    for (unsigned int index = 0; index < NUM_NODES; ++index)
        EXPECT_EQ(getNode(index).getFailure(0), "");
    takeGlMessages();
}

TEST_P(GlFailures, AreTriedAgainInANewContext)
{
    EXPECT_GT(failInNewContext(), 0u);
    EXPECT_EQ(failInFrames(2), 0u);
    EXPECT_GT(failInNewContext(), 0u);
    GlFaults::end();
    takeGlMessages();
}

TEST_F(GlTest, NodesThatFailWithBricksOfTheSameSourceAreNotLegolized)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("16,device=cpu,look=full"));
    lego->setWaiting(true);
    lego->addChild(createSphere(6));
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *lego);
    drawFrames(viewer, 2);
    const unsigned int contextID = context->getState()->getContextID();
    ASSERT_TRUE(lego->isLegolized(contextID));
    context->makeCurrent();
    GlFaults::beginAll(*context, Kind::SHADER);
    lego->setSettings(parseSettings("16,device=cpu,look=plain"));
    noticesOf([&] { drawFrames(viewer, 2); });
    EXPECT_TRUE(GlFaults::end());
    EXPECT_NE(lego->getFailure(contextID), "");
    EXPECT_FALSE(lego->isLegolized(contextID));
    takeGlMessages();
}

TEST_F(GlTest, StoredBricksThatFailLeaveNoVertexArrays)
{
    const osg::ref_ptr<osg::Node> sphere = createSphere(6);
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    const osg::ref_ptr<LegoNode> lego = new LegoNode;
    lego->setWaiting(true);
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *sphere);
    viewer.setSceneData(lego);
    context->makeCurrent();
    GlFaults::beginAll(*context, Kind::PROGRAM);
    lego->setStoredBricks(legolizeOnCpu(*sphere, parseSettings("8")));
    noticesOf([&] { drawFrames(viewer, 2); });
    EXPECT_GT(countDrawn(*readPixels(*context)), 1000u);
    EXPECT_TRUE(glIsEnabled(GL_VERTEX_ARRAY));
    // Programs fail again in this frame, before triangles are drawn in the next one.
    lego->setStoredBricks(legolizeOnCpu(*sphere, parseSettings("9")));
    noticesOf([&] { drawFrames(viewer, 1); });
    EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY));
    GlFaults::end();
    takeGlMessages();
}

INSTANTIATE_TEST_SUITE_P(Calls, GlFailures,
                         ::testing::Values(Case{"ShaderOnGpu", "16,device=gpu", Kind::SHADER},
                                           Case{"ProgramOnGpu", "16,device=gpu", Kind::PROGRAM},
                                           Case{"ShaderOnCpu", "16,device=cpu", Kind::SHADER},
                                           Case{"ProgramOnCpu", "16,device=cpu", Kind::PROGRAM}),
                         [](const auto& failing) { return failing.param.name; });

} // namespace

} // namespace osgLego::test
