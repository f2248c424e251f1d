#include "TableGrid.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <osg/Geode>
#include <osg/Geometry>

namespace osgLego
{

namespace
{

// Visible beside white bricks, and lighter than their edges.
const osg::Vec4 LIGHT_GRAY(0.75f, 0.75f, 0.75f, 1.0f);

/** The height of the table along the up axis, in cells. */
int findTable(std::span<const Part> parts, int up, bool isUpsideDown)
{
    int lowest = std::numeric_limits<int>::max();
    int highest = std::numeric_limits<int>::min();
    for (const Part& part : parts)
    {
        const int bottom = part.getCell()[up];
        lowest = std::min(lowest, bottom);
        highest = std::max(highest, bottom + part.getSize()[up]);
    }
    return isUpsideDown ? highest : lowest;
}

/** The cells of a rectangle. */
struct Rectangle
{
    glm::ivec3 lowest{std::numeric_limits<int>::max()};
    glm::ivec3 highest{std::numeric_limits<int>::min()};
};

/** The rectangle around the parts on the table, and one stud more. */
Rectangle findRectangle(std::span<const Part> parts, int up, int table)
{
    Rectangle rectangle;
    for (const Part& part : parts)
    {
        const glm::ivec3 lowest(part.getCell());
        const glm::ivec3 highest = lowest + glm::ivec3(part.getSize());
        if (lowest[up] != table && highest[up] != table) continue;
        rectangle.lowest = glm::min(rectangle.lowest, lowest - 1);
        rectangle.highest = glm::max(rectangle.highest, highest + 1);
    }
    rectangle.lowest[up] = rectangle.highest[up] = table;
    return rectangle;
}

} // namespace

osg::ref_ptr<osg::Node> createTableGrid(const BrickGrid& grid, std::span<const Part> parts, bool isUpsideDown)
{
    const int up = grid.getUpIndex();
    const int across = up == 1 ? 2 : 1;
    const Rectangle rectangle = findRectangle(parts, up, findTable(parts, up, isUpsideDown));

    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    const auto addVertex = [&](const glm::ivec3& cell)
    {
        const glm::dvec3 place = grid.origin + glm::dvec3(cell) * grid.cellSize;
        vertices->push_back(osg::Vec3d(place.x, place.y, place.z));
    };
    for (const auto& [axis, other] : {std::pair(0, across), std::pair(across, 0)})
        for (int line = rectangle.lowest[axis]; line <= rectangle.highest[axis]; ++line)
            for (const int end : {rectangle.lowest[other], rectangle.highest[other]})
            {
                glm::ivec3 cell = rectangle.lowest;
                cell[axis] = line;
                cell[other] = end;
                addVertex(cell);
            }

    osg::ref_ptr<osg::Geometry> lines = new osg::Geometry;
    lines->setVertexArray(vertices);
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    colors->push_back(LIGHT_GRAY);
    lines->setColorArray(colors);
    lines->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, static_cast<GLsizei>(vertices->size())));
    lines->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(lines);
    return geode;
}

} // namespace osgLego
