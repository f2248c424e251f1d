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

/** Releases the shared GL objects of a context together with their last user there, or when the context closes.
 *
 * If each node released them, removing a node from a scene would release those of the nodes that remain, possibly while
 * another thread draws them. A context may close after all its users have been deleted, and another one gets its ID.
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

    /** Release the GL objects of a context when it closes. Called before they are created, in the context's thread. */
    static void releaseAtClose(unsigned int contextID);
    /** Release the GL objects of a context, regardless of users. */
    void releaseAll(unsigned int contextID);

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
