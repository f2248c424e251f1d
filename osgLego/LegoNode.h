#pragma once

#include <osgLego/BrickAppearance.h>
#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/Export.h>
#include <osgLego/LegoProgress.h>
#include <osgLego/LegoSettings.h>
#include <osgLego/LegoStatistics.h>
#include <osgLego/LightProbe.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/Matrixd>
#include <osg/ref_ptr>

namespace osgUtil
{
class CullVisitor;
}

namespace osgLego
{

class LegoPipeline;

/** A group that draws its children as bricks, in their place, and remakes the bricks when the children change.
 *
 * The children, called the source, may be any subgraph; SceneTriangles lists the parts of it that are used. They take
 * part in update and event traversals as in any osg::Group, but their bricks, studs included, are drawn, picked and
 * bounded instead. In a context that cannot draw bricks, the source itself is drawn, and a warning names the missing
 * feature.
 *
 * Preconditions:
 * 1. Contexts provide OpenGL 4.0 or later. In the core profile, their osg::State uses uniforms for matrices and aliases
 *    vertex attributes; see docs/embedding.md.
 * 2. The source changes only where OSG allows a scene to change: in the update traversal or between frames. A change of
 *    an array is announced by `array->dirty()`, or the array belongs to a geometry whose data variance is DYNAMIC;
 *    transforms, switches, materials and textures need no announcement. Call dirty() after a change that is not
 *    detected even so.
 * 3. The scene is updated once a frame, as in every osgViewer, before it is culled. The bound of a node that changes
 *    in cull traversals alone may be one frame late.
 * 4. Contexts that share GL objects are drawn in one thread (osgViewer::ViewerBase::SingleThreaded).
 * 5. As for every node, GL objects are released while the node is in the scene of a context that closes, or earlier by
 *    releaseGLObjects() while no thread draws (osgViewer::ViewerBase::stopThreading()).
 *
 * Usage:
 *
 *     osg::ref_ptr<osgLego::LegoNode> lego = new osgLego::LegoNode;
 *     lego->addChild(osgDB::readRefNodeFile("cow.osgt"));
 *     viewer.setSceneData(lego);
 *
 * Node visitors other than the update, event and cull visitors see the bricks alone if they traverse active children,
 * and both the source and the bricks if they traverse all children. Before the first bricks, they see the same as
 * frames show (LegoSettings::View::meanwhile), or wait for the bricks if they need triangles. BrickIntersection gives
 * the brick that was picked.
 *
 * Bricks can also be stored in the node, instead of being made from a source: see setStoredBricks().
 *
 * In osgDB's native formats .osgt, .osgb and .osgx, the node is saved as its settings and its source, or its stored
 * bricks; the option "bake" stores bricks in the file instead of the source (see createBakedScene()). In LDraw's
 * formats .ldr and .mpd, its parts are saved, by the plugin osgdb_ldraw. In other formats, the bricks are saved as
 * osg::Geometry (see createBrickScene()), by a WriteFileCallback that the first LegoNode puts into osgDB's registry, in
 * front of any existing one. A program that later sets another callback calls the previous one in it, or
 * createBrickScene().
 *
 * Parts of the source that draw something other than triangles, or that act during culling, take effect only where the
 * source itself is drawn: lights and clip planes below the node, cameras that render to textures, and paged levels of
 * detail that are not loaded yet. State set above the node does not affect the colours of the bricks.
 *
 * A viewer that runs on demand (osgViewer::ViewerBase::ON_DEMAND) draws until the bricks of the current source and
 * settings are shown, and sleeps then, unless update callbacks in the source keep it awake. A program that changes the
 * source while it sleeps calls osgViewer::ViewerBase::requestRedraw(), as for any other node.
 *
 * Functions may be called from the thread that updates the scene; those with a context ID from any thread.
 */
class OSGLEGO_EXPORT LegoNode : public osg::Group
{
public:
    LegoNode();
    explicit LegoNode(const LegoSettings& settings);
    LegoNode(const LegoNode& node, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgLego, LegoNode)

