#pragma once

#include <array>

#include <osg/Matrixd>
#include <osgUtil/PositionalStateContainer>
#include <osgUtil/RenderStage>

namespace osgLego
{

/** The attributes that a stage positions in eye coordinates: its own, and those of the camera that contains it. */
struct PositionedState
{
    osgUtil::PositionalStateContainer* container;
    osg::Matrixd toEye; // after the matrix of an attribute

    osg::Matrixd getMatrix(const osg::RefMatrix* matrix) const { return matrix ? *matrix * toEye : toEye; }
};

/** Those of a stage, in the order in which they are applied. */
inline std::array<PositionedState, 2> findPositionedStates(osgUtil::RenderStage& stage)
{
    return {{{stage.getInheritedPositionalStateContainer(), stage.getInheritedPositionalStateContainerMatrix()},
             {stage.getPositionalStateContainer(), osg::Matrixd()}}};
}

} // namespace osgLego
