#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/light/LatitudeLongitude.h>
#include <osgLego/light/LightProbeState.h>

#include <GlslFunctionTest.h>
#include <Probes.h>

#include <osg/Uniform>

namespace osgLego::test
{

namespace
{

#define AMBIENT_LIGHT                                                                                                  \
    "#include \"light/ambient_light.glsl\"\n"                                                                          \
    "void main() { result = vec4(irradianceAt(a.xyz), 1.0); }\n"

constexpr const char* HARMONICS = AMBIENT_LIGHT;
constexpr const char* CONVOLVED_MAP = "#define CONVOLVED_MAP\n" AMBIENT_LIGHT;
constexpr const char* REFLECTION = "#include \"light/ambient_light.glsl\"\n"
                                   "void main() { result = vec4(reflectionAt(a.xyz, a.xyz, b.x), 1.0); }\n";

class AmbientLight : public GlslFunctionTest
{
protected:
    /** Compare the shader's irradiance with the probe's, for many surface normals. */
    void expectIrradiance(const LightProbe& probe, double tolerance)
    {
        std::vector<Arguments> arguments;
        for (const osg::Vec3d& normal : createNormals())
            arguments.push_back({glm::vec4(normal.x(), normal.y(), normal.z(), 0.0)});
        const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
        applyLightProbe(probe, *stateSet);
        stateSet->addUniform(new osg::Uniform("eyeToWorld", toUniform(osg::Matrixd())));
        const bool hasMap = !defineLightProbe(probe).empty();
        const std::vector<glm::vec4> results =
            evaluate(hasMap ? "tests/convolved_map.vert" : "tests/ambient_light.vert",
                     hasMap ? CONVOLVED_MAP : HARMONICS, arguments, *stateSet);
        for (std::size_t index = 0; index < results.size(); ++index)
        {
            const osg::Vec3d expected = probe.getIrradiance(createNormals()[index]);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(results[index][channel], expected[channel], tolerance) << index;
        }
    }

    static osg::ref_ptr<LightProbe> createProbe(const RadianceOf& radianceOf)
    {
        osg::ref_ptr<LightProbe> probe = new LightProbe;
        std::string error;
        EXPECT_TRUE(probe->setImage(createLatitudeLongitude(128, radianceOf), LightProbe::LATITUDE_LONGITUDE, error))
            << error;
        probe->setRotation(osg::Quat(0.7, osg::Vec3d(0.3, -0.5, 0.8)));
        probe->setIntensity(1.5);
        return probe;
    }
};

TEST_F(AmbientLight, TheShadersHarmonicsEqualTheProbes)
{
    // Light that contains every harmonic, in a different proportion for each channel.
    const osg::ref_ptr<LightProbe> probe = createProbe(
        [](const osg::Vec3d& d)
        {
            return osg::Vec3d(2.0 + 0.4 * d.x() + 0.3 * d.x() * d.y() + 0.2 * d.x() * d.x(),
                              2.0 + 0.5 * d.y() + 0.4 * d.y() * d.z() + 0.3 * d.y() * d.y(),
                              2.0 + 0.6 * d.z() + 0.5 * d.x() * d.z() + 0.4 * d.z() * d.z());
        });
    ASSERT_FALSE(probe->usesConvolvedMap());
    expectIrradiance(*probe, 1e-5);
}

TEST_F(AmbientLight, TheShadersConvolvedMapEqualsTheProbes)
{
    const osg::ref_ptr<LightProbe> probe =
        createProbe([](const osg::Vec3d& d) { return d.x() > 0.97 ? osg::Vec3d(60, 50, 40) : osg::Vec3d(1, 1, 1); });
    ASSERT_TRUE(probe->usesConvolvedMap());
    expectIrradiance(*probe, 0.02);
}

TEST_F(AmbientLight, EachRoughnessReflectsItsLevelOfTheProbe)
{
    const osg::ref_ptr<LightProbe> probe =
        createProbe([](const osg::Vec3d& d) { return d.x() > 0.8 ? osg::Vec3d(9, 8, 7) : osg::Vec3d(1, 1, 1); });
    probe->setRotation(osg::Quat());
    const osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    applyLightProbe(*probe, *stateSet);
    stateSet->addUniform(new osg::Uniform("eyeToWorld", toUniform(osg::Matrixd())));
    for (int level = 0; level < LightProbe::REFLECTION_LEVELS; ++level)
    {
        // Two pixels, of the lamp and opposite to it, seen along the normal. Their quotient does not depend on the
        // reflectance of the material.
        const osg::Image& map = *probe->getReflectionMap(level);
        std::vector<osg::Vec3d> pixels;
        std::vector<Arguments> arguments;
        for (const int column : {3 * map.s() / 4, map.s() / 4})
        {
            const int row = map.t() / 2;
            pixels.push_back(pixelOf(map, column, row));
            const osg::Vec3d n = LatitudeLongitude::directionAt((column + 0.5) / map.s(), (row + 0.5) / map.t());
            const float roughness = static_cast<float>(level) / (LightProbe::REFLECTION_LEVELS - 1);
            arguments.push_back({glm::vec4(n.x(), n.y(), n.z(), 0.0), glm::vec4(roughness)});
        }
        const std::vector<glm::vec4> results = evaluate("tests/reflection.vert", REFLECTION, arguments, *stateSet);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(results[0][channel] / results[1][channel], pixels[0][channel] / pixels[1][channel], 0.02)
                << level;
    }
}

} // namespace

} // namespace osgLego::test
