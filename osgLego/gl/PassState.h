#pragma once

#include <osg/Program>
#include <osg/State>
#include <osg/StateSet>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the state of a pass: its program, and otherwise GL's initial state, regardless of state set in the scene. */
osg::ref_ptr<osg::StateSet> createPassState(osg::Program& program);

/** Set the same state, without a program. */
void applyInitialState(osg::StateSet& stateSet);

/** Make points squares of the size set by the vertex shader, and fill polygons. */
void setPointModes(osg::StateSet& stateSet);

/** Whether a complete frame buffer object is bound for drawing. If OSG can't create one, usually for lack of memory, it
 * draws into the window instead. Needs the context of `state` current. */
bool isTargetThere(const osg::State& state);

} // namespace osgLego
