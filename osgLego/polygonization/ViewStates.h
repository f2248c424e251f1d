#pragma once

#include <mutex>
#include <vector>

#include <osg/Camera>
#include <osg/StateSet>
#include <osg/Uniform>
#include <osg/observer_ptr>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** The states that are specific to views: the orientation of light probes in eye coordinates. Nodes in the same view
 * share a state, so that OSG draws them one after the other without changing it.
 *
 * Every function may be called from any thread.
 */
class ViewStates
{
public:
    /** The states of all views in this process. */
    static ViewStates& get();

    /** The state for the current visit of a node. It is not changed before the visitor's next frame, which is not
     * culled before the previous one has been drawn. */
    osg::ref_ptr<osg::StateSet> find(osgUtil::CullVisitor& visitor);

private:
    struct Entry
    {
        osg::observer_ptr<osgUtil::CullVisitor> visitor; // detects a later visitor at the same address
        osg::observer_ptr<osg::Camera> camera;
        unsigned int frame = 0; // the last frame that used the state
        osg::Matrix3 eyeToWorld;
        osg::ref_ptr<osg::StateSet> state;
    };

    Entry& findFree(osgUtil::CullVisitor& visitor, osg::Camera& camera);

    std::mutex _mutex;
    std::vector<Entry> _entries;
};

} // namespace osgLego