    /** Change the settings, and read their palette: set them again after a change of its file. The next frame remakes
     * the bricks, unless LegoSettings::givesSameBricks() and the palette has the same colours.
     * @return false, with a warning and no change, if LegoSettings::check() or, unless the bricks are stored,
     * Palette::read() reports an error. */
    bool setSettings(const LegoSettings& settings);
    LegoSettings getSettings() const;

    /** Change the appearance of bricks in the full look. The bricks are not remade.
     * @return false, with a warning and no change, if BrickAppearance::check() reports an error. */
    bool setAppearance(const BrickAppearance& appearance);
    BrickAppearance getAppearance() const;

    /** Set the ambient light of the full look; null selects the built-in sky. Below an AmbientOcclusionScene, the probe
     * of that scene is used instead. The probe is copied: set it again after changing it. */
    void setLightProbe(const LightProbe* probe);
    osg::ref_ptr<const LightProbe> getLightProbe() const;

    /** Remake the bricks in the next frame, even if no change of the source is detected. Shaders that could not be
     * compiled are not tried again; see getFailure(). */
    void dirty();

    /** Whether there is anything to show in bricks: visible triangles in the source, or stored bricks. */
    bool hasTriangles() const;

    /** The reason, in one sentence, why a source with triangles has no bricks: cells of the size in the settings would
     * be too many, the palette can't be read, or the last getBricks() has failed. Empty if there is no such reason. */
    std::string getObstacle() const;

    /** Wait for each stage of a legolization to finish, so that getStatistics() has its time. Off by default. */
    void setTiming(bool timing);
    bool getTiming() const;

    /** Wait, in the cull traversal, for bricks made on the CPU, so that each frame shows the current source.
     * Off by default: the node keeps showing the previous bricks until the new ones are ready. Parts that take longer
     * than Effort::INSTANT are preceded by a draft, laid with that effort. Changed settings cancel work in progress. A
     * change of the source alone cancels work behind a draft and, though never twice in a row, other work, so that
     * bricks of a continually changing source are updated as fast as they or their drafts can be made. Frames always
     * wait for the first bricks, unless LegoSettings::View::meanwhile says otherwise. */
    void setWaiting(bool waiting);
    bool getWaiting() const;

    /** Limit the time that a frame waits for bricks or for the order of building. Unlimited by default. After that
     * time, the frame shows the previous bricks or, before the first ones, the source, while the bricks are still being
     * made; getProgress() tells how far they are. cancel() in another thread also ends the wait.
     * @param seconds 0 or more; infinity: no limit.
     * @return false, with a warning and no change, for other values. */
    bool setWaitingLimit(double seconds);
    double getWaitingLimit() const;

    /** The frames that check the source for changes. */
    enum class UpdateMode
    {
        ON_CHANGE,   //!< every frame that shows the node; bricks are remade if a change is detected
        EVERY_FRAME, //!< every frame, and bricks are remade as after dirty(), for changes that can't be detected
        FROZEN       //!< none; bricks are remade only after setSettings() or dirty()
    };
    /** Choose when the source is checked. With UpdateMode::EVERY_FRAME, a viewer that runs on demand never sleeps.
     * Called where the scene may change, like addChild(). */
    void setUpdateMode(UpdateMode mode);
    UpdateMode getUpdateMode() const { return _updateMode; }

    /** Called when bricks made on the CPU, or a draft of them, are ready to be shown from the next frame on.
     *
     * A worker thread calls ready(), or a thread that waits for the bricks, such as the one in osgViewer's frame().
     * ready() may only do what any thread may do, such as osgViewer::ViewerBase::requestRedraw(); it must not call the
     * node, throw, or take a lock that a caller of the node holds. */
    class OSGLEGO_EXPORT BricksCallback : public osg::Referenced
    {
    public:
        virtual void ready() = 0;

    protected:
        ~BricksCallback() override = default;
    };
    /** Set the callback; null removes it. */
    void setBricksCallback(BricksCallback* callback);
    osg::ref_ptr<BricksCallback> getBricksCallback() const { return _bricksCallback; }

