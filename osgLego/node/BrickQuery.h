#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/producer/CpuProducer.h>
#include <osgLego/store/BrickStore.h>

#include <cstdint>
#include <mutex>
#include <string>

#include <osg/Geode>
#include <osg/ref_ptr>

namespace osgLego
{

/** Bricks for picking and export, which are made now if no frame has shown them yet.
 *
 * Every function may be called from any thread.
 */
class BrickQuery
{
public:
    BrickQuery(BrickStore& store, CpuProducer& producer) : _store(&store), _producer(&producer) {}

    /** The bricks of a source. @return null, with the reason in getFailure(), if they can't be made. */
    osg::ref_ptr<const BrickModel> getModel(const LegoSource& source);
    /** Ensure that there is a brick set for picking, even before any context has drawn one. Its bricks are made when
     * they are needed. */
    void prepareForPicking(const LegoSource& source);
    /** The reason why the bricks of the source of this revision could not be made; empty if there is none. */
    std::string getFailure(std::uint64_t revision) const;

    /** A model as osg::Geometry, created by the first call for it. */
    osg::ref_ptr<osg::Geode> getGeometryNode(const BrickModel& model);

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

private:
    osg::ref_ptr<const BrickSet> makeOnCpu(const LegoSource& source);
    osg::ref_ptr<const BrickSet> createLazySet(const LegoSource& source) const;

    osg::ref_ptr<BrickStore> _store;
    osg::ref_ptr<CpuProducer> _producer;

    mutable std::mutex _mutex;
    std::uint64_t _failedRevision = 0;
    std::string _failure;
    osg::ref_ptr<const BrickModel> _model;
    osg::ref_ptr<osg::Geode> _geometryNode; // of the model
};

} // namespace osgLego
