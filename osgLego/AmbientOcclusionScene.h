#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/Export.h>
#include <osgLego/LightProbe.h>

#include <memory>

#include <osg/Group>
#include <osg/ref_ptr>

namespace osgLego
{

class AmbientOcclusionViews;

/** A group that draws its children with ambient occlusion, lit by a light probe (the paper, section III-D).
 *
 * The children are drawn into separate buffers of the size of the viewport of the camera that culls the group.
 * Occlusion and bent normals are computed from depths and normals with a horizon-based method (Jimenez et al. 2016,
 * "Practical Realtime Strategies for Accurate Indirect Occlusion"). Occlusion of bricks by distant bricks of the same
 * LegoNode, which is computed once for each brick set, is added (AmbientOcclusionSettings::distant). The result is
 * drawn into the frame with depth, after other opaque nodes and before transparent ones, so that nodes outside the
 * group intersect its children correctly.
 *
 * - LegoNodes with the full look get the light of the probe from the group: irradiance(bent normal) * (1 - occlusion) *
 *   colour, plus reflections on plastic.
 * - Other children occlude and are occluded, too: the colours that their state and programs produce are multiplied by
 *   (1 - occlusion).
 * - Transparent children (in render bins from osg::StateSet::TRANSPARENT_BIN on) are drawn afterwards, without
 *   occlusion.
 *
 * Preconditions:
 * 1. Contexts have OpenGL 4.0 or later; see precondition 1 of LegoNode. Otherwise, or if there is too little memory
 *    for the buffers, the group draws its children like an osg::Group, and a warning gives the reason. Cameras that
 *    draw only depth, as for shadows, also draw the children like an osg::Group.
 * 2. Programs of the children write gl_FragColor, or every gl_FragData.
 * 3. Fog is set in the state above the group, not by the children.
 * 4. Projections map the near plane to depth 0 and a finite far plane to depth 1.
 * 5. The GPU has memory for 48 bytes per pixel, or 160 if the camera's target has several samples, for each camera and
 *    cull visitor (an osgViewer::View has two).
 * 6. When a context closes, the node is still in its scene, or releaseGLObjects() has been called before.
 *
 * Works with any camera and viewport, in several views and windows, inside cameras that render to textures, and above
 * and below an osgShadow::ShadowedScene; uses four samples per pixel if the camera's target has more than one. Inside
 * another AmbientOcclusionScene, the group draws its children like an osg::Group.
 *
 * Usage:
 *
 *     osg::ref_ptr<osgLego::AmbientOcclusionScene> scene = new osgLego::AmbientOcclusionScene;
 *     scene->addChild(lego);
 *     viewer.setSceneData(scene);
 *
 * Functions may be called from the thread that updates the scene; getTimes() from any thread.
 */
class OSGLEGO_EXPORT AmbientOcclusionScene : public osg::Group
{
public:
    AmbientOcclusionScene();
    AmbientOcclusionScene(const AmbientOcclusionScene& scene, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgLego, AmbientOcclusionScene)

    /** Enable (the default) or disable ambient occlusion. If disabled, the group acts like an osg::Group at no extra
     * cost. */
    void setEnabled(bool enabled) { _enabled = enabled; }
    bool getEnabled() const { return _enabled; }

    /** Change how occlusion is computed and shown.
     * @return false, with a warning and no change, if AmbientOcclusionSettings::check finds an error. */
    bool setSettings(const AmbientOcclusionSettings& settings);
    const AmbientOcclusionSettings& getSettings() const { return _settings; }

    /** Change the environment light; null: the built-in sky. The probe is copied: set it again after changing it. */
    void setLightProbe(const LightProbe* probe);
    /** The copy of the probe; never null. */
    const LightProbe* getLightProbe() const { return _lightProbe; }

    /** Wait for the GPU after each pass, so that getTimes() can return times. Off by default. */
    void setTiming(bool timing) { _timing = timing; }
    bool getTiming() const { return _timing; }
    /** The times of the last frame in a context; 0 without setTiming(). */
    AmbientOcclusionTimes getTimes(unsigned int contextID) const;

    void traverse(osg::NodeVisitor& visitor) override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~AmbientOcclusionScene() override;

private:
    bool _enabled = true;
    AmbientOcclusionSettings _settings;
    std::unique_ptr<AmbientOcclusionViews> _views;
    osg::ref_ptr<const LightProbe> _lightProbe;
    bool _timing = false;
};

} // namespace osgLego