    /** Read all covered cells back from the GPU after each legolization, for getBricks(contextID). Off by default. */
    void setReadBack(bool readBack);
    bool getReadBack() const;

    /** Show these bricks instead of those of the children; null: legolize the children again.
     *
     * Bricks that were read from a file or received over a network are shown in this way, and bricks whose source is no
     * longer needed:
     *
     *     lego->setStoredBricks(lego->getBricks());
     *     lego->removeChildren(0, lego->getNumChildren());
     *
     * Bricks stored in a node have every look, and are picked, bounded and exported like others. With Show::LOAD, parts
     * have their own colours until those for their load have been computed in the background; if setWaiting(), frames
     * wait for them instead. If there is not enough memory, a warning says so, and parts keep their colours. Changes of
     * the settings other than LegoSettings::view take effect only after setStoredBricks(nullptr).
     *
     * Children of the node, even if they are added later, are updated and receive events. They are drawn only in
     * contexts that can't draw bricks, and the option "bake" does not save them. Without children, such a context draws
     * the bricks as createBrickGeometry() makes them. Copies of the node share its bricks, even deep copies, since a
     * model is immutable. */
    void setStoredBricks(const BrickModel* bricks);
    osg::ref_ptr<const BrickModel> getStoredBricks() const;

    /** Show the parts that come first in the order of building; this is LegoSettings::View::progress. Parts appear and
     * disappear in the shaders, so that a change in every frame costs no more than a still model. A model without parts
     * grows brick by brick, from bottom to top.
     *
     * The number of parts in place is that of all parts times `progress`, rounded: k / n, in double precision, shows
     * exactly k of n parts. Other parts are neither drawn nor picked, but the bounds of the node and getBricks() are
     * those of all parts. An AmbientOcclusionScene draws an incomplete model without distant occlusion. Bricks that the
     * GPU made appear in the order of getBricks(), which then makes them on the CPU, too.
     *
     * The order is prepared in the background when it is first needed, and again after the bricks have changed. All
     * parts are shown until it is ready, or those of the bricks before; if setWaiting(), frames wait for it instead.
     * It takes 40 bytes for each cell that is visible at some time of building, in memory and in a buffer of each
     * context, which are kept until the bricks change.
     *
     * Drawing reads the value, not culling: if a separate thread draws, a change may show one frame early, and not in
     * all views of a frame. The same holds for setNumNewParts().
     * @param progress 0 (no part) to 1 (all parts).
     * @return false, with a warning and no change, for other values. */
    bool setBuildProgress(double progress);
    double getBuildProgress() const;

    /** Set the order of building; null: the order of planBuilding(), without checks of stability. A plan for another
     * number of parts than the bricks have is ignored. Files of OSG's formats store neither the plan nor
     * setNumNewParts(). */
    void setBuildingPlan(const BuildingPlan* plan);
    osg::ref_ptr<const BuildingPlan> getBuildingPlan() const;

    /** Highlight the parts that were put in place last: they are drawn in their full colour and with outlines, and
     * earlier parts are faded. BrickAppearance::outline is the width of lines.
     * @param count the number of these parts; 0: no highlight. */
    void setNumNewParts(std::size_t count);
    std::size_t getNumNewParts() const;

    /** Draw parts in another colour, for example those that were picked. Nothing is remade: the next frame uploads the
     * points of the bricks again.
     *
     * The highlight ends when other bricks are shown. Bricks that the GPU made are not highlighted, as they have no
     * parts.
     * @param parts indices in getShownBricks()->getParts() or, if no bricks are shown yet, in getBricks()->getParts(),
     * for which this call waits. Without parts, indices in getBricks() of that model. Empty: no highlight.
     * @param color red, green and blue (sRGB, 0 to 255).
     * @return false, with a warning and no change, for an index that the bricks don't have, and without bricks. */
    bool setHighlightedParts(std::span<const std::size_t> parts, const std::array<std::uint8_t, 3>& color);

