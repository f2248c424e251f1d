#include <osgLego/polygonization/Faces.h>

#include <osg/CullFace>
#include <osg/Depth>
#include <osg/FrontFace>
#include <osg/PolygonMode>

namespace osgLego
{

namespace
{

template <typename Attribute>
const Attribute* findAttribute(const osg::State& state, osg::StateAttribute::Type type)
{
    return dynamic_cast<const Attribute*>(state.getLastAppliedAttribute(type));
}

/** Whether a state shows only the nearest surface of those that it doesn't cull, without clipping and blending. */
bool showsNearestOnly(const osg::State& state)
{
    for (const auto mode :
         {GL_BLEND, GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3,
          GL_CLIP_PLANE4, GL_CLIP_PLANE5, GL_CLIP_PLANE0 + 6, GL_CLIP_PLANE0 + 7})
        if (state.getLastAppliedMode(static_cast<osg::StateAttribute::GLMode>(mode))) return false;
    if (!state.getLastAppliedMode(GL_DEPTH_TEST)) return false;
    const auto* depth = findAttribute<osg::Depth>(state, osg::StateAttribute::DEPTH);
    if (depth && (!depth->getWriteMask() ||
                  (depth->getFunction() != osg::Depth::LESS && depth->getFunction() != osg::Depth::LEQUAL)))
        return false;
    const auto* polygonMode = findAttribute<osg::PolygonMode>(state, osg::StateAttribute::POLYGONMODE);
    if (polygonMode && polygonMode->getMode(osg::PolygonMode::FRONT) != osg::PolygonMode::FILL) return false;
    return !polygonMode || polygonMode->getMode(osg::PolygonMode::BACK) == osg::PolygonMode::FILL;
}

/** Whether clockwise faces are front faces in a state. */
bool isClockwise(const osg::State& state)
{
    const auto* frontFace = findAttribute<osg::FrontFace>(state, osg::StateAttribute::FRONTFACE);
    return frontFace && frontFace->getMode() == osg::FrontFace::CLOCKWISE;
}

} // namespace

CellView createView(const osg::State& state, const BrickGrid& grid, const osg::Matrixd& cellsToEye)
{
    CellView view(grid, cellsToEye, state.getProjectionMatrix());
    view.isMirrored = view.isMirrored != isClockwise(state);
    return view;
}

Faces findVisibleFaces(const osg::State& state, const CellView& view)
{
    if (!showsNearestOnly(state)) return Faces::ALL;
    const Faces nearest = view.isCutOpen ? Faces::ALL : Faces::FRONT;
    if (!state.getLastAppliedMode(GL_CULL_FACE)) return nearest;
    const auto* cullFace = findAttribute<osg::CullFace>(state, osg::StateAttribute::CULLFACE);
    const osg::CullFace::Mode culled = cullFace ? cullFace->getMode() : osg::CullFace::BACK;
    if (culled == osg::CullFace::FRONT_AND_BACK) return Faces::ALL;
    return (culled == osg::CullFace::FRONT) != view.isMirrored ? Faces::BACK : nearest;
}

} // namespace osgLego
