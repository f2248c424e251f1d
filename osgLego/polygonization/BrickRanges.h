#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickBlock.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/Faces.h>
#include <osgLego/polygonization/PictureTiles.h>

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Finds the parts of a buffer with potentially visible bricks: blocks that intersect the picture and have an open side
 * that is drawn.
 *
 * Reuses its memory if it is used repeatedly. A plain value without GL; one thread at a time.
 */
class BrickRanges
{
public:
    /** The parameters of glMultiDrawArrays: the first brick of each range, and the number of bricks. */
    struct Parts
    {
        void clear();
        void add(const BrickBlock& block);

        std::vector<int> firsts;
        std::vector<int> counts;
    };

    /** Find the ranges, in the order of the buffer. Consecutive blocks are merged into one range, since each range
     * costs a draw.
     * @param numPlaced the number of parts in place, for the blocks of BuildingPoints; others ignore it. */
    void find(const std::vector<BrickBlock>& blocks, const BrickGrid& grid, const CellView& view, Faces faces,
              std::uint32_t numPlaced = std::numeric_limits<std::uint32_t>::max());

    /** Sort blocks from front to back, so that fewer hidden pixels are shaded. */
    void sortFrontToBack();

    const Parts& getAll() const { return _all; }

    // The ranges of blocks with potentially visible studs, and the other ranges, both in the order of the buffer.
    const Parts& getStudded() const { return _studded; }
    const Parts& getOthers() const { return _others; }

    /** Add all blocks to the tiles of a picture. */
    void addTo(PictureTiles& tiles, const BrickGrid& grid, const CellView& view) const;

private:
    struct Seen
    {
        float distance = 0.0f; // increases with the distance from the eye
        const BrickBlock* block = nullptr;
    };

    void fillAll();

    std::vector<Seen> _seen;
    Parts _all;
    Parts _studded;
    Parts _others;
};

} // namespace osgLego
