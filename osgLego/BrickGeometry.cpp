#include <osgLego/BrickGeometry.h>

#include <osgLego/BrickDimensions.h>
#include <osgLego/polygonization/BrickTriangles.h>

#include <array>
#include <cmath>
#include <numbers>

#include <glm/vec2.hpp>

namespace osgLego
{

namespace
{

using BrickDimensions::STUD_HEIGHT;
using BrickDimensions::STUD_RADIUS;
using BrickDimensions::STUD_SIDES;

// The number of triangles passed to a functor at a time, to limit the memory for a large model.
constexpr std::size_t TRIANGLES_AT_ONCE = 4096;

osg::Vec3 toOsg(const glm::dvec3& vector)
{
    return {static_cast<float>(vector.x), static_cast<float>(vector.y), static_cast<float>(vector.z)};
}

glm::dvec3 unitOf(int axis)
{
    glm::dvec3 unit(0.0);
    unit[axis] = 1.0;
    return unit;
}

/** The corners of a face of a cell, counter-clockwise as seen from outside, in cell units. */
std::array<glm::dvec3, 4> faceCorners(const Brick& brick, int axis, bool upper)
{
    const glm::dvec3 cell(brick.cell[0], brick.cell[1], brick.cell[2]);
    const glm::dvec3 corner = upper ? cell + unitOf(axis) : cell;
    const glm::dvec3 u = unitOf((axis + (upper ? 1 : 2)) % 3);
    const glm::dvec3 v = unitOf((axis + (upper ? 2 : 1)) % 3);
    return {corner, corner + u, corner + u + v, corner + v};
}

/** Calls `visit(axis, upper)` for every open side. */
template <typename Visit>
void forEachOpenSide(const Brick& brick, const Visit& visit)
{
    for (int side = 0; side < 6; ++side)
        if (brick.openSides & (1 << side)) visit(side / 2, side % 2 == 1);
}

/** The cosines and sines of the corners of a stud. */
std::array<glm::dvec2, STUD_SIDES> createStudCorners()
{
    std::array<glm::dvec2, STUD_SIDES> corners;
    double number = 0.0;
    for (glm::dvec2& corner : corners)
    {
        const double angle = 2.0 * std::numbers::pi * number++ / STUD_SIDES;
        corner = {std::cos(angle), std::sin(angle)};
    }
    return corners;
}

/** Collects the triangles of bricks, in the order assumed by BrickTriangles.h. */
class BrickMesh
{
public:
    explicit BrickMesh(const BrickGrid& grid) : _grid(grid) {}

    void add(const Brick& brick)
    {
        _color.set(brick.color[0], brick.color[1], brick.color[2], 255);
        forEachOpenSide(brick, [&](int axis, bool upper) { addFace(brick, axis, upper); });
        if (hasStud(brick, _grid)) addStud(brick);
    }

    std::size_t getNumTriangles() const { return _triangles->size() / 3; }

    void clear()
    {
        _vertices->clear();
        _normals->clear();
        _colors->clear();
        _triangles->clear();
    }

    void accept(osg::PrimitiveFunctor& functor) const
    {
        if (_triangles->empty()) return;
        functor.setVertexArray(_vertices->getNumElements(), &_vertices->front());
        functor.drawElements(GL_TRIANGLES, static_cast<GLsizei>(_triangles->size()), &_triangles->front());
    }

    osg::ref_ptr<osg::Geometry> createGeometry() const
    {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setName("bricks");
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setVertexArray(_vertices);
        geometry->setNormalArray(_normals, osg::Array::BIND_PER_VERTEX);
        geometry->setColorArray(_colors, osg::Array::BIND_PER_VERTEX);
        geometry->addPrimitiveSet(_triangles);
        return geometry;
    }

private:
    unsigned int addVertex(const glm::dvec3& cellPosition, const glm::dvec3& normal)
    {
        _vertices->push_back(toOsg(_grid.origin + _grid.cellSize * cellPosition));
        _normals->push_back(toOsg(normal));
        _colors->push_back(_color);
        return _vertices->getNumElements() - 1;
    }

    void addTriangle(unsigned int a, unsigned int b, unsigned int c)
    {
        for (const unsigned int index : {a, b, c})
            _triangles->push_back(index);
    }

    void addFace(const Brick& brick, int axis, bool upper)
    {
        const glm::dvec3 normal = (upper ? 1.0 : -1.0) * unitOf(axis);
        std::array<unsigned int, 4> indices{};
        const auto corners = faceCorners(brick, axis, upper);
        for (std::size_t corner = 0; corner < 4; ++corner)
            indices[corner] = addVertex(corners[corner], normal);
        addTriangle(indices[0], indices[1], indices[2]);
        addTriangle(indices[0], indices[2], indices[3]);
    }

    void addStud(const Brick& brick)
    {
        const int up = _grid.getUpIndex();
        const glm::dvec3 u = unitOf((up + 1) % 3);
        const glm::dvec3 v = unitOf((up + 2) % 3);
        const glm::dvec3 foot = glm::dvec3(brick.cell[0], brick.cell[1], brick.cell[2]) + 0.5 * (u + v) + unitOf(up);
        const glm::dvec3 rise = STUD_HEIGHT * _grid.getPitch() / _grid.cellSize[up] * unitOf(up);
        const unsigned int firstWall = _vertices->getNumElements();
        const unsigned int firstDisk = firstWall + 2 * STUD_SIDES;
        for (const glm::dvec2& corner : _studCorners)
        {
            const glm::dvec3 direction = corner.x * u + corner.y * v;
            addVertex(foot + STUD_RADIUS * direction, direction);
            addVertex(foot + STUD_RADIUS * direction + rise, direction);
        }
        for (const glm::dvec2& corner : _studCorners)
            addVertex(foot + STUD_RADIUS * (corner.x * u + corner.y * v) + rise, unitOf(up));

        for (unsigned int side = 0; side < STUD_SIDES; ++side)
        {
            const unsigned int here = firstWall + 2 * side;
            const unsigned int next = firstWall + 2 * ((side + 1) % STUD_SIDES);
            addTriangle(here, next, next + 1);
            addTriangle(here, next + 1, here + 1);
            if (side > 0 && side + 1 < STUD_SIDES) addTriangle(firstDisk, firstDisk + side, firstDisk + side + 1);
        }
    }

    const BrickGrid& _grid;
    const std::array<glm::dvec2, STUD_SIDES> _studCorners = createStudCorners();
    osg::ref_ptr<osg::Vec3Array> _vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> _normals = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> _colors = new osg::Vec4ubArray(osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::DrawElementsUInt> _triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    osg::Vec4ub _color;
};

} // namespace

osg::ref_ptr<osg::Geometry> createBrickGeometry(const BrickModel& model)
{
    BrickMesh mesh(model.getGrid());
    for (const Brick& brick : model.getBricks())
        mesh.add(brick);
    osg::ref_ptr<osg::Geometry> geometry = mesh.createGeometry();
    // The geometry needs memory before it owns the holder.
    const osg::ref_ptr<BrickModelHolder> holder = new BrickModelHolder(model);
    geometry->setUserData(holder);
    return geometry;
}

void acceptBrickTriangles(const BrickModel& model, osg::PrimitiveFunctor& functor)
{
    BrickMesh mesh(model.getGrid());
    for (const Brick& brick : model.getBricks())
    {
        mesh.add(brick);
        if (mesh.getNumTriangles() < TRIANGLES_AT_ONCE) continue;
        mesh.accept(functor);
        mesh.clear();
    }
    mesh.accept(functor);
}

} // namespace osgLego
