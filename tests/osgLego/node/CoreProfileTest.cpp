#include <osgLego/AmbientOcclusionScene.h>

#include <GlDebug.h>
#include <GlTest.h>
#include <Meshes.h>

#include <algorithm>
#include <array>
#include <string>

#include <osg/ClipNode>
#include <osg/Fog>
#include <osg/Geometry>
#include <osg/Light>
#include <osg/LightSource>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/Program>

namespace osgLego::test
{

namespace
{

/** Whether NVIDIA's driver reports an error of OSG, as below. */
bool isOfOsgOnNvidia(const std::string& message)
{
    constexpr std::array FUNCTIONS{"glMatrixMode", "glLoadMatrixd",   "glLoadIdentity", "glLightf",
                                   "glLightfv",    "glLightModeli",   "glLightModelfv", "glMaterialf",
                                   "glMaterialfv", "glColorMaterial", "glColor4fv",     "glFogi",
                                   "glFogf",       "glFogfv"};
    return message == "GL_INVALID_ENUM error generated. Cannot enable <cap> in the current profile." ||
           std::ranges::any_of(FUNCTIONS,
                               [&](const char* function)
                               {
                                   return message == std::string("GL_INVALID_OPERATION error generated. Function ") +
                                                         function +
                                                         " is deprecated and not available in preview contexts.";
                               });
}

/** Whether OSG, built for fixed functions, causes an error in a core context: it applies lights, fog and materials,
 * also where no program uses them, and asks for mipmaps in the way of OpenGL 1.4. */
bool isOfOsg(const std::string& message)
{
    if (isOfOsgOnNvidia(message)) return true;
    // Of glMatrixMode, glLoadMatrix, glLight, glLightModel, glMaterial, glColorMaterial and glFog.
    if (message.find("unsupported function called") != std::string::npos) return true;
    constexpr std::array MODES{"GL_LIGHTING", "GL_LIGHT0", "GL_LIGHT3", "GL_COLOR_MATERIAL", "GL_FOG"};
    return message == "GL_INVALID_ENUM in glTexParameter(pname=GL_GENERATE_MIPMAP)" ||
           std::ranges::any_of(MODES,
                               [&](const char* mode)
                               {
                                   return message == std::string("GL_INVALID_ENUM in glEnable(") + mode + ")" ||
                                          message == std::string("GL_INVALID_ENUM in glDisable(") + mode + ")";
                               });
}

/** Draws scenes in contexts of both profiles. */
class CoreProfile : public GlTest
{
protected:
    static osg::ref_ptr<LegoNode> createLego(const std::string& settings)
    {
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->setWaiting(true);
        lego->addChild(createSphere(12));
        return lego;
    }

    static osg::ref_ptr<osg::Image> draw(osg::GraphicsContext& context, osg::Node& scene)
    {
        osgViewer::Viewer viewer;
        setUpViewer(viewer, context, scene);
        viewer.frame();
        return readPixels(context);
    }

    /** @param usesUniforms whether the state of the compatibility context does, too. */
    static void expectSamePicture(const osg::Node& scene, bool usesUniforms = false)
    {
        const auto copy = [&scene] { return osg::ref_ptr(osg::clone(&scene, osg::CopyOp::DEEP_COPY_NODES)); };
        const osg::ref_ptr<osg::GraphicsContext> compatible = createContext();
        compatible->getState()->setUseModelViewAndProjectionUniforms(usesUniforms);
        compatible->getState()->setUseVertexAttributeAliasing(usesUniforms);
        const osg::ref_ptr<osg::Image> expected = draw(*compatible, *copy());
        const osg::ref_ptr<osg::Image> actual = draw(*createCoreContext("4.1"), *copy());
        EXPECT_GT(countDrawn(*expected), 1000u);
        EXPECT_EQ(countDifferent(*expected, *actual, 1), 0u);
        for (const std::string& message : takeGlMessages())
            if (!isOfOsg(message)) ADD_FAILURE() << "GL: " << message;
    }
};

/** A triangle beside the sphere, drawn with a program and a vertex array object, as both profiles can. */
osg::ref_ptr<osg::Geometry> createMarker(float left = -3.0f)
{
    const osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    triangle->setUseDisplayList(false);
    triangle->setUseVertexBufferObjects(true);
    triangle->setUseVertexArrayObject(true);
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const osg::Vec3& corner : {osg::Vec3(), osg::Vec3(1.0f, 0.0f, 0.0f), osg::Vec3(0.0f, 0.0f, 1.0f)})
        vertices->push_back(corner + osg::Vec3(left, 0.0f, 0.0f));
    triangle->setVertexArray(vertices);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       "#version 400\n"
                                       "in vec4 osg_Vertex;\n"
                                       "uniform mat4 osg_ModelViewProjectionMatrix;\n"
                                       "void main() { gl_Position = osg_ModelViewProjectionMatrix * osg_Vertex; }\n"));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, "#version 400\n"
                                                              "out vec4 color;\n"
                                                              "void main() { color = vec4(1.0, 0.5, 0.0, 1.0); }\n"));
    triangle->getOrCreateStateSet()->setAttributeAndModes(program);
    return triangle;
}

