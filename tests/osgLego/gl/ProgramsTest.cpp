#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/occlusion/AmbientOcclusionView.h>

#include <GlTest.h>
#include <GlslValidator.h>
#include <Meshes.h>
#include <Probes.h>

#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>

namespace osgLego::test
{

namespace
{

using Probes = std::vector<osg::ref_ptr<LightProbe>>;

/** Lets the library create programs in every variant. As after every GL test, glslangValidator checks them. */
class Programs : public GlTest
{
protected:
    /** The built-in sky, and light that needs the convolved map. */
    static Probes createProbes()
    {
        osg::ref_ptr<LightProbe> lamp = new LightProbe;
        std::string error;
        const auto radiance = [](const osg::Vec3d& d)
        { return d.x() > 0.97 ? osg::Vec3d(60, 50, 40) : osg::Vec3d(1, 1, 1); };
        EXPECT_TRUE(lamp->setImage(createLatitudeLongitude(64, radiance), LightProbe::AUTO, error)) << error;
        EXPECT_TRUE(lamp->usesConvolvedMap());
        return {new LightProbe, lamp};
    }

    static void runPasses()
    {
        // Dense meshes are summed up in single precision.
        for (const int rings : {4, 48})
            for (const char* method : {"exact", "exact,edge=1", "exact,edge=4", "exact,palette=ldraw",
                                       "points,target=addressed", "points,target=projected,fbo=64"})
                EXPECT_TRUE(legolizeOnGpu(*createSphere(rings), parseSettings(std::string("16,method=") + method)));
    }

    static void drawLooks(const Probes& probes)
    {
        for (const osg::ref_ptr<LightProbe>& probe : probes)
            for (const char* look : {"plain", "full"})
                drawLook(*probe, std::string("8,device=cpu,look=") + look, 0);
        for (const osg::ref_ptr<LightProbe>& probe : probes)
            drawLook(*probe, "8,device=cpu,look=full", 0, true);
        for (const char* look : {"plain", "full"})
            for (const std::size_t numNew : {std::size_t(0), std::size_t(3)})
                drawLook(*probes.front(), std::string("8,device=cpu,progress=0.5,look=") + look, numNew);
    }

    static void drawLook(const LightProbe& probe, const std::string& settings, std::size_t numNewParts,
                         bool hasGridOcclusion = false)
    {
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->setLightProbe(&probe);
        lego->setNumNewParts(numNewParts);
        BrickAppearance appearance;
        appearance.occlusion = hasGridOcclusion ? BrickOcclusion::BOTH : BrickOcclusion::SCREEN;
        lego->setAppearance(appearance);
        lego->setWaiting(true);
        lego->addChild(createSphere(4));
        const osg::ref_ptr<osgShadow::ShadowedScene> shadowed = new osgShadow::ShadowedScene;
        shadowed->setShadowTechnique(new osgShadow::ShadowMap);
        shadowed->addChild(lego);
        for (const osg::ref_ptr<osg::Node>& scene : {osg::ref_ptr<osg::Node>(lego), osg::ref_ptr<osg::Node>(shadowed)})
        {
            const osg::ref_ptr<osg::GraphicsContext> context = createContext();
            osgViewer::Viewer viewer;
            setUpViewer(viewer, *context, *scene);
            viewer.frame();
        }
    }

    static void createOcclusion(const Probes& probes)
    {
        using enum AmbientOcclusionQuality;
        for (const osg::ref_ptr<LightProbe>& probe : probes)
            for (const int samples : {1, 2, 4, 8})
                for (const auto quality : {LOW, MEDIUM, HIGH})
                    for (const bool hasDistant : {false, true})
                        osg::ref_ptr(
                            new AmbientOcclusionPrograms({glm::ivec2(1), samples, quality, hasDistant}, *probe));
    }
};

TEST_F(Programs, AreCreatedWithAndWithoutEveryDefinition)
{
    runPasses();
    const Probes probes = createProbes();
    drawLooks(probes);
    createOcclusion(probes);
    const Conditions conditions = getProgramConditions();
    EXPECT_EQ(conditions.count("CONVOLVED_MAP"), 1u);
    for (const auto& [name, values] : conditions)
        EXPECT_EQ(values.size(), 2u) << "#define " << name << ": expected a program with it, and one without";
}

TEST_F(Programs, AreRejectedForWrongTypesInAndBetweenStages)
{
    if (!hasValidator()) GTEST_SKIP() << "glslangValidator is not installed";
    ShaderLibrary::add(
        {{"wrong-type.vert", "void main() { gl_Position = vec2(0.0); }\n"},
         {"right.vert", "out vec3 color;\nvoid main() { gl_Position = vec4(0.0); color = vec3(0.0); }\n"},
         {"other.frag", "in vec4 color;\nvoid main() { gl_FragColor = color; }\n"}});
    ShaderLibrary::getProgram("wrong type", {"wrong-type.vert"});
    EXPECT_EQ(takeProgramErrors().size(), 1u);
    ShaderLibrary::getProgram("different types", {"right.vert", "other.frag"});
    EXPECT_EQ(takeProgramErrors().size(), 1u);
    ShaderLibrary::getProgram("right", {"right.vert"});
    EXPECT_EQ(takeProgramErrors(), std::vector<std::string>());
}

} // namespace

} // namespace osgLego::test
