#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/BrickModel.h>
#include <osgLego/Export.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/LightProbe.h>

#include <string>

#include <osg/Group>
#include <osg/ref_ptr>

namespace osgLego
{

class LegoPipeline;

/** A group whose children are drawn as bricks in their place, made on the GPU and made anew when they change.
 *
 * The children, the source, may be any subgraph (see SceneTriangles for what of it counts). They are updated and get
 * events as ever; what is drawn, picked and bounded is their bricks, studs included. In a context that can't make
 * bricks the source is drawn as it is, and a warning says what is missing.
 *
 * Preconditions:
 * 1. A context needs OpenGL 4.0 or later, compatibility profile.
 * 2. The source is changed where OSG allows a scene to be changed: in the update traversal or between frames. Arrays
 *    that change are said so by `array->dirty()`, or belong to a geometry whose data variance is DYNAMIC; transforms,
 *    switches, materials and textures need nothing. For what escapes even so there is dirty().
 * 3. The scene is updated once a frame, as every osgViewer does. Without an update traversal only the first source,
 *    setSettings() and dirty() are noticed.
 * 4. Contexts that share GL objects are drawn in one thread (osgViewer::ViewerBase::SingleThreaded).
 * 5. As with every node, GL objects are released while the node is in the scene of a context that closes, or by
 *    releaseGLObjects() before, while no thread draws (osgViewer::ViewerBase::stopThreading()).
 *
 * Usage:
 *
 *     osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode;
 *     lego->addChild(osgDB::readRefNodeFile("bunny.ply"));
 *     viewer.setSceneData(lego);
 *
 * Other node visitors than the update, event and cull visitors: those that traverse all children get the source and the
 * bricks, those that traverse active children the bricks alone. BrickIntersection tells which brick was picked.
 *
 * Written by osgDB, .osgt, .osgb and .osgx keep the node: its settings and the source. Other formats get the bricks as
 * osg::Geometry (see createBrickScene), by a WriteFileCallback that the first LegoNode puts into osgDB's registry, in
 * front of the one that is there. A program that sets one of its own later calls that in turn, or createBrickScene().
 *
 * What else of the source draws, or acts while it is culled, does so only where the source is drawn as it is: lights
 * and clip planes below the node, cameras that render to textures, levels of paged detail that are not loaded yet.
 * State set above the node has no part in the bricks' colours. Since the source is looked at once a frame, a viewer
 * that runs on demand draws all the time, as it does with every node that has an update callback.
 *
 * Functions may be called from the thread that updates the scene, those of the statistics and bricks from any.
 */
class OSGLEGO_EXPORT LegoNode : public osg::Group
{
public:
    LegoNode();
    explicit LegoNode(const LegoSettings& settings);
    LegoNode(const LegoNode& node, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgLego, LegoNode)

    /** Change the settings; the bricks are made anew in the next frame, unless only the look is another.
     * @return false, with a warning and no change, when LegoSettings::check refuses them. */
    bool setSettings(const LegoSettings& settings);
    LegoSettings getSettings() const;

    /** Change how the bricks are made to look like bricks in the full look; nothing is legolized anew.
     * @return false, with a warning and no change, when BrickAppearance::check refuses it. */
    bool setAppearance(const BrickAppearance& appearance);
    BrickAppearance getAppearance() const;

    /** Change the light from all around in the full look; null: the built-in sky. Under an AmbientOcclusionScene the
     * probe of that counts instead. The probe is copied: set it again after changing it. */
    void setLightProbe(const LightProbe* probe);
    osg::ref_ptr<const LightProbe> getLightProbe() const;

    /** Make the bricks anew in the next frame, whether or not a change of the source can be seen. */
    void dirty();

    /** Whether the source shows any triangle; without one there are no bricks. */
    bool hasTriangles() const;

    /** Wait after each stage of a legolization, so that getStatistics() has its times. Off at first. */
    void setTiming(bool timing);
    bool getTiming() const;

    /** Wait, in the cull traversal, for bricks that are made on the CPU, so that each frame shows the source as it is.
     * Off at first: the node goes on showing the bricks it has until the new ones are ready, and a newer change of the
     * source takes the place of an older one that is still being worked on. The first bricks are waited for in any
     * case, since there is nothing to show before. */
    void setWaiting(bool waiting);
    bool getWaiting() const;

    /** Called when bricks made on the CPU are ready to be shown from the next frame on; for viewers that run on demand,
     * which must be asked for that frame.
     *
     * Called by a thread of its own: ready() may do nothing but what is allowed from any thread, such as
     * osgViewer::ViewerBase::requestRedraw(), and may not call the node. */
    class OSGLEGO_EXPORT BricksCallback : public osg::Referenced
    {
    public:
        virtual void ready() = 0;

    protected:
        ~BricksCallback() override = default;
    };
    /** Null: call nothing. */
    void setBricksCallback(BricksCallback* callback);
    osg::ref_ptr<BricksCallback> getBricksCallback() const { return _bricksCallback; }

    /** Bring all covered cells back from the GPU with each legolization, for getBricks(contextID). Off at first. */
    void setReadBack(bool readBack);
    bool getReadBack() const;

    /** The bricks, made on the CPU when they are asked for and kept until the source changes; null without triangles.
     *
     * The cells are those of VoxelizationMethod::EXACT, whatever the settings say. Needs no GL context. */
    osg::ref_ptr<const BrickModel> getBricks() const;

    /** Every covered cell as the GPU of a context found it; null when it has not yet, or setReadBack() is off. */
    osg::ref_ptr<const BrickModel> getBricks(unsigned int contextID) const;

    /** What the last legolization in a context went through. Waits for one that is going on, as do the two below. */
    LegoStatistics getStatistics(unsigned int contextID) const;

    /** Whether a context has the bricks of the source as it is now. */
    bool isLegolized(unsigned int contextID) const;

    /** Whether a context, which is current, has all that bricks are made and drawn with; see precondition 1. */
    static bool isSupported(const osg::State& state);

    /** Why a context draws the source instead of bricks, in one sentence; empty when it does not. */
    std::string getFailure(unsigned int contextID) const;

    void traverse(osg::NodeVisitor& visitor) override;
    osg::BoundingSphere computeBound() const override;
    void setThreadSafeRefUnref(bool threadSafe) override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~LegoNode() override;

private:
    void refresh() const;
    void cull(osg::NodeVisitor& visitor);
    void visitBricks(osg::NodeVisitor& visitor);

    osg::ref_ptr<LegoPipeline> _pipeline;
    osg::ref_ptr<BricksCallback> _bricksCallback;
    mutable osg::BoundingSphere _sourceBound; // when the source was looked at last
};

} // namespace osgLego
