#include <osgLego/occlusion/PictureArea.h>

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/vector_relational.hpp>
#include <osg/Geometry>
#include <osg/Matrixd>

namespace osgLego
{

namespace
{

constexpr int MARGIN = 4; // pixels, for the lines of wire frames

/** Bounds in a picture whose coordinates run from -1 to 1. */
struct PictureBounds
{
    glm::dvec2 lower{std::numeric_limits<double>::infinity()};
    glm::dvec2 upper{-std::numeric_limits<double>::infinity()};

    void add(const PictureBounds& other)
    {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
};

/** @return nothing if the box reaches behind the eye. */
std::optional<PictureBounds> project(const osg::BoundingBox& box, const osg::Matrixd& toPicture)
{
    PictureBounds bounds;
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
        const osg::Vec4d place = osg::Vec4d(osg::Vec3d(box.corner(corner)), 1.0) * toPicture;
        if (!(place.w() > 0.0)) return {};
        const glm::dvec2 point = glm::dvec2(place.x(), place.y()) / place.w();
        bounds.add({point, point});
    }
    return bounds;
}

bool isPolygonal(const osg::Drawable& drawable)
{
    const osg::Geometry* geometry = drawable.asGeometry();
    if (!geometry) return true;
    const osg::Geometry::PrimitiveSetList& primitives = geometry->getPrimitiveSetList();
    return std::none_of(primitives.begin(), primitives.end(),
                        [](const osg::ref_ptr<osg::PrimitiveSet>& set) { return set->getMode() <= GL_LINE_STRIP; });
}

/** Add the bounds of a leaf. @return false if they are unknown. */
bool addLeaf(const osgUtil::RenderLeaf& leaf, PictureBounds& bounds)
{
    const osg::Drawable* drawable = leaf.getDrawable();
    if (!drawable || !isPolygonal(*drawable) || !leaf._projection || !leaf._modelview) return false;
    const osg::BoundingBox& box = drawable->getBoundingBox();
    if (!box.valid()) return false;
    const std::optional<PictureBounds> projected = project(box, *leaf._modelview * *leaf._projection);
    if (projected) bounds.add(*projected);
    return projected.has_value();
}

/** Add the bounds of all leaves of a bin. @return false if those of one are unknown. */
bool addLeaves(osgUtil::RenderBin& bin, PictureBounds& bounds)
{
    for (const osgUtil::StateGraph* graph : bin.getStateGraphList())
        for (const osg::ref_ptr<osgUtil::RenderLeaf>& leaf : graph->_leaves)
            if (!addLeaf(*leaf, bounds)) return false;
    const auto addBin = [&](const auto& entry) { return addLeaves(*entry.second, bounds); };
    return std::all_of(bin.getRenderBinList().begin(), bin.getRenderBinList().end(), addBin);
}

} // namespace

PictureArea findArea(osgUtil::RenderStage& stage, const glm::ivec2& size)
{
    PictureBounds bounds;
    if (!addLeaves(stage, bounds)) return {glm::ivec2(0), size};
    const glm::dvec2 pixels(size);
    const auto toPixels = [&](const glm::dvec2& place)
    { return glm::clamp((0.5 * place + 0.5) * pixels, -pixels, 2.0 * pixels); };
    if (glm::any(glm::greaterThan(bounds.lower, bounds.upper))) return {};
    const glm::ivec2 lower = glm::max(glm::ivec2(glm::floor(toPixels(bounds.lower))) - MARGIN, 0);
    const glm::ivec2 upper = glm::min(glm::ivec2(glm::ceil(toPixels(bounds.upper))) + MARGIN, size);
    return {lower, upper};
}

} // namespace osgLego
