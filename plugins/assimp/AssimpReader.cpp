#include "AssimpReader.h"

#include "AssimpFiles.h"
#include "AssimpGeometry.h"
#include "ImportObstacle.h"

#include <common/UprightTurn.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osgDB/FileNameUtils>

namespace
{

constexpr unsigned int STEPS =
    aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_TransformUVCoords;

using Geometries = std::vector<osg::ref_ptr<osg::Geometry>>; // of each mesh

Geometries createGeometries(const aiScene& scene, const AssimpMaterials& materials, std::string& error)
{
    Geometries geometries;
    for (unsigned int mesh = 0; mesh < scene.mNumMeshes && error.empty(); ++mesh)
        geometries.push_back(createAssimpGeometry(*scene.mMeshes[mesh], materials, error));
    return geometries;
}

/** The transform of a node, for row vectors. */
osg::Matrixd toOsg(const aiMatrix4x4& m)
{
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

osg::ref_ptr<osg::MatrixTransform> createNode(const aiNode& source, const Geometries& geometries, std::string& error)
{
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(toOsg(source.mTransformation));
    node->setName(source.mName.C_Str());
    if (!node->getMatrix().valid() && error.empty())
        error =
            "the transform of the node '" + node->getName() + "' is infinite or not a number; expected finite values";
    if (source.mNumMeshes > 0)
    {
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->setName(node->getName());
        for (unsigned int mesh = 0; mesh < source.mNumMeshes; ++mesh)
            geode->addDrawable(geometries.at(source.mMeshes[mesh]));
        node->addChild(geode);
    }
    for (unsigned int child = 0; child < source.mNumChildren; ++child)
        node->addChild(createNode(*source.mChildren[child], geometries, error));
    return node;
}

/** The extension of a file of glTF, which Assimp does not recognize by its first bytes; empty for other files. */
std::string findGltf(const std::string& content)
{
    if (content.starts_with("glTF")) return "glb";
    return content.starts_with("{") ? "gltf" : "";
}

bool hasWord(const std::string& text, const std::string& word)
{
    std::istringstream words(text);
    return std::find(std::istream_iterator<std::string>(words), {}, word) != std::istream_iterator<std::string>();
}

} // namespace

AssimpReader::AssimpReader(std::string name, const osgDB::Options& options) : _name(std::move(name)), _options(&options)
{
    _importer.SetIOHandler(new AssimpFiles(options)); // owned by the importer
}

osg::ref_ptr<osg::Node> AssimpReader::readFile(const std::string& path, std::string& error)
{
    std::ifstream file(path, std::ios::binary);
    error = findImportObstacle(osgDB::getLowerCaseFileExtension(path), file);
    if (!error.empty()) return nullptr;
    return createScene(_importer.ReadFile(path, STEPS), error);
}

osg::ref_ptr<osg::Node> AssimpReader::readContent(const std::string& content, const std::string& extension,
                                                  std::string& error)
{
    const std::string format = extension.empty() ? findGltf(content) : extension;
    std::istringstream stream(content);
    error = findImportObstacle(format, stream);
    if (!error.empty()) return nullptr;
    return createScene(_importer.ReadFileFromMemory(content.data(), content.size(), STEPS, format.c_str()), error);
}

osg::ref_ptr<osg::Node> AssimpReader::createScene(const aiScene* scene, std::string& error)
{
    if (!scene)
    {
        error = std::string("Assimp finds: ") + _importer.GetErrorString() + "; expected a valid, complete file";
        return nullptr;
    }
    if (!scene->mRootNode || scene->mNumMeshes == 0)
    {
        error = "it has no meshes; expected at least one";
        return nullptr;
    }
    AssimpTextures textures(*scene, _name, *_options);
    const AssimpMaterials materials(*scene, textures, isImporterOf("gltf"));
    const Geometries geometries = createGeometries(*scene, materials, error);
    if (!error.empty()) return nullptr;
    const osg::ref_ptr<osg::MatrixTransform> root = createNode(*scene->mRootNode, geometries, error);
    if (!error.empty()) return nullptr;
    if (isYUp(*scene) && !hasWord(_options->getOptionString(), "noRotation"))
        root->setMatrix(root->getMatrix() * osgLego::getUprightTurn());
    root->setName(_name);
    return root;
}

/** Whether the importer that has read the scene reads files of an extension. */
bool AssimpReader::isImporterOf(const std::string& extension) const
{
    const int index = _importer.GetPropertyInteger("importerIndex", -1);
    const aiImporterDesc* importer = index < 0 ? nullptr : _importer.GetImporterInfo(static_cast<std::size_t>(index));
    return importer && hasWord(importer->mFileExtensions, extension);
}

bool AssimpReader::isYUp(const aiScene& scene) const
{
    int axis = 1;
    if (scene.mMetaData && scene.mMetaData->Get("UpAxis", axis)) return axis == 1; // of files of FBX
    const std::span<const AssimpFormat> formats = getAssimpFormats();
    return std::none_of(formats.begin(), formats.end(),
                        [this](const AssimpFormat& format)
                        { return !format.isYUp && isImporterOf(std::string(format.extension)); });
}
