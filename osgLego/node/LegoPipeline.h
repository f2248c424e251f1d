#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/node/BrickDisplay.h>
#include <osgLego/node/SourceWatch.h>
#include <osgLego/producer/CpuProducer.h>
#include <osgLego/producer/GpuProducer.h>
#include <osgLego/store/BrickStore.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include <osg/BoundingBox>
#include <osg/Geode>
#include <osg/Node>
#include <osg/Referenced>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** All that is behind a LegoNode: looks at its source, has a producer make bricks when that has changed, and shows what
 * the producers have delivered.
 *
 * Every function may be called from any thread, as long as no other thread changes the source meanwhile.
 */
class LegoPipeline : public osg::Referenced
{
public:
    explicit LegoPipeline(const LegoSettings& settings);

    void setSettings(const LegoSettings& settings);
    LegoSettings getSettings() const;
    void setTiming(bool timing);
    bool getTiming() const;
    void setReadBack(bool readBack);
    bool getReadBack() const;
    /** Whether frames wait for bricks that are made on the CPU. */
    void setWaiting(bool waiting) { _waiting = waiting; }
    bool getWaiting() const { return _waiting; }
    /** Called after each set that was made on the CPU, by the thread that finished it. */
    void setAnnouncement(std::function<void()> announcement);

    BrickDisplay& getDisplay() { return _display; }
    const BrickDisplay& getDisplay() const { return _display; }
    const BrickStore& getStore() const { return *_store; }

    /** Flatten the source at the next look, whatever its signature says. */
    void dirty() { _isDirty = true; }
    bool isDirty() const { return _isDirty; }

    /** Look at the source, and flatten it if it is not the one of the last look. */
    void refresh(const osg::Node& source);
    /** The same, but look only when dirty() was said. */
    void refreshIfDirty(const osg::Node& source)
    {
        if (_isDirty) refresh(source);
    }
    /** Take over what the producers have finished. Called in every update, behind refresh().
     * @return whether the bounds of the bricks are not those of the last update. */
    bool update(unsigned int frame);

    /** Draw the bricks, and have them made first if the visitor's context lacks them.
     * @return false when the context can't have them, or there are none: then the source is to be drawn. */
    bool cull(osgUtil::CullVisitor& visitor);

    /** Find out whether a context, which is current, has what bricks need. */
    bool isFit(const osg::State& state) const;

    /** The source of the last look; null when it shows no triangles. */
    osg::ref_ptr<const LegoSource> getSource() const;
    /** The model of that source, made now if it is not there yet; null without source. */
    osg::ref_ptr<const BrickModel> getModel();
    /** Where bricks are, or will be as soon as they are made. */
    osg::BoundingBoxd getBounds() const { return _store->getBounds(); }

    /** See to it that there is a brick set to be picked, which may be made before any context has drawn one. */
    void prepareForPicking();
    /** The bricks of the source as osg::Geometry, made when first asked for; null when there are none. */
    osg::ref_ptr<osg::Node> getGeometryNode();

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

private:
    ~LegoPipeline() override = default;

    BrickProducer& chooseProducer(const LegoSettings& settings, unsigned int contextID) const;
    bool isHopeless(const osg::State& state, ContextBricks& bricks, const LegoSource& source) const;
    bool mustWait(const ContextBricks& bricks) const;

    mutable std::mutex _mutex; // of the wishes, the watch and the geometry
    SourceWatch::Wishes _wishes;
    SourceWatch _watch;
    std::atomic<bool> _isDirty{true};
    std::atomic<bool> _waiting{false};

    osg::ref_ptr<BrickStore> _store;
    BrickDisplay _display;
    osg::BoundingBoxd _lastBounds;
    osg::ref_ptr<osg::Geode> _geometryNode;
    osg::ref_ptr<const BrickModel> _geometryModel;

    /** What producers may call after the pipeline has gone. */
    struct Announcement
    {
        void operator()();

        std::mutex mutex;
        std::function<void()> call;
    };
    std::shared_ptr<Announcement> _announcement = std::make_shared<Announcement>();
    osg::ref_ptr<CpuProducer> _cpuProducer;
    osg::ref_ptr<GpuProducer> _gpuProducer;
};

} // namespace osgLego
