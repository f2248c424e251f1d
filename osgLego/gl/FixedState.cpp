#include <osgLego/gl/FixedState.h>

#include <osgLego/gl/GlRequirements.h>

#include <glm/matrix.hpp>
#include <osg/Fog>
#include <osg/LightModel>
#include <osg/Material>

namespace osgLego
{

namespace
{

template <typename Attribute>
const Attribute* findApplied(const osg::State& state, osg::StateAttribute::Type type)
{
    return dynamic_cast<const Attribute*>(state.getLastAppliedAttribute(type));
}

glm::vec4 toVector(const osg::Vec4& vector)
{
    return {vector.x(), vector.y(), vector.z(), vector.w()};
}

void setFogParameters(const ProgramUniforms& uniforms, const osg::Fog& fog)
{
    static const UniformName COLOR("fogParameters.color");
    static const UniformName DENSITY("fogParameters.density");
    static const UniformName END("fogParameters.end");
    static const UniformName SCALE("fogParameters.scale");
    uniforms.set(COLOR, toVector(fog.getColor()));
    uniforms.set(DENSITY, fog.getDensity());
    uniforms.set(END, fog.getEnd());
    uniforms.set(SCALE, 1.0f / (fog.getEnd() - fog.getStart()));
}

} // namespace

void setMatrices(const ProgramUniforms& uniforms, const osg::State& state)
{
    if (!GlRequirements::isCore(state)) return;
    static const UniformName MODEL_VIEW("modelViewMatrix");
    static const UniformName PROJECTION("projectionMatrix");
    static const UniformName MODEL_VIEW_PROJECTION("modelViewProjectionMatrix");
    static const UniformName NORMAL("eyeNormalMatrix");
    const osg::Matrixd& modelView = state.getModelViewMatrix();
    const glm::dmat3 linear(glm::make_mat4(modelView.ptr()));
    uniforms.set(MODEL_VIEW, toGlsl(modelView));
    uniforms.set(PROJECTION, toGlsl(state.getProjectionMatrix()));
    uniforms.set(MODEL_VIEW_PROJECTION, toGlsl(modelView * state.getProjectionMatrix()));
    uniforms.set(NORMAL, glm::mat3(glm::transpose(glm::inverse(linear))));
}

void setFog(const ProgramUniforms& uniforms, const osg::State& state)
{
    const auto* fog = findApplied<osg::Fog>(state, osg::StateAttribute::FOG);
    const bool isOn = fog && state.getLastAppliedMode(GL_FOG);
    const bool isLinear = isOn && fog->getMode() == osg::Fog::LINEAR;
    static const UniformName FOG_MODE("fogMode");
    uniforms.set(FOG_MODE, !isOn ? 0 : isLinear ? 1 : fog->getMode() == osg::Fog::EXP ? 2 : 3);
    if (isOn && GlRequirements::isCore(state)) setFogParameters(uniforms, *fog);
}

void setLightModelAndMaterial(const ProgramUniforms& uniforms, const osg::State& state)
{
    if (!GlRequirements::isCore(state)) return;
    static const UniformName AMBIENT("lightModel.ambient");
    static const UniformName SPECULAR("frontMaterial.specular");
    static const UniformName SHININESS("frontMaterial.shininess");
    // GL's initial values of both, where no state set has them.
    glm::vec4 ambient(0.2f, 0.2f, 0.2f, 1.0f);
    glm::vec4 specular(0.0f, 0.0f, 0.0f, 1.0f);
    float shininess = 0.0f;
    if (const auto* model = findApplied<osg::LightModel>(state, osg::StateAttribute::LIGHTMODEL))
        ambient = toVector(model->getAmbientIntensity());
    if (const auto* material = findApplied<osg::Material>(state, osg::StateAttribute::MATERIAL))
    {
        specular = toVector(material->getSpecular(osg::Material::FRONT));
        shininess = material->getShininess(osg::Material::FRONT);
    }
    uniforms.set(AMBIENT, ambient);
    uniforms.set(SPECULAR, specular);
    uniforms.set(SHININESS, shininess);
}

} // namespace osgLego