    /** The bricks: those stored, or else those of the source, made on the CPU by the first call and kept until the
     * source changes; null without triangles.
     *
     * The cells of a source are those of VoxelizationMethod::EXACT, regardless of the settings. Needs no GL context. */
    osg::ref_ptr<const BrickModel> getBricks() const;

    /** The transform from the coordinates of getBricks() to those of the node: the identity, except with Anchor::WORLD,
     * whose bricks have the coordinates of the world. */
    osg::Matrixd getBricksToNode() const;

    /** The bricks that frames show at present: those stored, or the last ones made on the CPU, which may be a draft
     * (see setWaiting()). Returns at once; null if
     * there are none, and for bricks made on the GPU, which getBricks(contextID) reads back. May be called from any
     * thread. */
    osg::ref_ptr<const BrickModel> getShownBricks() const;

    /** The progress of bricks that are being made on the CPU, for getBricks() or a frame. May be called from any
     * thread.
     */
    LegoProgress getProgress() const;

    /** Cancel the making of bricks on the CPU, and return at once: a getBricks() that waits for them soon returns null.
     * The next frame or getBricks() begins again. May be called from any thread. */
    void cancel();

    /** Every covered cell, as made for a context; null until its bricks are made, and while setReadBack() is off. */
    osg::ref_ptr<const BrickModel> getBricks(unsigned int contextID) const;

    /** Statistics of the last legolization in a context. May wait for one in progress, as may getFailure(). */
    LegoStatistics getStatistics(unsigned int contextID) const;

    /** Whether a context has the bricks of the current source and settings: false from setSettings() or dirty() on,
     * until a frame shows the new bricks, and for a draft of them. A change that the node has to detect counts from the
     * next update on. Remains false if the bricks can't be made; see getFailure(). */
    bool isLegolized(unsigned int contextID) const;

    /** Whether the current context, that of `state`, can make and draw bricks; see precondition 1. */
    static bool isSupported(const osg::State& state);
    /** The first thing that a context, which is current, lacks to make bricks, in one sentence; empty when
     * isSupported(). */
    static std::string getMissing(const osg::State& state);

    /** The reason, in one sentence, why a context draws the source instead of bricks; empty if it draws bricks. Bricks
     * that have failed are tried again when they are remade. If shaders could not be compiled or linked, the context
     * tries again after setSettings(), with any settings, or setStoredBricks(). */
    std::string getFailure(unsigned int contextID) const;

    void traverse(osg::NodeVisitor& visitor) override;
    osg::BoundingSphere computeBound() const override;
    void setThreadSafeRefUnref(bool threadSafe) override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~LegoNode() override;

private:
    friend class LegoNodeSerializer; // in the plugin osgdb_serializers_osglego

    /** Change the settings.
     * @param requiresPalette false for the settings of a file: stored bricks don't need the palette, other bricks have
     * getObstacle(), and the settings are kept for when the file is written again.
     * @return false, with a warning and no change, if LegoSettings::check() reports an error, or if the palette is
     * required and can't be read. */
    bool changeSettings(const LegoSettings& settings, bool requiresPalette);

    void requireUpdate();
    void setRequiresUpdate(bool requiresUpdate);
    bool mustRefresh() const;
    void refresh() const;
    void refreshBetweenFrames() const;
    void update(osg::NodeVisitor& visitor);
    void cull(osg::NodeVisitor& visitor);
    bool cullBricks(osgUtil::CullVisitor& visitor);
    void visitAtBricks(osg::Node& node, osg::NodeVisitor& visitor);
    void visitSource(osg::NodeVisitor& visitor);
    void visitBricks(osg::NodeVisitor& visitor);

    osg::ref_ptr<LegoPipeline> _pipeline;
    osg::ref_ptr<BricksCallback> _bricksCallback;
    osg::ref_ptr<osg::MatrixTransform> _lattice; // above the bricks in a lattice of the world, for visitors
    UpdateMode _updateMode = UpdateMode::ON_CHANGE;
    bool _requiresUpdate = false;
    mutable osg::BoundingSphere _sourceBound; // when the source was last checked
};

} // namespace osgLego
