#include "AssimpGeometry.h"

#include <cmath>

#include <osgUtil/SmoothingVisitor>

namespace
{

bool isFinite(const aiVector3D& vector)
{
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

std::string findObstacle(const aiMesh& mesh)
{
    const std::string name = "the mesh '" + std::string(mesh.mName.C_Str()) + "' ";
    for (unsigned int vertex = 0; vertex < mesh.mNumVertices; ++vertex)
        if (!isFinite(mesh.mVertices[vertex]))
            return name + "has a vertex that is infinite or not a number; expected finite coordinates";
    for (unsigned int face = 0; face < mesh.mNumFaces; ++face)
        for (unsigned int corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner)
            if (const unsigned int index = mesh.mFaces[face].mIndices[corner]; index >= mesh.mNumVertices)
                return name + "refers to vertex " + std::to_string(index) + "; expected an index below " +
                       std::to_string(mesh.mNumVertices);
    return {};
}

osg::ref_ptr<osg::Vec3Array> copyVectors(const aiVector3D* vectors, unsigned int count, const osg::Vec3& replacement)
{
    osg::ref_ptr<osg::Vec3Array> copy = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    copy->reserve(count);
    for (unsigned int index = 0; index < count; ++index)
    {
        const aiVector3D& vector = vectors[index];
        copy->push_back(isFinite(vector) ? osg::Vec3(vector.x, vector.y, vector.z) : replacement);
    }
    return copy;
}

osg::ref_ptr<osg::Vec2Array> copyCoordinates(const aiVector3D* coordinates, unsigned int count)
{
    osg::ref_ptr<osg::Vec2Array> copy = new osg::Vec2Array(osg::Array::BIND_PER_VERTEX);
    copy->reserve(count);
    for (unsigned int index = 0; index < count; ++index)
    {
        const aiVector3D& coordinate = coordinates[index];
        copy->push_back(isFinite(coordinate) ? osg::Vec2(coordinate.x, coordinate.y) : osg::Vec2());
    }
    return copy;
}

osg::ref_ptr<osg::Vec4Array> createColors(const aiMesh& mesh, const AssimpMaterials& materials)
{
    const osg::Vec4 base = materials.get(mesh.mMaterialIndex).color;
    if (!mesh.HasVertexColors(0)) return new osg::Vec4Array(osg::Array::BIND_OVERALL, 1, &base);
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_PER_VERTEX);
    colors->reserve(mesh.mNumVertices);
    for (unsigned int vertex = 0; vertex < mesh.mNumVertices; ++vertex)
        colors->push_back(osg::componentMultiply(materials.toDisplay(mesh.mColors[0][vertex]), base));
    return colors;
}

/** @param mesh whose faces all have as many corners as the first. */
osg::ref_ptr<osg::DrawElementsUInt> createElements(const aiMesh& mesh)
{
    const unsigned int corners = mesh.mFaces[0].mNumIndices;
    const GLenum mode = corners == 1 ? GL_POINTS : corners == 2 ? GL_LINES : GL_TRIANGLES;
    osg::ref_ptr<osg::DrawElementsUInt> elements = new osg::DrawElementsUInt(mode);
    elements->reserveElements(mesh.mNumFaces * corners);
    for (unsigned int face = 0; face < mesh.mNumFaces; ++face)
        for (unsigned int corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner)
            elements->push_back(mesh.mFaces[face].mIndices[corner]);
    return elements;
}

} // namespace

osg::ref_ptr<osg::Geometry> createAssimpGeometry(const aiMesh& mesh, const AssimpMaterials& materials,
                                                 std::string& error)
{
    error = findObstacle(mesh);
    if (!error.empty()) return nullptr;
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName(mesh.mName.C_Str());
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(copyVectors(mesh.mVertices, mesh.mNumVertices, {}));
    geometry->setColorArray(createColors(mesh, materials));
    const AssimpMaterials::Material& material = materials.get(mesh.mMaterialIndex);
    if (mesh.HasTextureCoords(material.textureChannel))
        geometry->setTexCoordArray(0, copyCoordinates(mesh.mTextureCoords[material.textureChannel], mesh.mNumVertices));
    geometry->setStateSet(material.state);
    geometry->addPrimitiveSet(createElements(mesh));
    if (mesh.HasNormals())
        geometry->setNormalArray(copyVectors(mesh.mNormals, mesh.mNumVertices, osg::Z_AXIS));
    else if (mesh.mFaces[0].mNumIndices == 3)
        osgUtil::SmoothingVisitor::smooth(*geometry, 0.0); // no angle is smooth
    return geometry;
}
