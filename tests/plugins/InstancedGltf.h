#pragma once

#include <common/JsonValue.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <osg/BoundingBox>
#include <osg/Matrixd>
#include <osg/Vec3>

namespace osgLego::test
{

/** A .glb file with the extension EXT_mesh_gpu_instancing, read by the rules of glTF. */
class InstancedGltf
{
public:
    /** A box in the coordinates of OpenSceneGraph, with Z upwards, and its colour in sRGB. */
    struct Box
    {
        osg::BoundingBoxd bounds;
        std::array<int, 3> color{};
        std::int64_t node = 0;
    };

    explicit InstancedGltf(const std::string& bytes);

    const JsonValue& getJson() const { return _json; }
    /** The bounds of each instance of a mesh. */
    const std::vector<Box>& getBoxes() const { return _boxes; }
    std::vector<osg::Vec3> getVectors(const JsonValue& accessor) const;
    std::vector<unsigned int> getIndices(const JsonValue& accessor) const;
    /** A column of the file, such as "meshes". */
    const std::vector<JsonValue>& getAll(const std::string& kind) const { return _json[kind].getElements(); }

private:
    std::size_t findData(const JsonValue& accessor) const;
    void visit(std::int64_t node, const osg::Matrixd& parent);
    void addInstances(std::int64_t number, const osg::Matrixd& toWorld);

    JsonValue _json;
    std::string _buffer;
    std::vector<Box> _boxes;
};

} // namespace osgLego::test
