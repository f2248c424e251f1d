#pragma once

#include <osg/Program>
#include <osg/State>
#include <osg/StateSet>
#include <osg/ref_ptr>

namespace osgLego
{

/** The state of a pass: its program, and all other state as GL starts with it, whatever the scene around the pass
 * sets. */
osg::ref_ptr<osg::StateSet> createPassState(osg::Program& program);

/** The same state without a program. */
void applyInitialState(osg::StateSet& stateSet);

/** Whether a complete frame buffer object is bound for drawing. OSG draws into the window when it can't make one, above
 * all for lack of memory. Needs the context of the state current. */
bool isTargetThere(const osg::State& state);

} // namespace osgLego
