#pragma once

#include <osgLego/gl/SharedBetweenViewers.h>

#include <functional>
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

    /** If the program that was applied last to a context could not be linked, have its shaders compiled and linked
     * again when it is applied next: OSG would not try again. */
    static void retry(osg::State& state);

private:
    ~ContextProgram() override = default;

    void prepare(const osg::State& state) const;
    /** Share the GL program of the program for core contexts, and return that program; null in other contexts. */
    const ContextProgram* useForCore(osg::State& state) const;

    Create _createForCore;
    mutable std::mutex _mutex;
    mutable osg::ref_ptr<ContextProgram> _forCore;
};

} // namespace osgLego
