#pragma once

#include "GltfBricks.h"
#include "GltfBuffer.h"

#include <scene/VisibleLegoNodes.h>

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace osgLego
{

/** Writes the bricks of a scene's visible LegoNodes as binary glTF 2.0 with the extension EXT_mesh_gpu_instancing: the
 * triangles of each shape of parts once, and a node with the places of all parts of one shape, direction and colour in
 * one block of the grid. Other geometry is left out.
 *
 * A unit of the scene is a metre, glTF's unit. The scene has Z upwards, and the file Y, as glTF requires. Colours are
 * materials of plastic. A model with more than MOST_MATERIALS colours has one white material, and the colours are the
 * attribute _COLOR_0 of the instances.
 *
 * Usage:
 *
 *     GltfWriter writer;
 *     std::string error;
 *     if (writer.add(scene, error)) error = writer.write(stream);
 *
 * One thread. */
class GltfWriter
{
public:
    /** More would be slow to draw, since each needs draw calls of its own. */
    static constexpr std::size_t MOST_MATERIALS = 1024;

    /** Add the bricks of a scene. @return false, with one sentence in `error`, if there are none, or if glTF can't
     * represent the transforms above them. */
    bool add(const osg::Node& scene, std::string& error);

    /** For each loss, one sentence. */
    const std::vector<std::string>& getWarnings() const { return _warnings; }

    /** @return one sentence on failure, or nothing. */
    std::string write(std::ostream& stream) const;

private:
    using Color = std::array<std::uint8_t, 3>;

    bool addPlacement(const PlacedLegoNode& placed, std::string& error);
    void addModel(const LegoNode& node, std::string& error);
    JsonValue createNode(const BrickGrid& grid, const GltfBricks::Key& key, bool hasColors,
                         const std::vector<GltfBricks::Instance>& instances, std::string& error);
    /** The triangles of a shape, without a material. */
    JsonValue addPrimitive(const GltfBricks::Shape& shape, const BrickGrid& grid, std::string& error);
    std::int64_t addMesh(const GltfBricks::Shape& shape, const Color& color, const BrickGrid& grid, std::string& error);
    std::int64_t addMaterial(const Color& color);
    std::int64_t addNode(JsonValue node);
    JsonValue toJson() const;

    GltfBuffer _buffer;
    std::vector<JsonValue> _nodes;
    std::vector<JsonValue> _meshes;
    std::vector<JsonValue> _materials;
    JsonValue _placements = JsonValue::createArray();
    std::map<const LegoNode*, std::vector<JsonValue>> _models;                // the nodes of each model
    std::map<GltfBricks::Shape, JsonValue> _primitives;                       // of the model that is being added
    std::map<std::pair<GltfBricks::Shape, Color>, std::int64_t> _meshNumbers; // likewise
    std::map<Color, std::int64_t> _materialNumbers;
    std::vector<std::string> _warnings;
};

} // namespace osgLego
