#include "AssimpReader.h"

#include "AssimpFiles.h"
#include "AssimpGeometry.h"
#include "ImportObstacle.h"

#include <common/FiniteMatrix.h>
#include <common/UprightTurn.h>

#include <algorithm>
#include <cmath>
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

/** Whether a transform keeps all lengths. */
bool isRigid(const osg::Matrixd& matrix)
{
    constexpr double ROUNDING = 1e-6;
    const auto getRow = [&matrix](int row) { return osg::Vec3d(matrix(row, 0), matrix(row, 1), matrix(row, 2)); };
    for (int row = 0; row < 3; ++row)
        for (int other = row; other < 3; ++other)
            if (std::abs(getRow(row) * getRow(other) - (row == other ? 1.0 : 0.0)) > ROUNDING) return false;
    return true;
}

/** Creates the nodes of a scene. */
class NodeBuilder
{
public:
    NodeBuilder(const Geometries& geometries, const GltfInstances& instances) :
        _geometries(geometries), _instances(instances)
    {
    }

    osg::ref_ptr<osg::MatrixTransform> build(const aiNode& root)
    {
        if (_instances.hasOneRoot()) return createNode(root);
        osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform;
        addChildren(root, *node);
        return node;
    }

    const std::string& getError() const { return _error; }

private:
    osg::ref_ptr<osg::MatrixTransform> createNode(const aiNode& source)
    {
        osg::ref_ptr<osg::MatrixTransform> node = createTransform(toOsg(source.mTransformation), source);
        const std::vector<osg::Matrixd>* instances = _instances.find(_numNodes++);
        if (source.mNumMeshes > 0)
        {
            const osg::ref_ptr<osg::Geode> geode = createGeode(source);
            if (!instances) node->addChild(geode);
            for (std::size_t instance = 0; instances && instance < instances->size(); ++instance)
            {
                const osg::ref_ptr<osg::MatrixTransform> place = createTransform((*instances)[instance], source);
                place->addChild(geode);
                node->addChild(place);
            }
        }
        addChildren(source, *node);
        return node;
    }

    void addChildren(const aiNode& source, osg::Group& node)
    {
        for (unsigned int child = 0; child < source.mNumChildren; ++child)
            node.addChild(createNode(*source.mChildren[child]));
    }

    osg::ref_ptr<osg::MatrixTransform> createTransform(const osg::Matrixd& matrix, const aiNode& source)
    {
        osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(matrix);
        node->setName(source.mName.C_Str());
        // Lighting needs normals of length 1.
        if (!isRigid(matrix)) node->getOrCreateStateSet()->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
        if (!osgLego::isFinite(matrix) && _error.empty())
            _error = "the transform of the node '" + node->getName() +
                     "' is infinite or not a number; expected finite values";
        return node;
    }

    osg::ref_ptr<osg::Geode> createGeode(const aiNode& source) const
    {
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->setName(source.mName.C_Str());
        for (unsigned int mesh = 0; mesh < source.mNumMeshes; ++mesh)
            geode->addDrawable(_geometries.at(source.mMeshes[mesh]));
        return geode;
    }

    const Geometries& _geometries;
    const GltfInstances& _instances;
    std::size_t _numNodes = 0;
    std::string _error;
};

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
    const std::string format = osgDB::getLowerCaseFileExtension(path);
    error = findImportObstacle(format, file);
    if (!error.empty()) return nullptr;
    const aiScene* scene = _importer.ReadFile(path, STEPS);
    if (scene && format == "glb") error = readInstances(file);
    return error.empty() ? createScene(scene, error) : nullptr;
}

osg::ref_ptr<osg::Node> AssimpReader::readContent(const std::string& content, const std::string& extension,
                                                  std::string& error)
{
    const std::string format = extension.empty() ? findGltf(content) : extension;
    std::istringstream stream(content);
    error = findImportObstacle(format, stream);
    if (!error.empty()) return nullptr;
    const aiScene* scene = _importer.ReadFileFromMemory(content.data(), content.size(), STEPS, format.c_str());
    if (scene && format == "glb") error = readInstances(stream);
    return error.empty() ? createScene(scene, error) : nullptr;
}

std::string AssimpReader::readInstances(std::istream& stream)
{
    stream.clear();
    stream.seekg(0);
    return _instances.read(stream);
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
    NodeBuilder builder(geometries, _instances);
    const osg::ref_ptr<osg::MatrixTransform> root = builder.build(*scene->mRootNode);
    error = builder.getError();
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
