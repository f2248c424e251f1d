#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/PartHighlight.h>
#include <osgLego/node/BrickDisplay.h>
#include <osgLego/node/BrickQuery.h>
#include <osgLego/node/BrickSource.h>
#include <osgLego/node/BuildingProducer.h>
#include <osgLego/producer/CpuProducer.h>
#include <osgLego/producer/GpuProducer.h>
#include <osgLego/store/BrickStore.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include <osg/BoundingBox>
#include <osg/FrameStamp>
#include <osg/Node>
#include <osg/NodeVisitor>
#include <osg/Referenced>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The implementation of LegoNode: has a producer make the bricks of its BrickSource when they have changed, and shows
 * those delivered.
 *
 * Every function may be called from any thread as long as no other thread changes the source.
 */
class LegoPipeline : public osg::Referenced
{
public:
    LegoPipeline(const LegoSettings& settings, const SettingsPalette& palette);

    void setSettings(const LegoSettings& settings, const SettingsPalette& palette);
    LegoSettings getSettings() const;
    SettingsPalette getPalette() const { return _source.getPalette(); }
    /** Change LegoSettings::View::progress alone. */
    void setProgress(double progress);
    void setNumNewParts(std::size_t count);
    std::size_t getNumNewParts() const { return _store->getState().numNew; }
    /** Show parts of the bricks in another colour, until the bricks are replaced. No parts: no highlight.
     * @return one sentence if there are no such parts; otherwise empty. */
    std::string setHighlightedParts(std::span<const std::size_t> parts, const PartHighlight::Color& color);
    /** The order of building, and the sets for drawing the bricks partly built. */
    BuildingProducer& getBuilding() { return *_building; }
    void setTiming(bool timing) { _source.setTiming(timing); }
    bool getTiming() const { return _source.getTiming(); }
    void setReadBack(bool readBack) { _source.setReadBack(readBack); }
    bool getReadBack() const { return _source.getReadBack(); }
    /** Whether frames wait for bricks made on the CPU. */
    void setWaiting(bool waiting) { _waiting = waiting; }
    bool getWaiting() const { return _waiting; }
    /** The longest time in seconds that a frame waits for them. */
    void setWaitingLimit(double seconds) { _waitingLimit = seconds; }
    double getWaitingLimit() const { return _waitingLimit; }
    /** Set the function to call when a set has been made on the CPU; it is called in the thread that made the set. */
    void setAnnouncement(std::function<void()> announcement);

    /** Show bricks instead of those of the source; null: legolize the source again. Called in the update traversal. */
    void setStoredBricks(const BrickModel* bricks);
    osg::ref_ptr<const BrickModel> getStoredBricks() const { return _source.getStored(); }

    BrickDisplay& getDisplay() { return _display; }
    const BrickDisplay& getDisplay() const { return _display; }
    const BrickStore& getStore() const { return *_store; }

    /** Flatten the source at the next check, even if its signature has not changed. */
    void dirty() { _source.dirty(); }
    bool isDirty() const { return _source.isDirty(); }

    /** Check the source, and flatten it if it has changed since the last check. Does nothing if there are stored
     * bricks.
     */
    void refresh(const osg::Node& source);
    /** The same, but only after dirty(). */
    void refreshIfDirty(const osg::Node& source)
    {
        if (isDirty()) refresh(source);
    }
    /** The same, but later if the bricks of the last check have to be made first. */
    void refreshInTime(const osg::Node& source);
    /** The same, but only if it has not been checked in the frame of a visitor. */
    void refreshInFrame(const osg::Node& source, const osg::NodeVisitor& visitor);
    /** Show the bricks that the producers have finished. Called in updates, after refresh().
     * @return whether the bounds of the bricks have changed since the last update. */
    bool update(const osg::NodeVisitor& visitor);
    /** Whether another update is needed even if nothing else changes: to show bricks that are being made, or to release
     * their passes. */
    bool isBusy();

