#include <osgLego/gl/SharedGlObjects.h>

#include <algorithm>

namespace osgLego
{

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
