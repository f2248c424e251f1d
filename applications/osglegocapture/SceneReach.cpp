#include "SceneReach.h"

#include <osgLego/BrickGrid.h>
#include <osgLego/LegoNode.h>
#include <osgLego/flattening/SequenceStart.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <osg/Camera>
#include <osg/Drawable>

namespace osgLego
{

namespace
{

constexpr double MAXIMUM_COORDINATE = 1e18; // the library ignores triangles beyond this
constexpr double NOWHERE = -std::numeric_limits<double>::infinity();

osg::Vec3d toPoint(const osg::Vec2d& vertex)
{
    return {vertex.x(), vertex.y(), 0.0};
}

osg::Vec3d toPoint(const osg::Vec3d& vertex)
{
    return vertex;
}

osg::Vec3d toPoint(const osg::Vec4d& vertex)
{
    return {vertex.x(), vertex.y(), vertex.z()};
}

/** Passes on the vertices used by the primitives of a drawable. */
class UsedVertices : public osg::PrimitiveFunctor
{
public:
    explicit UsedVertices(const std::function<void(const osg::Vec3d&)>& take) : _take(take) {}

    void setVertexArray(unsigned int count, const osg::Vec2* vertices) override
    {
        setArray<osg::Vec2d>(count, vertices);
    }
    void setVertexArray(unsigned int count, const osg::Vec3* vertices) override
    {
        setArray<osg::Vec3d>(count, vertices);
    }
    void setVertexArray(unsigned int count, const osg::Vec4* vertices) override
    {
        setArray<osg::Vec4d>(count, vertices);
    }
    void setVertexArray(unsigned int count, const osg::Vec2d* vertices) override
    {
        setArray<osg::Vec2d>(count, vertices);
    }
    void setVertexArray(unsigned int count, const osg::Vec3d* vertices) override
    {
        setArray<osg::Vec3d>(count, vertices);
    }
    void setVertexArray(unsigned int count, const osg::Vec4d* vertices) override
    {
        setArray<osg::Vec4d>(count, vertices);
    }

    void drawArrays(GLenum, GLint first, GLsizei count) override
    {
        for (GLint index = first; index < first + count; ++index)
            takeVertex(static_cast<unsigned int>(index));
    }
    void drawElements(GLenum, GLsizei count, const GLubyte* indices) override { takeVertices(count, indices); }
    void drawElements(GLenum, GLsizei count, const GLushort* indices) override { takeVertices(count, indices); }
    void drawElements(GLenum, GLsizei count, const GLuint* indices) override { takeVertices(count, indices); }

private:
    template <typename Double, typename Vector>
    void setArray(unsigned int count, const Vector* vertices)
    {
        _count = count;
        _vertexAt = [vertices](unsigned int index) { return toPoint(Double(vertices[index])); };
    }

    template <typename Index>
    void takeVertices(GLsizei count, const Index* indices)
    {
        for (GLsizei place = 0; place < count; ++place)
            takeVertex(indices[place]);
    }

    void takeVertex(unsigned int index) const
    {
        if (index < _count) _take(_vertexAt(index));
    }

