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

/** Something of its own for every visit that cull visitors pay a node in a frame: by visitor, by camera, and, of a node
 * with several parents, by visit.
 *
 * What is found may be changed until the next frame of the visitor, which is not culled before its last one is drawn.
 * Not locked: hold a mutex.
 */
template <typename Item>
class PerVisit
{
public:
    struct Entry
    {
        osg::observer_ptr<osgUtil::CullVisitor> visitor; // to tell it from a later one at the same address
        osg::observer_ptr<osg::Camera> camera;
        unsigned int contextID = 0;
        unsigned int frame = 0; //!< in which it was found last
        osg::NodePath path;     //!< by which the visitor came
        std::unique_ptr<Item> item;
    };

    /** What is there for the visit that a visitor pays just now; new at its first. */
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
    // What was not used for so many frames goes, as of a camera that is switched off.
    static constexpr unsigned int IDLE_FRAMES = 60;

    std::vector<Entry> _entries;
};

/** The turn from a visitor's eye coordinates to the world's, at the node it is visiting: what osg_ViewMatrixInverse
 * says, but right for cameras that render to textures, too. */
inline osg::Matrixd computeEyeToWorld(osgUtil::CullVisitor& visitor)
{
    // As osg::computeLocalToWorld() does, which copies the path: from the last camera that stands for itself on.
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