/** A spotlight in front of a node below a transform, and fog. */
osg::ref_ptr<osg::Group> createLitScene(LegoNode& lego)
{
    const osg::ref_ptr<osg::Light> light = new osg::Light(3);
    light->setPosition(osg::Vec4(1.0f, -4.0f, 3.0f, 1.0f));
    light->setDirection(osg::Vec3(-0.3f, 1.0f, -0.7f));
    light->setDiffuse(osg::Vec4(1.0f, 0.6f, 0.2f, 1.0f));
    light->setSpecular(osg::Vec4(0.5f, 1.0f, 0.5f, 1.0f));
    light->setSpotCutoff(25.0f);
    light->setSpotExponent(4.0f);
    light->setLinearAttenuation(0.1f);
    const osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(light);
    const osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrix::rotate(0.4, osg::Vec3d(0.0, 0.0, 1.0)));
    moved->addChild(source);
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(moved);
    scene->addChild(&lego);
    const osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setMode(osg::Fog::LINEAR);
    fog->setColor(osg::Vec4(0.8f, 0.3f, 0.6f, 1.0f));
    fog->setStart(5.0f);
    fog->setEnd(40.0f);
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setSpecular(osg::Material::FRONT_AND_BACK, osg::Vec4(0.2f, 0.9f, 0.4f, 1.0f));
    material->setShininess(osg::Material::FRONT_AND_BACK, 20.0f);
    osg::StateSet& state = *scene->getOrCreateStateSet();
    state.setAttributeAndModes(fog);
    state.setAttribute(material);
    state.setMode(GL_LIGHT3, osg::StateAttribute::ON);
    return scene;
}

TEST_F(CoreProfile, ShowsTheSameTriangles)
{
    expectSamePicture(*createLego("12,device=cpu,drawing=triangles,look=plain"));
}

TEST_F(CoreProfile, ShowsTheSameSplats)
{
    expectSamePicture(*createLego("12,device=cpu,drawing=splats,look=plain"));
}

TEST_F(CoreProfile, ShowsTheSameFullLook)
{
    for (const char* drawing : {"triangles", "splats"})
        expectSamePicture(*createLego(std::string("12,device=cpu,look=full,drawing=") + drawing));
}

TEST_F(CoreProfile, ShowsTheSameLightsFogAndMaterial)
{
    for (const char* settings : {"drawing=triangles,look=plain", "drawing=splats,look=plain",
                                 "drawing=triangles,look=full", "drawing=splats,look=full"})
    {
        const osg::ref_ptr<LegoNode> lego = createLego(std::string("12,device=cpu,") + settings);
        BrickAppearance appearance;
        appearance.materialSpecular = true;
        lego->setAppearance(appearance);
        expectSamePicture(*createLitScene(*lego));
    }
}

TEST_F(CoreProfile, CutsBricksAtTheSameClipPlanes)
{
    for (const char* settings : {"look=plain", "look=full", "look=plain,drawing=splats"})
    {
        const osg::ref_ptr<osg::ClipNode> clip = new osg::ClipNode;
        clip->addClipPlane(new osg::ClipPlane(0, 1.0, 0.3, 0.2, 0.05));
        clip->addClipPlane(new osg::ClipPlane(3, -0.2, 0.4, -1.0, 0.3));
        clip->addChild(createLego(std::string("12,device=cpu,") + settings));
        const osg::ref_ptr<osg::MatrixTransform> moved =
            new osg::MatrixTransform(osg::Matrix::rotate(0.4, osg::Vec3d(0.0, 0.0, 1.0)));
        moved->addChild(clip);
        const osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(moved);
        expectSamePicture(*scene);
    }
}

TEST_F(CoreProfile, ShowsTheSameBricksOfThePasses)
{
    for (const char* method : {"exact", "points,target=addressed", "points,target=projected"})
        expectSamePicture(*createLego(std::string("12,device=gpu,look=plain,method=") + method));
}

TEST_F(CoreProfile, ShowsTheSameColorsOfTextures)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("16,device=gpu,look=plain"));
    lego->addChild(createTorus());
    expectSamePicture(*lego);
}

TEST_F(CoreProfile, LeavesOtherGeometryAsItIs)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(createMarker());
    scene->addChild(createLego("12,device=cpu,look=plain"));
    scene->addChild(createMarker(3.0f));
    expectSamePicture(*scene, true);
}

TEST_F(CoreProfile, RequiresUniformsForMatrices)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createCoreContext("4.1");
    context->makeCurrent();
    context->getState()->setUseModelViewAndProjectionUniforms(false);
    EXPECT_NE(LegoNode::getMissing(*context->getState()).find("setUseModelViewAndProjectionUniforms(true)"),
              std::string::npos);
}

TEST_F(CoreProfile, ShowsTheSameOccludedScene)
{
    const osg::ref_ptr<AmbientOcclusionScene> scene = new AmbientOcclusionScene;
    scene->addChild(createLego("12,device=cpu,look=full"));
    expectSamePicture(*scene);
}

} // namespace

} // namespace osgLego::test
