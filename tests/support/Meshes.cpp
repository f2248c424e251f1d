#include "Meshes.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <random>

#include <osg/Geode>
#include <osg/ShapeDrawable>
#include <osg/Texture2D>
#include <osgDB/FileUtils>
#include <osgDB/ReadFile>

namespace osgLego::test
{

namespace
{

using std::numbers::pi;

osg::Vec4 colorOf(const osg::Vec3& place)
{
    return {0.5f + 0.45f * std::sin(2.0f * place.x()), 0.5f + 0.45f * std::sin(2.5f * place.y() + 1.0f),
            0.5f + 0.45f * std::sin(3.0f * place.z() + 2.0f), 1.0f};
}

void colorByPlace(osg::Geometry& geometry)
{
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
    for (const osg::Vec3& vertex : static_cast<osg::Vec3Array&>(*geometry.getVertexArray()))
        colors->push_back(colorOf(vertex));
    geometry.setColorArray(colors, osg::Array::BIND_PER_VERTEX);
}

/** A grid of quads over the unit square, mapped to a surface by a function of its coordinates. */
osg::ref_ptr<osg::Geometry> createWrapped(int columns, int rows, const std::function<osg::Vec3(double, double)>& place)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    osg::ref_ptr<osg::DrawElementsUInt> quads = new osg::DrawElementsUInt(GL_QUADS);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
        {
            const double u = static_cast<double>(column) / columns;
            const double v = static_cast<double>(row) / rows;
            vertices->push_back(place(u, v));
            coordinates->push_back(osg::Vec2d(4.0 * u, 2.0 * v));
            if (row == rows || column == columns) continue;
            const auto corner = static_cast<unsigned int>(row * (columns + 1) + column);
            const auto above = corner + static_cast<unsigned int>(columns) + 1;
            for (const unsigned int index : {corner, corner + 1, above + 1, above})
                quads->push_back(index);
        }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setTexCoordArray(0, coordinates);
    geometry->addPrimitiveSet(quads);
    return geometry;
}

osg::ref_ptr<osg::Node> toNode(osg::Geometry* geometry)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

osg::ref_ptr<osg::Image> createSmoothImage()
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(128, 64, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int row = 0; row < image->t(); ++row)
        for (int column = 0; column < image->s(); ++column)
        {
            const double s = 2.0 * pi * column / image->s();
            const double t = 2.0 * pi * row / image->t();
            unsigned char* pixel = image->data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            pixel[0] = static_cast<unsigned char>(127.5 + 120.0 * std::sin(s));
            pixel[1] = static_cast<unsigned char>(127.5 + 120.0 * std::sin(t));
            pixel[2] = static_cast<unsigned char>(127.5 + 120.0 * std::cos(s + t));
        }
    return image;
}

/** Add a box. @param lower and upper corners. */
void addBox(osg::Group& group, const osg::Vec3& lower, const osg::Vec3& upper)
{
    const osg::Vec3 size = upper - lower;
    group.addChild(new osg::ShapeDrawable(new osg::Box((lower + upper) * 0.5f, size.x(), size.y(), size.z())));
}

} // namespace

osg::ref_ptr<osg::Geometry> createTriangle(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const osg::Vec3& corner : {a, b, c})
        vertices->push_back(corner);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    return geometry;
}

osg::ref_ptr<osg::Geometry> createUnitTriangle()
{
    return createTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
}

osg::ref_ptr<osg::Node> createSphere(int rings)
{
    osg::ref_ptr<osg::Geometry> geometry =
        createWrapped(2 * rings, rings,
                      [](double u, double v)
                      {
                          return osg::Vec3d(std::cos(2 * pi * u) * std::sin(pi * v),
                                            std::sin(2 * pi * u) * std::sin(pi * v), -std::cos(pi * v));
                      });
    colorByPlace(*geometry);
    return toNode(geometry);
}

osg::ref_ptr<osg::Node> createTorus()
{
    osg::ref_ptr<osg::Geometry> geometry = createWrapped(
        48, 24,
        [](double u, double v)
        {
            const double around = 1.0 + 0.4 * std::cos(2 * pi * v);
            return osg::Vec3d(around * std::cos(2 * pi * u), around * std::sin(2 * pi * u), 0.4 * std::sin(2 * pi * v));
        });
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(createSmoothImage());
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::MIRROR);
    geometry->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return toNode(geometry);
}

