#pragma once

#include <osgLego/gl/SharedBetweenViewers.h>

#include <functional>
#include <map>
#include <mutex>
#include <utility>

#include <osg/Program>
#include <osg/ref_ptr>

namespace osgLego
{

/** A program for contexts of the compatibility profile that another one replaces in contexts of the core profile.
 *
 * State sets contain this program, since the profile of a context is unknown before drawing. The other one is created
 * in the first core context.
 */
class ContextProgram : public SharedBetweenViewers<osg::Program>
{
public:
    using Create = std::function<osg::ref_ptr<ContextProgram>()>;

    /** @param createForCore null for a program that is used in every context. */
    explicit ContextProgram(Create createForCore) : _createForCore(std::move(createForCore)) {}

    void apply(osg::State& state) const override;
    void compileGLObjects(osg::State& state) const override;

    /** Have each program that could not be linked in a context compiled and linked once more when it is applied there
     * next: OSG would not try again. May be called from any thread. */
    static void allowRetry();

private:
    ~ContextProgram() override = default;

    void prepare(const osg::State& state) const;
    /** Share the GL program of the program for core contexts, and return that program; null in other contexts. */
    const ContextProgram* useForCore(osg::State& state) const;
    void retryIfAllowed(osg::State& state) const;

    Create _createForCore;
    mutable std::mutex _mutex;
    mutable osg::ref_ptr<ContextProgram> _forCore;
    mutable std::map<unsigned int, unsigned int> _attempts; // the last one in each context that has failed
};

} // namespace osgLego
