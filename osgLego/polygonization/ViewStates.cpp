#include <osgLego/polygonization/ViewStates.h>

#include <osgLego/gl/PerVisit.h>
#include <osgLego/gl/ProgramUniforms.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace osgLego
{

namespace
{

// States unused for this many frames are dropped, such as those of a camera that is switched off.
constexpr unsigned int IDLE_FRAMES = 60;
// The number of states of a view from which on the oldest is used again, even in a frame with the same number.
constexpr std::ptrdiff_t MOST_STATES = 256;

/** Whether two orientations differ only by rounding, which depends on the transforms above a node. */
bool areAlike(const osg::Matrix3& a, const osg::Matrix3& b)
{
    constexpr float ROUNDING = 1e-6f;
    return std::equal(a.ptr(), a.ptr() + 9, b.ptr(), [](float x, float y) { return std::abs(x - y) <= ROUNDING; });
}

} // namespace

ViewStates& ViewStates::get()
{
    static ViewStates states;
    return states;
}

osg::ref_ptr<osg::StateSet> ViewStates::find(osgUtil::CullVisitor& visitor)
{
    const unsigned int frame = visitor.getTraversalNumber();
    osg::Camera* camera = visitor.getCurrentCamera();
    const osg::Matrix3 eyeToWorld = toUniform(computeEyeToWorld(visitor));
    const std::lock_guard lock(_mutex);
    for (Entry& entry : _entries)
    {
        if (entry.visitor != &visitor || entry.camera != camera || !areAlike(entry.eyeToWorld, eyeToWorld)) continue;
        entry.frame = frame;
        return entry.state;
    }
    Entry& entry = findFree(visitor, *camera);
    entry.frame = frame;
    entry.eyeToWorld = eyeToWorld;
    entry.state->getOrCreateUniform("eyeToWorld", osg::Uniform::FLOAT_MAT3)->set(eyeToWorld);
    return entry.state;
}

/** Find a state that the current frame does not use. */
ViewStates::Entry& ViewStates::findFree(osgUtil::CullVisitor& visitor, osg::Camera& camera)
{
    const unsigned int frame = visitor.getTraversalNumber();
    const auto isOfView = [&](const Entry& entry) { return entry.visitor == &visitor && entry.camera == &camera; };
    std::erase_if(_entries,
                  [&](const Entry& entry)
                  {
                      const bool isIdle = entry.visitor == &visitor && frame - entry.frame > IDLE_FRAMES;
                      return !entry.visitor.valid() || !entry.camera.valid() || isIdle;
                  });
    auto found = std::find_if(_entries.begin(), _entries.end(),
                              [&](const Entry& entry) { return isOfView(entry) && entry.frame != frame; });
    if (found == _entries.end() && std::count_if(_entries.begin(), _entries.end(), isOfView) >= MOST_STATES)
        found = std::find_if(_entries.begin(), _entries.end(), isOfView);
    if (found != _entries.end())
    {
        // The last entry of the view in the order of their use.
        std::rotate(found, found + 1, _entries.end());
        return _entries.back();
    }
    _entries.push_back({&visitor, &camera, frame, {}, new osg::StateSet});
    return _entries.back();
}

} // namespace osgLego
