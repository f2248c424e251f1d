#pragma once

#include <common/JsonValue.h>

#include <cstddef>
#include <istream>
#include <map>
#include <string>
#include <vector>

#include <osg/Matrixd>

/** The instances of the nodes of a .glb file by the extension EXT_mesh_gpu_instancing, which Assimp 5.2 ignores. Their
 * colours are ignored. One thread. */
class GltfInstances
{
public:
    /** Read a file that Assimp has accepted. @return one sentence on failure, or nothing, also without instances. */
    std::string read(std::istream& stream);

    /** Whether there is one root: only then, Assimp adds none of its own. */
    bool hasOneRoot() const { return _hasOneRoot; }
    /** The transforms of the instances of a node; null if it has none.
     * @param number of nodes before it, depth first. */
    const std::vector<osg::Matrixd>* find(std::size_t number) const;

private:
    void visit(const osgLego::JsonValue& number);
    std::vector<osg::Matrixd> createTransforms(const osgLego::JsonValue& attributes) const;
    std::vector<float> readFloats(const osgLego::JsonValue& number, std::size_t channels) const;

    osgLego::JsonValue _json;
    std::string _buffer;
    std::map<std::size_t, std::vector<osg::Matrixd>> _instances;
    std::size_t _numNodes = 0;
    bool _hasOneRoot = true;
};
