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

/** A group whose children are drawn with ambient occlusion, in the light of a probe: the last step of the paper
 * (III-D).
 *
 * The children are drawn into buffers of their own, as large as the viewport of the camera that culls the group; from
 * depths and normals there follow occlusion and bent normals, horizon-based (Jimenez et al. 2016, "Practical Realtime
 * Strategies for Accurate Indirect Occlusion"); and the picture is put into the frame with depth, after what else is
 * opaque there and before what is transparent. So nodes outside the group intersect its children as they should.
 *
 * - LegoNodes of the full look leave the light of the probe to the group: irradiance(bent normal) * (1 - occlusion) *
 *   colour, and what plastic mirrors.
 * - Other children occlude and are occluded too; their colours, as their own state and programs give them, are
 *   multiplied by (1 - occlusion).
 * - Transparent children (render bins from osg::StateSet::TRANSPARENT_BIN on) are drawn behind, without occlusion.
 *
 * Preconditions:
 * 1. A context has OpenGL 4.0 or later, compatibility profile; others, and those with too little memory for the
 *    buffers, draw the children as a plain osg::Group does, and a warning says why. So do cameras that draw
 *    depths alone, as for shadows.
 * 2. Programs of the children write gl_FragColor, or every gl_FragData.
 * 3. Fog of the children is that of the state above the group, where there is any.
 * 4. Projections have a near plane at depth 0 and a finite far plane at depth 1.
 * 5. There is memory on the GPU for 48 bytes a pixel, or 140 with several samples, for each camera and cull visitor, of
 *    which an osgViewer::View has two.
 * 6. GL objects are released while the node is in the scene of a context that closes, or by releaseGLObjects() before.
 *
 * Works under any camera, in several views and windows, inside cameras that render to textures, and at any viewport;
 * with four samples a pixel if the camera's target has more than one. A group within such a group is a plain one.
 *
 * Usage:
 *
 *     osg::ref_ptr<osgLego::AmbientOcclusionScene> scene = new osgLego::AmbientOcclusionScene;
 *     scene->addChild(lego);
 *     viewer.setSceneData(scene);
 *
 * Functions may be called from the thread that updates the scene; getTimes() from any.
 */
class OSGLEGO_EXPORT AmbientOcclusionScene : public osg::Group
{
public:
    AmbientOcclusionScene();
    AmbientOcclusionScene(const AmbientOcclusionScene& scene, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgLego, AmbientOcclusionScene)

    /** Switch it on (the default) or off; off, the group is a plain one and costs nothing. */
    void setEnabled(bool enabled) { _enabled = enabled; }
    bool getEnabled() const { return _enabled; }

    /** Change how occlusion is computed and shown.
     * @return false, with a warning and no change, when AmbientOcclusionSettings::check refuses it. */
    bool setSettings(const AmbientOcclusionSettings& settings);
    const AmbientOcclusionSettings& getSettings() const { return _settings; }

    /** Change the light from all around; null: the built-in sky. The probe is copied: set it again after changing
     * it. */
    void setLightProbe(const LightProbe* probe);
    /** The copy. */
    const LightProbe* getLightProbe() const { return _lightProbe; }

    /** Wait after each pass, so that getTimes() has its times. Off at first. */
    void setTiming(bool timing) { _timing = timing; }
    bool getTiming() const { return _timing; }
    /** What the last frame in a context took. */
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
