#include <osgLego/flattening/SourceVisitor.h>

#include <osgLego/flattening/SequenceStart.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace osgLego
{

namespace
{

/** Whether a drawable is an osgText::Text. By its names, since the library links osgText for nothing else. */
bool isText(const osg::Drawable& drawable)
{
    return std::string_view(drawable.libraryName()) == "osgText" &&
           std::string_view(drawable.className()) != "Text3D"; // which has triangles
}

} // namespace

SourceVisitor::SourceVisitor() : SourceVisitor(osg::Matrixd()) {}

SourceVisitor::SourceVisitor(const osg::Matrixd& toRoot) :
    osg::NodeVisitor(osg::NodeVisitor::NODE_VISITOR, osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN), _matrix(toRoot)
{
}

void SourceVisitor::apply(osg::Node& node)
{
    traverseWithState(node);
}

void SourceVisitor::apply(osg::Transform& transform)
{
    const osg::Matrixd outer = _matrix;
    transform.computeLocalToWorldMatrix(_matrix, this);
    traverseWithState(transform);
    _matrix = outer;
}

void SourceVisitor::apply(osg::Camera& camera)
{
    if (camera.getRenderOrder() == osg::Camera::NESTED_RENDER) apply(static_cast<osg::Transform&>(camera));
}

void SourceVisitor::apply(osg::LOD& lod)
{
    const bool byDistance = lod.getRangeMode() == osg::LOD::DISTANCE_FROM_EYE_POINT;
    const unsigned int count = std::min(lod.getNumChildren(), lod.getNumRanges());
    float finest = 0.0f;
    for (unsigned int child = 0; child < count; ++child)
    {
        const float begin = lod.getMinRange(child);
        finest = child == 0 ? begin : byDistance ? std::min(finest, begin) : std::max(finest, begin);
    }

    const bool pushed = pushState(lod);
    for (unsigned int child = 0; child < count; ++child)
        if (lod.getMinRange(child) <= finest && finest < lod.getMaxRange(child)) lod.getChild(child)->accept(*this);
    if (pushed) _stateSets.pop_back();
}

void SourceVisitor::apply(osg::Sequence& sequence)
{
    const std::optional<unsigned int> start = findSequenceStart(sequence);
    if (!start)
    {
        traverseWithState(sequence);
        return;
    }
    const bool pushed = pushState(sequence);
    sequence.getChild(*start)->accept(*this);
    if (pushed) _stateSets.pop_back();
}

void SourceVisitor::apply(osg::Drawable& drawable)
{
    if (isText(drawable))
    {
        ++_numTexts;
        return;
    }
    const bool pushed = pushState(drawable);
    applySurface(drawable, _matrix, _stateSets);
    if (pushed) _stateSets.pop_back();
}

void SourceVisitor::traverseWithState(osg::Node& node)
{
    const bool pushed = pushState(node);
    traverse(node);
    if (pushed) _stateSets.pop_back();
}

bool SourceVisitor::pushState(const osg::Node& node)
{
    if (!node.getStateSet()) return false;
    _stateSets.push_back(node.getStateSet());
    return true;
}

} // namespace osgLego
