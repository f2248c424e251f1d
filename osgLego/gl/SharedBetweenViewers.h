#pragma once

#include <osgLego/gl/SharedGlObjects.h>

#include <algorithm>
#include <atomic>

#include <osg/DisplaySettings>
#include <osg/State>

namespace osgLego
{

/** An osg::Program or osg::Texture that nodes share, also those of different viewers.
 *
 * OSG keeps the GL objects of each context in an array, which one viewer may resize while a thread of another viewer
 * reads it. Here, the array has room for many contexts from the beginning, and does not change before it is exceeded.
 *
 * Releasing the state set of a node does not release its GL objects, which other nodes may use; SharedGlObjects does.
 */
template <typename Base>
class SharedBetweenViewers : public Base, private SharedGlObject
{
public:
    using Base::Base;

    /** Make room for contexts; called once, when the object is complete. */
    void reserveContexts()
    {
        SharedGlObjects::get().add(*this);
        const unsigned int known = osg::DisplaySettings::instance()->getMaxNumberOfGraphicsContexts();
        _numContexts = std::max(LEAST_CONTEXTS, known);
        Base::resizeGLObjectBuffers(_numContexts);
    }

    void resizeGLObjectBuffers(unsigned int maxSize) override
    {
        if (maxSize <= _numContexts) return;
        _numContexts = maxSize;
        Base::resizeGLObjectBuffers(maxSize);
    }

    void releaseGLObjects(osg::State*) const override {}

protected:
    ~SharedBetweenViewers() override { SharedGlObjects::get().remove(*this); }

private:
    void release(osg::State* state) const override { Base::releaseGLObjects(state); }

    static constexpr unsigned int LEAST_CONTEXTS = 64;

    std::atomic<unsigned int> _numContexts{0};
};

} // namespace osgLego