    std::function<void(const osg::Vec3d&)> _take;
    std::function<osg::Vec3d(unsigned int)> _vertexAt;
    unsigned int _count = 0;
};

} // namespace

SceneReach::SceneReach(const std::vector<osg::Vec3d>& directions) :
    osg::NodeVisitor(osg::NodeVisitor::NODE_VISITOR, osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN),
    _directions(directions), _surface(createSurface({}))
{
}

SceneReach::Surface SceneReach::createSurface(const osg::Matrixd& toScene) const
{
    const std::vector<double> nowhere(_directions.size(), NOWHERE);
    return {toScene, 2, {}, nowhere, nowhere};
}

void SceneReach::addSource(osg::Node& source, const LegoSettings& settings)
{
    addBricks(settings, [&] { source.accept(*this); });
}

void SceneReach::apply(osg::Group& group)
{
    const auto* lego = dynamic_cast<LegoNode*>(&group);
    if (!lego)
    {
        traverse(group);
        return;
    }
    if (const osg::ref_ptr<const BrickModel> stored = lego->getStoredBricks())
    {
        addStoredBricks(*stored);
        return;
    }
    addBricks(lego->getSettings(),
              [&]
              {
                  for (unsigned int child = 0; child < group.getNumChildren(); ++child)
                      group.getChild(child)->accept(*this);
              });
}

void SceneReach::apply(osg::Sequence& sequence)
{
    if (const std::optional<unsigned int> start = findSequenceStart(sequence))
        sequence.getChild(*start)->accept(*this);
    else
        traverse(sequence);
}

void SceneReach::apply(osg::Transform& transform)
{
    const auto* camera = transform.asCamera();
    if (camera && camera->getRenderOrder() != osg::Camera::NESTED_RENDER) return;
    const osg::Matrixd outer = _matrix;
    transform.computeLocalToWorldMatrix(_matrix, this);
    traverse(transform);
    _matrix = outer;
}

void SceneReach::apply(osg::Drawable& drawable)
{
    UsedVertices vertices([this](const osg::Vec3d& vertex) { addPoint(vertex * _matrix); });
    drawable.accept(vertices);
}

void SceneReach::addBricks(const LegoSettings& settings, const std::function<void()>& visitSource)
{
    const osg::Matrixd toSurface = std::exchange(_matrix, osg::Matrixd());
    Surface outer = std::exchange(_surface, createSurface(toSurface * _surface.toScene));
    _surface.upIndex = settings.grid.upAxis == UpAxis::Y ? 1 : 2;
    const bool isNested = std::exchange(_isInSource, true);
    visitSource();
    const Surface source = std::exchange(_surface, std::move(outer));
    _matrix = toSurface;
    _isInSource = isNested;
    if (!source.bounds.valid()) return;

    const BrickGrid grid = BrickGrid::fit(source.bounds, settings);
    const osg::BoundingBoxd bricks = grid.getNumCells() > 0 ? grid.getBrickBounds() : source.bounds;
    if (!bricks.intersects(source.bounds))
    {
        // A grid of cells of a given size, beside the source.
        addBox(bricks);
        return;
    }
    if (isNested)
    {
        // Nested LegoNodes: the outer bricks are made from the inner ones.
        addBox(bricks);
        return;
    }
    const osg::Vec3d cell(grid.cellSize.x, grid.cellSize.y, grid.cellSize.z);
    osg::BoundingBoxd around(-cell, cell);
    around._max[grid.getUpIndex()] += grid.getStudHeight() * grid.cellSize[grid.getUpIndex()];
    const std::vector<double> boxReach = reachOf(bricks, source.toScene, false);
    const std::vector<double> cellReach = reachOf(around, source.toScene, true);
    osg::Vec3d bottom;
    bottom[grid.getUpIndex()] = bricks._min[grid.getUpIndex()];
    bottom = osg::Matrixd::transform3x3(bottom, source.toScene);
    for (std::size_t index = 0; index < _directions.size(); ++index)
    {
        double reach = source.reach[index];
        if (settings.parts.support) reach = std::max(reach, source.groundReach[index] + _directions[index] * bottom);
        _surface.reach[index] = std::max(_surface.reach[index], std::min(boxReach[index], reach + cellReach[index]));
    }
    _surface.bounds.expandBy(source.bounds);
}

void SceneReach::addBox(const osg::BoundingBoxd& box)
{
    for (unsigned int corner = 0; corner < 8; ++corner)
        addPoint(box.corner(corner) * _matrix);
}

void SceneReach::addStoredBricks(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    const osg::Matrixd toSurface = grid.getCellsToModel() * _matrix;
    const osg::Matrixd toScene = toSurface * _surface.toScene;
    std::vector<double> cellReach(_directions.size(), NOWHERE);
    for (const Brick& brick : model.getBricks())
    {
        if (brick.openSides == 0) continue;
        const osg::Vec3d corner(brick.cell[0], brick.cell[1], brick.cell[2]);
        _surface.bounds.expandBy(corner * toSurface);
        const osg::Vec3d inScene = corner * toScene;
        for (std::size_t index = 0; index < _directions.size(); ++index)
            cellReach[index] = std::max(cellReach[index], _directions[index] * inScene);
    }
    osg::BoundingBoxd around(osg::Vec3d(0, 0, 0), osg::Vec3d(1, 1, 1)); // a brick and its stud
    around._max[grid.getUpIndex()] += grid.getStudHeight();
    const std::vector<double> brickReach = reachOf(around, toScene, true);
    for (std::size_t index = 0; index < _directions.size(); ++index)
        _surface.reach[index] = std::max(_surface.reach[index], cellReach[index] + brickReach[index]);
}

void SceneReach::addPoint(const osg::Vec3d& point)
{
    // Written so that NaN is rejected.
    for (const double coordinate : {point.x(), point.y(), point.z()})
        if (!(std::abs(coordinate) <= MAXIMUM_COORDINATE)) return;
    _surface.bounds.expandBy(point);
    osg::Vec3d ground = point;
    ground[_surface.upIndex] = 0.0;
    ground = ground * _surface.toScene;
    const osg::Vec3d inScene = point * _surface.toScene;
    for (std::size_t index = 0; index < _directions.size(); ++index)
    {
        _surface.reach[index] = std::max(_surface.reach[index], _directions[index] * inScene);
        _surface.groundReach[index] = std::max(_surface.groundReach[index], _directions[index] * ground);
    }
}

std::vector<double> SceneReach::reachOf(const osg::BoundingBoxd& box, const osg::Matrixd& toScene, bool isOffset) const
{
    std::vector<double> reach(_directions.size(), NOWHERE);
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
        const osg::Vec3d point =
            isOffset ? osg::Matrixd::transform3x3(box.corner(corner), toScene) : box.corner(corner) * toScene;
        for (std::size_t index = 0; index < _directions.size(); ++index)
            reach[index] = std::max(reach[index], _directions[index] * point);
    }
    return reach;
}

} // namespace osgLego
