#include <osgLego/polygonization/ShadowMaps.h>

#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/polygonization/LightNumbers.h>
#include <osgLego/polygonization/PositionedState.h>

#include <algorithm>
#include <optional>
#include <string>

#include <glm/mat4x4.hpp>
#include <osg/Light>
#include <osg/TexGen>
#include <osg/Uniform>
#include <osg/Vec4d>

namespace osgLego
{

namespace
{

// The first texture unit; after those of light probes.
constexpr unsigned int FIRST_UNIT = 8;
// The least radius in which the edges of shadows are blurred, in texels: sharper ones show the texels.
constexpr float LEAST_BLUR = 0.75f;

/** The depth texture with comparison that state sets bind to a unit; null if there is none. The last applied one may be
 * that of another drawable. */
const osg::Texture2D* findDepthTexture(const osg::State& state, unsigned int unit)
{
    const osg::State::TextureAttributeMapList& units = state.getTextureAttributeMapList();
    if (unit >= units.size()) return nullptr;
    const auto found = units[unit].find(osg::StateAttribute::TypeMemberPair(osg::StateAttribute::TEXTURE, 0));
    if (found == units[unit].end() || found->second.attributeVec.empty()) return nullptr;
    const auto* texture = dynamic_cast<const osg::Texture2D*>(found->second.attributeVec.back().first);
    return texture && texture->getShadowComparison() ? texture : nullptr;
}

/** The uniform of osgShadow::SoftShadowMap for the radius of its blur; 0 if state sets have none. */
float findSoftness(const osg::State& state)
{
    static const std::string NAME("osgShadow_softnessWidth");
    const auto found = state.getUniformMap().find(NAME);
    float softness = 0.0f;
    if (found == state.getUniformMap().end() || found->second.uniformVec.empty()) return softness;
    found->second.uniformVec.back().first->get(softness);
    return softness;
}

/** The transform of a TexGen from the eye coordinates in which it is applied. */
osg::Matrixd toMatrix(const osg::TexGen& texGen)
{
    osg::Matrixd matrix;
    for (int column = 0; column < 4; ++column)
    {
        const osg::Plane& plane = texGen.getPlane(static_cast<osg::TexGen::Coord>(column));
        for (int row = 0; row < 4; ++row)
            matrix(row, column) = plane[static_cast<unsigned int>(row)];
    }
    return matrix;
}

/** The direction in which the depth of a shadow map decreases along the ray through a place: towards the centre of the
 * map's projection, which projects to no position. */
osg::Vec3d towardsCenter(const osg::Matrixd& eyeToMap, const osg::Vec3d& place)
{
    const osg::Vec4d center = osg::Vec4d(0.0, 0.0, 1.0, 0.0) * osg::Matrixd::inverse(eyeToMap);
    osg::Vec3d direction = osg::Vec3d(center.x(), center.y(), center.z()) - place * center.w();
    direction.normalize();
    const osg::Vec4d here = osg::Vec4d(place, 1.0) * eyeToMap;
    const osg::Vec4d change = osg::Vec4d(direction, 0.0) * eyeToMap;
    return change.z() * here.w() > here.z() * change.w() ? -direction : direction;
}

using Directions = std::array<std::optional<osg::Vec3d>, LightNumbers::MAXIMUM>;

/** The directions from a place towards the lights, by their numbers. */
Directions findDirections(osgUtil::RenderStage& stage, const osg::Vec3d& place)
{
    Directions directions;
    for (const PositionedState& positioned : findPositionedStates(stage))
    {
        if (!positioned.container) continue;
        for (const auto& [attribute, matrix] : positioned.container->getAttrMatrixList())
        {
            const auto* light = dynamic_cast<const osg::Light*>(attribute.get());
            if (!light || light->getLightNum() < 0 || light->getLightNum() >= LightNumbers::MAXIMUM) continue;
            const osg::Vec4d position = osg::Vec4d(light->getPosition()) * positioned.getMatrix(matrix.get());
            osg::Vec3d direction = osg::Vec3d(position.x(), position.y(), position.z()) - place * position.w();
            direction.normalize();
            directions[static_cast<std::size_t>(light->getLightNum())] = direction;
        }
    }
    return directions;
}

} // namespace

ShadowMaps::ShadowMaps(osg::RenderInfo& renderInfo, const osg::Vec3d& place)
{
    if (renderInfo.getRenderBinStack().empty()) return; // drawn without a stage
    const osg::State& state = *renderInfo.getState();
    osgUtil::RenderStage& stage = *renderInfo.getRenderBinStack().back()->getStage();
    addMaps(state, stage);
    if (isEmpty()) return;
    findLights(state, stage, place);
    _softness = findSoftness(state);
}

void ShadowMaps::addMaps(const osg::State& state, osgUtil::RenderStage& stage)
{
    for (const PositionedState& positioned : findPositionedStates(stage))
    {
        if (!positioned.container) continue;
        for (const auto& [unit, attributes] : positioned.container->getTexUnitAttrMatrixListMap())
        {
            const auto isTexGen = [](const auto& pair) { return dynamic_cast<const osg::TexGen*>(pair.first.get()); };
            const auto last = std::find_if(attributes.rbegin(), attributes.rend(), isTexGen);
            const osg::Texture2D* texture = findDepthTexture(state, unit);
            if (last == attributes.rend() || !texture) continue;
            const auto& texGen = static_cast<const osg::TexGen&>(*last->first);
            if (texGen.getMode() != osg::TexGen::EYE_LINEAR) continue;
            if (Map* map = findOrAddMap(unit))
            {
                map->texture = texture;
                map->eyeToMap = osg::Matrixd::inverse(positioned.getMatrix(last->second.get())) * toMatrix(texGen);
            }
        }
    }
}

ShadowMaps::Map* ShadowMaps::findOrAddMap(unsigned int unit)
{
    const auto end = _maps.begin() + static_cast<std::ptrdiff_t>(_count);
    const auto found = std::find_if(_maps.begin(), end, [unit](const Map& map) { return map.unit == unit; });
    if (found != end) return &*found;
    if (_count == MAXIMUM) return nullptr;
    _maps[_count].unit = unit;
    return &_maps[_count++];
}

void ShadowMaps::findLights(const osg::State& state, osgUtil::RenderStage& stage, const osg::Vec3d& place)
{
    const LightNumbers numbers(state);
    const Directions directions = findDirections(stage, place);
    for (std::size_t index = 0; index < _count; ++index)
    {
        const osg::Vec3d center = towardsCenter(_maps[index].eyeToMap, place);
        double nearest = -2.0;
        for (int light = 0; light < numbers.count; ++light)
        {
            const auto& direction =
                directions[static_cast<std::size_t>(numbers.numbers[static_cast<std::size_t>(light)])];
            const double cosine = direction ? *direction * center : -1.0;
            if (cosine <= nearest) continue;
            nearest = cosine;
            _maps[index].light = light;
        }
    }
}

void ShadowMaps::apply(osg::State& state) const
{
    std::array<int, MAXIMUM> units{};
    std::array<int, MAXIMUM> lights{};
    std::array<float, MAXIMUM> blurs{};
    std::array<glm::mat4, MAXIMUM> planes{};
    for (std::size_t index = 0; index < MAXIMUM; ++index)
    {
        // Samplers that are not used also need a texture of their kind.
        const Map& map = _maps[std::min(index, _count - 1)];
        const unsigned int unit = FIRST_UNIT + static_cast<unsigned int>(index);
        state.applyTextureAttribute(unit, map.texture);
        state.haveAppliedTextureAttribute(unit, map.texture);
        units[index] = static_cast<int>(unit);
        lights[index] = map.light;
        blurs[index] = std::max(LEAST_BLUR, _softness * static_cast<float>(map.texture->getTextureWidth()));
        planes[index] = glm::transpose(toGlsl(map.eyeToMap));
    }
    static const UniformName NUMBER("numShadowMaps");
    static const UniformName MAPS("shadowMaps");
    static const UniformName LIGHTS("shadowedLights");
    static const UniformName BLURS("shadowBlurs");
    static const UniformName PLANES("shadowPlanes");
    const ProgramUniforms uniforms(state);
    uniforms.set(NUMBER, static_cast<int>(_count));
    uniforms.set(MAPS, units.data(), static_cast<GLsizei>(MAXIMUM));
    uniforms.set(LIGHTS, lights.data(), static_cast<GLsizei>(MAXIMUM));
    uniforms.set(BLURS, blurs.data(), static_cast<GLsizei>(MAXIMUM));
    uniforms.set(PLANES, planes.data(), static_cast<GLsizei>(MAXIMUM));
}

} // namespace osgLego