osg::ref_ptr<osg::Node> createThinPlate()
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::DrawElementsUInt> quads = new osg::DrawElementsUInt(GL_QUADS);
    for (unsigned int corner = 0; corner < 8; ++corner)
        vertices->push_back(osg::Vec3(corner & 1 ? 2.0f : 0.0f, corner & 2 ? 1.4f : 0.0f, corner & 4 ? 0.01f : 0.0f));
    for (const unsigned int index :
         {0u, 2u, 3u, 1u, 4u, 5u, 7u, 6u, 0u, 1u, 5u, 4u, 2u, 6u, 7u, 3u, 0u, 4u, 6u, 2u, 1u, 3u, 7u, 5u})
        quads->push_back(index);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(quads);
    colorByPlace(*geometry);
    return toNode(geometry);
}

osg::ref_ptr<osg::Node> createSliverSoup(int count, std::uint32_t seed)
{
    std::mt19937 engine(seed);
    // Unlike the distributions of the standard library, this gives the same values everywhere.
    const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0 * 2.0 - 1.0; };
    const auto randomVector = [&](double scale)
    {
        const double x = random();
        const double y = random();
        return osg::Vec3d(x, y, random()) * scale;
    };
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> colors = new osg::Vec4ubArray;
    for (int triangle = 0; triangle < count; ++triangle)
    {
        const osg::Vec3d from = randomVector(1.0);
        const osg::Vec3d to = randomVector(1.0);
        for (const osg::Vec3d& corner : {from, to, (from + to) * 0.5 + randomVector(0.02)})
            vertices->push_back(corner);
        const std::uint32_t bits = static_cast<std::uint32_t>(engine());
        for (int corner = 0; corner < 3; ++corner)
            colors->push_back(osg::Vec4ub(static_cast<unsigned char>(bits), static_cast<unsigned char>(bits >> 8),
                                          static_cast<unsigned char>(bits >> 16), 255));
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3 * count));
    return toNode(geometry);
}

osg::ref_ptr<osg::Node> createCoincidingCorners()
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createTriangle({0.0f, 0.1f, 2.1f}, {1e-7f, 0.1f, 2.1f}, {0.0f, 0.2f, 5.9f}));
    group->addChild(createTriangle({8.0f, 0.2f, 5.9f}, {8.0f, 0.1f, 2.1f}, {8.0000005f, 0.1f, 2.1f}));
    group->addChild(
        createTriangle({0.0f, 0.0f, 0.0f}, {16.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 16.0f})); // for the grid's size
    return group;
}

osg::ref_ptr<osg::Node> readBunny()
{
    const char* folder = std::getenv("OSGLEGO_TEST_MODELS");
    const std::string fileName = std::string(folder ? folder : OSGLEGO_TEST_MODELS) + "/bunny.ply";
    return osgDB::fileExists(fileName) ? osgDB::readRefNodeFile(fileName) : nullptr;
}

osg::ref_ptr<osg::Node> createBridge()
{
    constexpr float BRICK_HEIGHT = 1.2f; // in studs
    constexpr float GAP = 0.02f;         // to the borders of cells
    const osg::ref_ptr<osg::Group> bridge = new osg::Group;
    addBox(*bridge, {0, 0, 0}, {2 - GAP, 7 - GAP, 2 * BRICK_HEIGHT});
    addBox(*bridge, {66 + GAP, 0, 0}, {68 - GAP, 7 - GAP, 2 * BRICK_HEIGHT});
    addBox(*bridge, {0, 0, 2 * BRICK_HEIGHT}, {68 - GAP, 7 - GAP, 10 * BRICK_HEIGHT - GAP});
    return bridge;
}

osg::ref_ptr<osg::Node> createFourLeggedTable()
{
    constexpr float HEIGHT = 9.0f; // of the legs
    const osg::ref_ptr<osg::Group> table = new osg::Group;
    addBox(*table, {0, 0, HEIGHT}, {16, 10, HEIGHT + 2});
    for (const float x : {0.2f, 14.8f})
        for (const float y : {0.2f, 8.8f})
            addBox(*table, {x, y, 0}, {x + 1, y + 1, HEIGHT});
    return table;
}

} // namespace osgLego::test
