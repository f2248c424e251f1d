#include <osgLego/polygonization/CoreClipPlanes.h>

#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/polygonization/PositionedState.h>

#include <osg/ClipPlane>
#include <osgUtil/RenderBin>

namespace osgLego
{

CoreClipPlanes::CoreClipPlanes(osg::RenderInfo& renderInfo)
{
    const osg::State& state = *renderInfo.getState();
    if (!GlRequirements::isCore(state) || renderInfo.getRenderBinStack().empty()) return;
    for (const PositionedState& positioned : findPositionedStates(*renderInfo.getRenderBinStack().back()->getStage()))
    {
        if (!positioned.container) continue;
        for (const auto& [attribute, matrix] : positioned.container->getAttrMatrixList())
        {
            const auto* plane = dynamic_cast<const osg::ClipPlane*>(attribute.get());
            if (!plane || plane->getClipPlaneNum() >= MAXIMUM) continue;
            if (!state.getLastAppliedMode(GL_CLIP_PLANE0 + plane->getClipPlaneNum())) continue;
            const osg::Matrixd toWorld = osg::Matrixd::inverse(positioned.getMatrix(matrix.get()));
            const osg::Vec4d inEye = toWorld * plane->getClipPlane();
            _planes[plane->getClipPlaneNum()] = glm::vec4(inEye.x(), inEye.y(), inEye.z(), inEye.w());
            _hasPlanes = true;
        }
    }
}

void CoreClipPlanes::apply(const osg::State& state) const
{
    if (isEmpty()) return;
    static const UniformName PLANES("clipPlanes");
    ProgramUniforms(state).set(PLANES, _planes.data(), static_cast<GLsizei>(MAXIMUM));
}

} // namespace osgLego
