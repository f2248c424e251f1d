#pragma once

#include <array>
#include <cstddef>

#include <osg/Matrixd>
#include <osg/RenderInfo>
#include <osg/State>
#include <osg/Texture2D>
#include <osg/Vec3d>
#include <osgUtil/RenderStage>

namespace osgLego
{

/** The shadow maps of the scene that bricks are drawn in, for shaders/polygonization/shadows.glsl.
 *
 * Techniques of osgShadow bind a depth texture with comparison, and position a TexGen from eye coordinates to the map
 * in the same texture unit. The light of a map is the one that is nearest to the centre of the map's projection.
 * Used while a drawable is drawn, as long as its state stays applied.
 */
class ShadowMaps
{
public:
    static constexpr std::size_t MAXIMUM = 4;

    /** Find the maps of the enabled lights. Further maps than MAXIMUM are ignored.
     * @param place in eye coordinates, where the directions to lights are compared. */
    ShadowMaps(osg::RenderInfo& renderInfo, const osg::Vec3d& place);

    bool isEmpty() const { return _count == 0; }

    /** Bind the textures, and set the uniforms of the program that a state has applied. Needs its context current. */
    void apply(osg::State& state) const;

private:
    struct Map
    {
        unsigned int unit = 0; // to which the technique binds it
        const osg::Texture2D* texture = nullptr;
        osg::Matrixd eyeToMap;
        int light = 0; // its place in LightNumbers
    };

    void addMaps(const osg::State& state, osgUtil::RenderStage& stage);
    Map* findOrAddMap(unsigned int unit);
    void findLights(const osg::State& state, osgUtil::RenderStage& stage, const osg::Vec3d& place);

    std::array<Map, MAXIMUM> _maps;
    std::size_t _count = 0;
    float _softness = 0.0f; // the radius in which osgShadow::SoftShadowMap blurs shadows, in texture coordinates
};

} // namespace osgLego
