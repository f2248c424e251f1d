#include <osgLego/polygonization/CoreLights.h>

#include <osgLego/gl/FixedState.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/polygonization/PositionedState.h>

#include <cmath>
#include <string>

#include <osg/Math>
#include <osg/Vec4d>
#include <osgUtil/RenderBin>

namespace osgLego
{

namespace
{

/** The uniforms of a light, see shaders/gl/fixed_state.glsl. */
struct LightNames
{
    explicit LightNames(std::size_t number) :
        prefix("lightSources[" + std::to_string(number) + "]."), ambient((prefix + "ambient").c_str()),
        diffuse((prefix + "diffuse").c_str()), specular((prefix + "specular").c_str()),
        position((prefix + "position").c_str()), spotDirection((prefix + "spotDirection").c_str()),
        spotExponent((prefix + "spotExponent").c_str()), spotCutoff((prefix + "spotCutoff").c_str()),
        spotCosCutoff((prefix + "spotCosCutoff").c_str()), constant((prefix + "constantAttenuation").c_str()),
        linear((prefix + "linearAttenuation").c_str()), quadratic((prefix + "quadraticAttenuation").c_str())
    {
    }

    std::string prefix;
    UniformName ambient;
    UniformName diffuse;
    UniformName specular;
    UniformName position;
    UniformName spotDirection;
    UniformName spotExponent;
    UniformName spotCutoff;
    UniformName spotCosCutoff;
    UniformName constant;
    UniformName linear;
    UniformName quadratic;
};

const LightNames& getNames(std::size_t number)
{
    static const std::array<LightNames, LightNumbers::MAXIMUM> NAMES{LightNames(0), LightNames(1), LightNames(2),
                                                                     LightNames(3), LightNames(4), LightNames(5),
                                                                     LightNames(6), LightNames(7)};
    return NAMES[number];
}

glm::vec4 toVector(const osg::Vec4& vector)
{
    return {vector.x(), vector.y(), vector.z(), vector.w()};
}

void setLight(const ProgramUniforms& uniforms, const LightNames& names, const osg::Light& light,
              const osg::Matrixd& toEye)
{
    const osg::Vec4d position = osg::Vec4d(light.getPosition()) * toEye;
    const osg::Vec3d direction = osg::Matrixd::transform3x3(osg::Vec3d(light.getDirection()), toEye);
    const float cutoff = light.getSpotCutoff();
    uniforms.set(names.ambient, toVector(light.getAmbient()));
    uniforms.set(names.diffuse, toVector(light.getDiffuse()));
    uniforms.set(names.specular, toVector(light.getSpecular()));
    uniforms.set(names.position, glm::vec4(position.x(), position.y(), position.z(), position.w()));
    uniforms.set(names.spotDirection, glm::vec3(direction.x(), direction.y(), direction.z()));
    uniforms.set(names.spotExponent, light.getSpotExponent());
    uniforms.set(names.spotCutoff, cutoff);
    uniforms.set(names.spotCosCutoff, static_cast<float>(std::cos(osg::DegreesToRadians(static_cast<double>(cutoff)))));
    uniforms.set(names.constant, light.getConstantAttenuation());
    uniforms.set(names.linear, light.getLinearAttenuation());
    uniforms.set(names.quadratic, light.getQuadraticAttenuation());
}

} // namespace

CoreLights::CoreLights(osg::RenderInfo& renderInfo) : _isCore(GlRequirements::isCore(*renderInfo.getState()))
{
    if (!_isCore || renderInfo.getRenderBinStack().empty()) return;
    for (const PositionedState& positioned : findPositionedStates(*renderInfo.getRenderBinStack().back()->getStage()))
    {
        if (!positioned.container) continue;
        for (const auto& [attribute, matrix] : positioned.container->getAttrMatrixList())
        {
            const auto* light = dynamic_cast<const osg::Light*>(attribute.get());
            if (!light || light->getLightNum() < 0 || light->getLightNum() >= LightNumbers::MAXIMUM) continue;
            _lights[static_cast<std::size_t>(light->getLightNum())] = {light, positioned.getMatrix(matrix.get())};
        }
    }
}

void CoreLights::apply(const osg::State& state) const
{
    if (!_isCore) return;
    const ProgramUniforms uniforms(state);
    setLightModelAndMaterial(uniforms, state);
    for (std::size_t number = 0; number < _lights.size(); ++number)
        if (_lights[number].light) setLight(uniforms, getNames(number), *_lights[number].light, _lights[number].toEye);
}

} // namespace osgLego
