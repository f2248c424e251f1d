#pragma once

#include <mutex>
#include <set>
#include <utility>

#include <osg/State>

namespace osgLego
{

/** GL objects that nodes share; see SharedBetweenViewers. */
class SharedGlObject
{
public:
    /** Release the GL objects of the context of a state, or of all contexts. */
    virtual void release(osg::State* state) const = 0;

protected:
    ~SharedGlObject() = default;
};

/** Releases the shared GL objects of a context together with their last user there.
 *
 * If each node released them, removing a node from a scene would release those of the nodes that remain, possibly while
 * another thread draws them.
 *
 * Functions may be called from any thread.
 */
class SharedGlObjects
{
public:
    static SharedGlObjects& get();

    /** Called in the cull traversal, before `user` draws with shared objects in a context. */
    void addUser(unsigned int contextID, const void* user);
    /** Called when `user` will draw in no context any longer. Releases nothing. */
    void removeUser(const void* user);
    /** Called when `user` releases its GL objects. @param state of the context; null for all contexts. */
    void release(osg::State* state, const void* user);

    void add(const SharedGlObject& object);
    /** Called in the destructor of the most derived class. */
    void remove(const SharedGlObject& object);

private:
    using User = std::pair<unsigned int, const void*>; // with its context

    std::mutex _mutex;
    std::set<User> _users;
    std::set<const SharedGlObject*> _objects;
};

} // namespace osgLego
