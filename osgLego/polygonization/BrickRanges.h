#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/data/BrickBlock.h>
#include <osgLego/polygonization/CellView.h>
#include <osgLego/polygonization/PictureTiles.h>

#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Which parts of a buffer hold bricks that a view may show: blocks that reach into the picture and have an open side
 * that is turned towards the eye.
 *
 * Used again and again it allocates no memory. A plain value without GL; one thread at a time.
 */
class BrickRanges
{
public:
    /** As glMultiDrawArrays takes them: the first brick of each range, and how many there are. */
    struct Parts
    {
        void clear();
        void add(const BrickBlock& block);

        std::vector<int> firsts;
        std::vector<int> counts;
    };

    /** In the order of the buffer, blocks that follow each other in one range, as each range costs a draw of its own.
     * @param showsInsides whether sides that are turned away from the eye are seen, too. */
    void find(const std::vector<BrickBlock>& blocks, const BrickGrid& grid, const CellView& view, bool showsInsides);

    /** Put the nearest blocks first, for renderers that shade what they see before it is hidden. */
    void sortFrontToBack();

    const Parts& getAll() const { return _all; }

    // Of all, those whose bricks have studs that may be seen, and the others; in the order of the buffer.
    const Parts& getStudded() const { return _studded; }
    const Parts& getOthers() const { return _others; }

    /** Add all of them to the tiles of a picture. */
    void addTo(PictureTiles& tiles, const BrickGrid& grid, const CellView& view) const;

private:
    struct Seen
    {
        float distance = 0.0f; // grows with the way from the eye
        const BrickBlock* block = nullptr;
    };

    void fillAll();

    std::vector<Seen> _seen;
    Parts _all;
    Parts _studded;
    Parts _others;
};

} // namespace osgLego
