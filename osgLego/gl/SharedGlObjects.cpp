#include <osgLego/gl/SharedGlObjects.h>

#include <algorithm>

#include <osg/ContextData>
#include <osg/GLObjects>
#include <osg/ref_ptr>

namespace osgLego
{

namespace
{

/** OSG tells it that a context closes. */
class ContextEnd : public osg::GraphicsObjectManager
{
public:
    explicit ContextEnd(unsigned int contextID) : osg::GraphicsObjectManager("osgLego::ContextEnd", contextID) {}

    void flushDeletedGLObjects(double, double&) override {}
    void flushAllDeletedGLObjects() override {}
    void deleteAllGLObjects() override { SharedGlObjects::get().releaseAll(_contextID); }
    void discardAllGLObjects() override { SharedGlObjects::get().releaseAll(_contextID); }

private:
    ~ContextEnd() override = default;
};

} // namespace

SharedGlObjects& SharedGlObjects::get()
{
    // Never destroyed, since objects with static storage may have users.
    static auto* const objects = new SharedGlObjects;
    return *objects;
}

void SharedGlObjects::addUser(unsigned int contextID, const void* user)
{
    const std::lock_guard lock(_mutex);
    _users.insert({contextID, user});
}

void SharedGlObjects::removeUser(const void* user)
{
    const std::lock_guard lock(_mutex);
    std::erase_if(_users, [user](const User& other) { return other.second == user; });
}

void SharedGlObjects::release(osg::State* state, const void* user)
{
    const auto isThere = [state](const User& other) { return !state || other.first == state->getContextID(); };
    const std::lock_guard lock(_mutex);
    std::erase_if(_users, [&](const User& other) { return other.second == user && isThere(other); });
    if (std::any_of(_users.begin(), _users.end(), isThere)) return;
    for (const SharedGlObject* object : _objects)
        object->release(state);
}

void SharedGlObjects::releaseAtClose(unsigned int contextID)
{
    osg::get<ContextEnd>(contextID);
}

void SharedGlObjects::releaseAll(unsigned int contextID)
{
    const osg::ref_ptr<osg::State> state = new osg::State; // which releaseGLObjects() asks only for the ID
    state->setContextID(contextID);
    const std::lock_guard lock(_mutex);
    std::erase_if(_users, [contextID](const User& user) { return user.first == contextID; });
    for (const SharedGlObject* object : _objects)
        object->release(state);
}

void SharedGlObjects::add(const SharedGlObject& object)
{
    const std::lock_guard lock(_mutex);
    _objects.insert(&object);
}

void SharedGlObjects::remove(const SharedGlObject& object)
{
    const std::lock_guard lock(_mutex);
    _objects.erase(&object);
}

} // namespace osgLego