    /** Queue the bricks for drawing, after having them made if the visitor's context lacks them.
     * @return false if the context can't show bricks, or there are none; the caller then draws the source. */
    bool cull(osgUtil::CullVisitor& visitor);

    /** Whether a context, which must be current, meets the requirements of bricks. */
    bool isFit(const osg::State& state) const;

    /** The revision of the bricks to show: those stored, or else those of the source; 0 if there are none. */
    std::uint64_t getRevision() const { return _source.getRevision(); }
    /** The source of the last check; null if it has no visible triangles, or if there is an obstacle or stored bricks.
     */
    osg::ref_ptr<const LegoSource> getSource() const { return _source.getSource(); }
    /** The reason why a source with triangles can't be legolized; empty if there is none. */
    std::string getObstacle() const;
    /** The bricks that frames show, without those of the GPU; null if there are none. */
    osg::ref_ptr<const BrickModel> getShownModel() const;
    /** The stored bricks, or else those of the source, made now if necessary; null if there are neither. */
    osg::ref_ptr<const BrickModel> getModel();
    /** The progress of bricks that are being made on the CPU. */
    LegoProgress getProgress() const { return _cpuProducer->getProgress(); }
    /** Cancel the making of bricks on the CPU, without waiting for it to end. */
    void cancel() { _cpuProducer->cancel(); }
    /** The transform from the coordinates of the bricks to those of the node. */
    osg::Matrixd getToNode() const { return _source.getToNode(); }
    /** The bounds of the bricks, including those still being made, in the node's coordinates. */
    osg::BoundingBoxd getBounds() const;

    /** The picture before the first bricks; nothing once there are bricks, and if frames wait for them. */
    std::optional<Meanwhile> getMeanwhile() const;
    /** Ensure that there is a brick set for picking, even before any context has drawn one. */
    void prepareForPicking();
    /** The bricks of getModel() as osg::Geometry, created by the first call; null if there are none. */
    osg::ref_ptr<osg::Node> getGeometryNode();

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

private:
    ~LegoPipeline() override = default;

    BrickProducer& chooseProducer(const LegoSettings& settings, unsigned int contextID) const;
    bool mustDrawSource(const osg::State& state, ContextBricks& bricks, std::uint64_t revision) const;
    bool produce(const LegoSource& source, const ContextBricks& bricks, osgUtil::CullVisitor& visitor);
    FrameNeeds findNeeds(Meanwhile meanwhile, const ContextBricks& bricks, osgUtil::CullVisitor& visitor) const;
    bool hasBricks(const ContextBricks& bricks) const;
    void showStored(const BrickModel& bricks);
    void prepareBuilding(const LegoSource* source);

    /** The frame of a viewer. */
    struct Frame
    {
        Frame() = default;
        explicit Frame(const osg::NodeVisitor& visitor);
        bool operator==(const Frame&) const = default;

        const osg::FrameStamp* viewer = nullptr; // only compared
        unsigned int number = 0;
    };

    void look(const osg::Node& source);
    void lookInTime(const osg::Node& source);

    BrickSource _source;
    std::atomic<bool> _waiting{false};
    std::atomic<double> _waitingLimit{BackgroundTask::FOREVER};

    // Held while the source is checked, and while the state of the store or the members below change.
    std::mutex _mutex;
    osg::BoundingBoxd _lastBounds;
    Frame _lastFrame; // in which the source was checked

    osg::ref_ptr<BrickStore> _store;
    BrickDisplay _display;

    /** The function to call, kept apart because producers may call it after the pipeline has been destroyed. */
    struct Announcement
    {
        void operator()();

        std::mutex mutex;
        std::function<void()> call;
    };
    std::shared_ptr<Announcement> _announcement = std::make_shared<Announcement>();
    osg::ref_ptr<CpuProducer> _cpuProducer;
    osg::ref_ptr<GpuProducer> _gpuProducer;
    std::unique_ptr<BuildingProducer> _building;
    BrickQuery _query;
};

} // namespace osgLego
