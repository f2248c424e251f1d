#include <osgLego/gl/ContextProgram.h>

#include <osgLego/gl/GlRequirements.h>

namespace osgLego
{

void ContextProgram::apply(osg::State& state) const
{
    prepare(state);
    useForCore(state);
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

void ContextProgram::retry(osg::State& state)
{
    const auto* applied =
        dynamic_cast<const ContextProgram*>(state.getLastAppliedAttribute(osg::StateAttribute::PROGRAM));
    if (!applied || state.getLastAppliedProgramObject()) return;
    const ContextProgram* forCore = applied->useForCore(state);
    const ContextProgram& used = forCore ? *forCore : *applied;
    for (unsigned int index = 0; index < used.getNumShaders(); ++index)
        used.getShader(index)->getPCS(state)->requestCompile();
    used.getPCP(state)->requestLink();
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
