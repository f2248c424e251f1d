#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/flattening/SourceSignature.h>
#include <osgLego/flattening/SurfaceTextureCache.h>
#include <osgLego/gl/PerVisit.h>
#include <osgLego/passes/BrickStore.h>
#include <osgLego/polygonization/BrickNodes.h>
#include <osgLego/producer/LegolizationPasses.h>

#include <atomic>
#include <mutex>
#include <vector>

#include <osg/Geode>
#include <osg/Group>
#include <osg/NodeVisitor>
#include <osg/Referenced>
#include <osg/observer_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** What is behind a LegoNode: watches its source, has the passes run when they must, and shows the bricks.
 *
 * Every function may be called from any thread, as long as no other thread changes the source meanwhile.
 */
class LegoPipeline : public osg::Referenced
{
public:
    explicit LegoPipeline(const LegoSettings& settings);

    void setSettings(const LegoSettings& settings);
    LegoSettings getSettings() const;
    void setAppearance(const BrickAppearance& appearance);
    BrickAppearance getAppearance() const;
    void setLightProbe(const LightProbe& probe);
    osg::ref_ptr<const LightProbe> getLightProbe() const;
    void setTiming(bool timing);
    bool getTiming() const;
    void setReadBack(bool readBack);
    bool getReadBack() const;

    /** Flatten the source at the next chance, whatever its signature says. */
    void dirty() { _isDirty = true; }

    /** Look at the source, and flatten it if it is another than before. */
    void refresh(const osg::Node& source);
    /** The same, but look only when dirty() was said. */
    void refreshIfDirty(const osg::Node& source)
    {
        if (_isDirty) refresh(source);
    }
    /** Whether the bounds may have changed since this was asked last. */
    bool takeBoundDirty() { return _isBoundDirty.exchange(false); }

    /** Let go of the passes when they have had nothing to do for a while. Called in every update. */
    void releaseIdlePasses(unsigned int frame);

    /** Draw the bricks, and have them made first if the visitor's context lacks them.
     * @return false when the context can't have them, or there are none: then the source is to be drawn. */
    bool cull(osgUtil::CullVisitor& visitor);

    /** Find out whether a context, which is current, has what the passes need. */
    bool isFit(const osg::State& state) const;

    /** The node that stands for the bricks: drawn, picked, bounded. */
    osg::ref_ptr<osg::Geode> getBrickNode() const { return &getNodes()->getFrameNode(); }
    /** The bricks as osg::Geometry, made when first asked for; null when there are none. */
    osg::ref_ptr<osg::Node> getGeometryNode();

    const BrickStore& getStore() const { return *_store; }
    osg::BoundingBoxd getBounds() const;

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

private:
    /** When a visitor queued the passes last. */
    struct LastCull
    {
        osg::observer_ptr<osgUtil::CullVisitor> visitor; // to tell it from a later one at the same address
        std::uint64_t revision = 0;
        unsigned int frame = 0;
    };

    ~LegoPipeline() override = default;

    osg::ref_ptr<const BrickNodes> getNodes() const;

    bool isFirstCullOfFrame(osgUtil::CullVisitor& visitor, const LegoSource& source);

    bool isHopeless(const osg::State& state, ContextBricks& bricks, const LegoSource& source) const;
    osg::ref_ptr<osg::StateSet> getViewState(osgUtil::CullVisitor& visitor);
    void cullBricks(osgUtil::CullVisitor& visitor, const LegoSource& source);
    void cullPasses(osgUtil::CullVisitor& visitor, const LegoSource& source);

    mutable std::mutex _mutex;
    LegoSettings _settings;
    bool _timing = false;
    bool _readBack = false;
    std::atomic<bool> _isDirty{true};
    std::atomic<bool> _isBoundDirty{false};
    SourceSignature _signature;
    SourceSignatures _signatures;
    SurfaceTextureCache _textures;

    osg::ref_ptr<BrickStore> _store;
    BrickAppearance _appearance;
    osg::ref_ptr<const LightProbe> _lightProbe;
    PerVisit<osg::ref_ptr<osg::StateSet>> _viewStates;
    mutable osg::ref_ptr<const BrickNodes> _nodes; // made when first asked for
    osg::ref_ptr<LegolizationPasses> _passes;
    unsigned int _idleFrames = 0;
    unsigned int _lastUpdate = 0;
    std::vector<LastCull> _lastCulls;

    osg::ref_ptr<osg::Geode> _geometryNode;
    osg::ref_ptr<const BrickModel> _geometryModel;
};

} // namespace osgLego
