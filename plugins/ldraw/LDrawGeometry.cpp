#include "LDrawGeometry.h"

#include "LDrawBricks.h"

#include <osg/Geometry>
#include <osg/LightModel>

namespace osgLego
{

namespace
{

osg::Vec3 toModel(const glm::dvec3& point)
{
    return osg::Vec3(osg::Vec3d(point.x, point.z, -point.y) * LDrawBricks::MILLIMETRES);
}

} // namespace

osg::ref_ptr<osg::Geode> createLDrawGeometry(std::span<const LDrawTriangle> triangles, const LDrawColors& colors)
{
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec4ubArray> vertexColors = new osg::Vec4ubArray;
    for (const LDrawTriangle& triangle : triangles)
    {
        const osg::Vec3 first = toModel(triangle.corners[0]);
        osg::Vec3 normal = (toModel(triangle.corners[1]) - first) ^ (toModel(triangle.corners[2]) - first);
        normal.normalize();
        const LDrawColors::Color color = colors.find(triangle.color).value_or(LDrawColors::UNKNOWN);
        for (const glm::dvec3& corner : triangle.corners)
        {
            vertices->push_back(toModel(corner));
            normals->push_back(normal);
            vertexColors->push_back({color[0], color[1], color[2], 255});
        }
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(vertexColors, osg::Array::BIND_PER_VERTEX);
    vertexColors->setNormalize(true);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
    // The winding of triangles in LDraw's files is not uniform.
    const osg::ref_ptr<osg::LightModel> light = new osg::LightModel;
    light->setTwoSided(true);
    geometry->getOrCreateStateSet()->setAttributeAndModes(light);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

} // namespace osgLego
