#pragma once

#include <osgLego/BrickModel.h>

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The parts of a model, or its cells if they are not joined to parts, in groups for instanced drawing: parts of one
 * shape, direction and colour in one block of the grid, so that renderers can cull blocks.
 *
 * One thread. */
class GltfBricks
{
public:
    /** The edge of a block, in cells. Smaller blocks would have few parts of a shape and a colour. */
    static constexpr int BLOCK = 64;

    /** Cells along the longer and the shorter horizontal side, and upwards. */
    struct Shape
    {
        int length = 1;
        int width = 1;
        int height = 1;

        auto operator<=>(const Shape&) const = default;
    };

    struct Key
    {
        std::array<int, 3> block{}; //!< its number along each axis
        Shape shape;
        bool isTurned = false;               //!< whether the longer side is along the second horizontal axis
        std::array<std::uint8_t, 3> color{}; //!< 0 if colours are those of instances

        auto operator<=>(const Key&) const = default;
    };

    struct Instance
    {
        glm::dvec3 place{0.0}; //!< the centre of the lower side, in cells from the centre of the block
        std::array<std::uint8_t, 3> color{};
    };

    /** Group the parts of a model. @param mostColors if there are more, each group has parts of all colours. */
    GltfBricks(const BrickModel& model, std::size_t mostColors);

    const std::map<Key, std::vector<Instance>>& getGroups() const { return _groups; }
    bool hasColorsOfInstances() const { return _hasColorsOfInstances; }
    std::size_t getNumColors() const { return _numColors; }

    /** The centre of a block, in cells. */
    static glm::dvec3 getCenter(const std::array<int, 3>& block);

private:
    void add(const Part& part, const BrickGrid& grid);

    std::map<Key, std::vector<Instance>> _groups;
    std::size_t _numColors = 0;
    bool _hasColorsOfInstances = false;
};

} // namespace osgLego
