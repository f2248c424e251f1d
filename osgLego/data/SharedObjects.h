#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgLego
{

/** Finds objects that several nodes share, by equal keys. Nodes own them: an object is deleted with the last reference.
 *
 * Usage:
 *
 *     static SharedObjects<std::string, osg::Image> images;
 *     osg::ref_ptr<osg::Image> image = images.findOrCreate(name, [&] { return createImage(name); });
 *
 * A key that refers to an object holds an osg::observer_ptr: this differs from that of a later object at the same
 * address.
 *
 * May be called from any thread. No lock is held while an object is created, so that other threads don't wait for it.
 */
template <typename Key, typename Object>
class SharedObjects
{
public:
    /** @param create returns a new object; called if no object with this key is in use. */
    template <typename Create>
    osg::ref_ptr<Object> findOrCreate(const Key& key, const Create& create)
    {
        if (osg::ref_ptr<Object> found = find(key)) return found;
        const osg::ref_ptr<Object> created = create();
        const std::lock_guard lock(_mutex);
        // Another thread may have created one, too.
        if (osg::ref_ptr<Object> found = findLocked(key)) return found;
        if (created) _entries.emplace_back(key, created);
        return created;
    }

    /** The object with a key; null if none is in use. */
    osg::ref_ptr<Object> find(const Key& key)
    {
        const std::lock_guard lock(_mutex);
        return findLocked(key);
    }

    /** Don't share the object with a key any longer. */
    void forget(const Key& key)
    {
        const std::lock_guard lock(_mutex);
        std::erase_if(_entries, [&key](const Entry& entry) { return entry.first == key; });
    }

private:
    using Entry = std::pair<Key, osg::observer_ptr<Object>>;

    osg::ref_ptr<Object> findLocked(const Key& key)
    {
        std::erase_if(_entries, [](const Entry& entry) { return !entry.second.valid(); });
        osg::ref_ptr<Object> found;
        for (const Entry& entry : _entries)
            if (entry.first == key && entry.second.lock(found)) return found;
        return nullptr;
    }

    std::mutex _mutex;
    std::vector<Entry> _entries;
};

} // namespace osgLego
