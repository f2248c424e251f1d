#pragma once

#include <osgLego/BrickBlock.h>
#include <osgLego/BrickGrid.h>
#include <osgLego/CellView.h>
#include <osgLego/Export.h>

#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Which parts of a buffer hold bricks that a view may show: blocks that reach into the picture and have an open side
 * that is turned towards the eye.
 *
 * Used again and again it allocates no memory. A plain value without GL; one thread at a time.
 */
class OSGLEGO_EXPORT BrickRanges
{
public:
    /** In the order of the buffer, blocks that follow each other in one range, as each range costs a draw of its own.
     * @param showsInsides whether sides that are turned away from the eye are seen, too. */
    void find(const std::vector<BrickBlock>& blocks, const BrickGrid& grid, const CellView& view, bool showsInsides);

    /** Put the nearest blocks first, for renderers that shade what they see before it is hidden. */
    void sortFrontToBack();

    // What was found, as glMultiDrawArrays takes it: the first brick of each range, and how many there are.
    const std::vector<int>& getFirsts() const { return _firsts; }
    const std::vector<int>& getCounts() const { return _counts; }

private:
    struct Seen
    {
        float distance = 0.0f; // grows with the way from the eye
        const BrickBlock* block = nullptr;
    };

    void fill();

    std::vector<Seen> _seen;
    std::vector<int> _firsts;
    std::vector<int> _counts;
};

} // namespace osgLego
