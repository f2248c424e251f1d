#pragma once

#include "AssimpFormats.h"
#include "GltfInstances.h"

#include <istream>
#include <string>

#include <assimp/Importer.hpp>
#include <osg/Node>
#include <osg/ref_ptr>
#include <osgDB/Options>

/** Reads one model through Assimp: the hierarchy of nodes with their transforms, meshes and materials. Animations,
 * skins, cameras and lights are ignored: skinned meshes have the pose in which they are stored.
 *
 * Usage:
 *
 *     AssimpReader reader("duck.glb", *options);
 *     osg::ref_ptr<osg::Node> node = reader.readFile(path, error);
 *
 * One thread; read once.
 */
class AssimpReader
{
public:
    /** @param name for messages. @param options for other files, with the folder of the model as the first of their
     * database path; the word `noRotation` keeps a model with Y upwards from being turned upright. */
    AssimpReader(std::string name, const osgDB::Options& options);

    /** @return null, with one sentence in `error`, if the file can't be read or has no meshes. */
    osg::ref_ptr<osg::Node> readFile(const std::string& path, std::string& error);

    /** Read a model from the content of a file.
     * @param extension of its format; if it is empty, Assimp finds the format by the first bytes. */
    osg::ref_ptr<osg::Node> readContent(const std::string& content, const std::string& extension, std::string& error);

private:
    std::string readInstances(std::istream& stream);
    osg::ref_ptr<osg::Node> createScene(const aiScene* scene, std::string& error);
    bool isImporterOf(const std::string& extension) const;
    bool isYUp(const aiScene& scene) const;

    std::string _name;
    osg::ref_ptr<const osgDB::Options> _options;
    GltfInstances _instances;
    Assimp::Importer _importer;
};
