#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <osg/Camera>
#include <osg/State>
#include <osg/observer_ptr>
#include <osgUtil/CullVisitor>

namespace osgLego
{

/** Holds a separate item for each time that a cull visitor visits a node in a frame: per visitor, per camera, and, for
 * a node with several parents, per node path.
 *
 * An item may be changed until the visitor's next frame, which is not culled before the previous one has been drawn.
 * Not locked: the caller holds a mutex.
 */
template <typename Item>
class PerVisit
{
public:
    struct Entry
    {
        osg::observer_ptr<osgUtil::CullVisitor> visitor; // detects a later visitor at the same address
        osg::observer_ptr<osg::Camera> camera;
        unsigned int contextID = 0;
        unsigned int frame = 0; //!< the last frame that used the item
        osg::NodePath path;     //!< the path by which the visitor reached the node
        std::unique_ptr<Item> item;
    };

    /** The item of the visitor's current visit; created by the first one. */
    Item& find(osgUtil::CullVisitor& visitor)
    {
        const unsigned int frame = visitor.getTraversalNumber();
        osg::Camera* camera = visitor.getCurrentCamera();
        const osg::NodePath& path = visitor.getNodePath();
        std::erase_if(_entries,
                      [&](const Entry& entry)
                      {
                          const bool isIdle = entry.visitor == &visitor && frame - entry.frame > IDLE_FRAMES;
                          return !entry.visitor.valid() || !entry.camera.valid() || isIdle;
                      });
        auto place = std::find_if(_entries.begin(), _entries.end(),
                                  [&](const Entry& entry) {
                                      return entry.visitor == &visitor && entry.camera == camera && entry.path == path;
                                  });
        if (place == _entries.end())
        {
            const unsigned int contextID = visitor.getState()->getContextID();
            _entries.push_back(Entry{&visitor, camera, contextID, frame, path, std::make_unique<Item>()});
            return *_entries.back().item;
        }
        place->frame = frame;
        return *place->item;
    }

    const std::vector<Entry>& getEntries() const { return _entries; }
    void clear() { _entries.clear(); }

private:
    // Items unused for this many frames are dropped, such as those of a camera that is switched off.
    static constexpr unsigned int IDLE_FRAMES = 60;

    std::vector<Entry> _entries;
};

/** The transform from a visitor's eye coordinates to world coordinates, at the node it is visiting: like
 * osg_ViewMatrixInverse, but also correct for cameras that render to textures. */
inline osg::Matrixd computeEyeToWorld(osgUtil::CullVisitor& visitor)
{
    // Like osg::computeLocalToWorld(), but without copying the path: starts at the last camera that is not relative to
    // its parents.
    const osg::NodePath& path = visitor.getNodePath();
    const auto isOutermost = [](osg::Node* node)
    {
        const osg::Camera* camera = node->asCamera();
        return camera && (camera->getReferenceFrame() == osg::Transform::ABSOLUTE_RF || camera->getNumParents() == 0);
    };
    osg::Matrixd toWorld;
    for (auto node = std::find_if(path.rbegin(), path.rend(), isOutermost).base(); node != path.end(); ++node)
        if (osg::Transform* transform = (*node)->asTransform()) transform->computeLocalToWorldMatrix(toWorld, &visitor);
    return osg::Matrixd::inverse(*visitor.getModelViewMatrix()) * toWorld;
}

} // namespace osgLego
