#include <osgLego/gl/ContextProgram.h>

#include <osgLego/gl/GlRequirements.h>

#include <atomic>
#include <utility>

namespace osgLego
{

namespace
{

std::atomic<unsigned int> numAllowed{0}; // calls of ContextProgram::allowRetry()

} // namespace

void ContextProgram::apply(osg::State& state) const
{
    prepare(state);
    const ContextProgram* forCore = useForCore(state);
    (forCore ? forCore : this)->retryIfAllowed(state);
    osg::Program::apply(state);
}

void ContextProgram::compileGLObjects(osg::State& state) const
{
    prepare(state);
    if (const ContextProgram* forCore = useForCore(state))
        forCore->compileGLObjects(state);
    else
        osg::Program::compileGLObjects(state);
}

void ContextProgram::allowRetry()
{
    ++numAllowed;
}

void ContextProgram::retryIfAllowed(osg::State& state) const
{
    PerContextProgram& linked = *getPCP(state);
    if (linked.isLinked()) return;
    const std::lock_guard lock(_mutex);
    const unsigned int attempt = numAllowed;
    const bool isAllowed = std::exchange(_attempts[state.getContextID()], attempt) != attempt;
    if (!isAllowed || linked.needsLink()) return;
    for (unsigned int index = 0; index < getNumShaders(); ++index)
        getShader(index)->getPCS(state)->requestCompile();
    linked.requestLink();
}

/** Have the GL program released with its context, before it is created. */
void ContextProgram::prepare(const osg::State& state) const
{
    const unsigned int contextID = state.getContextID();
    if (!_pcpList[contextID]) SharedGlObjects::releaseAtClose(contextID);
}

const ContextProgram* ContextProgram::useForCore(osg::State& state) const
{
    if (!_createForCore || !GlRequirements::hasCoreProfile(state)) return nullptr;
    const std::lock_guard lock(_mutex);
    if (!_forCore) _forCore = _createForCore();
    // Points are sprites without this mode, which GL rejects.
    state.setModeValidity(GL_POINT_SPRITE_ARB, false);
    // OSG reads this array directly when it compiles a state set.
    const unsigned int contextID = state.getContextID();
    _forCore->getPCP(state);
    _pcpList[contextID] = _forCore->_pcpList[contextID];
    return _forCore;
}

} // namespace osgLego
