#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/Export.h>
#include <osgLego/Part.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/Referenced>
#include <osg/ref_ptr>

namespace osgLego
{

/** The six sides of a cell, as bits; Brick::openSides has the bit of each side whose neighbour is empty. */
enum BrickSide : std::uint8_t
{
    SIDE_LEFT = 1,    //!< towards -x
    SIDE_RIGHT = 2,   //!< towards +x
    SIDE_FRONT = 4,   //!< towards -y
    SIDE_BACK = 8,    //!< towards +y
    SIDE_BOTTOM = 16, //!< towards -z
    SIDE_TOP = 32     //!< towards +z
};

/** A covered cell: its position in the grid, its colour (red, green, blue), and its open sides (BrickSide bits). */
struct Brick
{
    std::array<std::uint16_t, 3> cell{};
    std::array<std::uint8_t, 3> color{};
    std::uint8_t openSides = 0;

    glm::ivec3 getCell() const { return {cell[0], cell[1], cell[2]}; }

    bool operator==(const Brick&) const = default;
};

/** The bricks of a mesh in main memory: every covered cell of its grid, visible or not.
 *
 * Each covered cell occurs once. The bricks are sorted by the number of their cell, x + width * (y + depth * z).
 *
 * The cells may be joined to parts, real bricks and plates; then every cell belongs to one part and has its colour.
 *
 * Usage:
 *
 *     osg::ref_ptr<const osgLego::BrickModel> model = osgLego::legolizeOnCpu(*node, settings);
 *     for (const osgLego::Brick& brick : model->getBricks()) ...
 *
 * Uses no GL. Immutable once created; every function may be called from any thread.
 */
class OSGLEGO_EXPORT BrickModel : public osg::Referenced
{
public:
    /** Create a model from covered cells in any order, each given once. Computes their `openSides`. */
    static osg::ref_ptr<const BrickModel> create(const BrickGrid& grid, std::vector<Brick> bricks);

    /** Create a model from covered cells that are already sorted and have their `openSides` set. */
    static osg::ref_ptr<const BrickModel> createComplete(const BrickGrid& grid, std::vector<Brick> bricks);

    /** Create a model from parts, in any order: each within the grid, and no two with a common cell.
     * @param covered the cells that a mesh covers, sorted as getBricks(), if parts have other cells too; see isAdded().
     */
    static osg::ref_ptr<const BrickModel> createOfParts(const BrickGrid& grid, std::vector<Part> parts,
                                                        const std::vector<Brick>& covered = {});

    const BrickGrid& getGrid() const { return _grid; }
    const std::vector<Brick>& getBricks() const { return _bricks; }
    /** Whether a brick is in a cell that the mesh does not cover: in the interior, in a join of two pieces, or in a
     * column that supports the model. False if that is not known, as for models that were read from files. @param brick
     * its index. */
    bool isAdded(std::size_t brick) const { return !_isAdded.empty() && _isAdded[brick]; }
    /** The number of bricks with at least one open side; only these are drawn. */
    std::size_t getNumVisible() const;
    /** The brick in a cell; null if the cell is empty or outside the grid. */
    const Brick* find(const glm::ivec3& cell) const;

    /** The parts, sorted by the number of their lowest cell; empty if the cells are not joined to parts. */
    const std::vector<Part>& getParts() const { return _parts; }
    /** For each brick, the index of its part; empty if there are no parts. */
    const std::vector<std::uint32_t>& getPartIndices() const { return _partIndices; }
    /** The part that covers a cell; null if there is none. */
    const Part* findPart(const glm::ivec3& cell) const;

private:
    BrickModel() = default;
    ~BrickModel() override = default;

    void findOpenSides();
    void findAdded(const std::vector<Brick>& covered);

    BrickGrid _grid;
    std::vector<Brick> _bricks;
    std::vector<Part> _parts;
    std::vector<std::uint32_t> _partIndices;
    std::vector<bool> _isAdded; // of each brick; empty if none is
};

} // namespace osgLego
