#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

/** The tiles of a picture that may contain bricks, so that a pass over the picture can skip the others.
 *
 * Tiles are numbered from the lower left one to the right and up; the last ones of a row and of a column can extend
 * beyond the picture. Reuses its memory if it is used repeatedly. A plain value without GL; one thread at a time.
 */
class PictureTiles
{
public:
    static constexpr int SIDE = 16; //!< side of a tile, in pixels

    /** Start with no tiles in a picture of the given size in pixels. */
    void clear(const glm::ivec2& size);

    /** Add the tiles that intersect a rectangle: left, lower, right, upper, where the picture is from -1 to 1. */
    void add(const glm::vec4& area);

    /** Find the runs of consecutive tiles that were added. */
    void findRuns();

    int getNumAcross() const { return _count.x; }

    // The parameters of glMultiDrawArrays: the first tile of each run, and the number of tiles.
    const std::vector<int>& getFirsts() const { return _firsts; }
    const std::vector<int>& getCounts() const { return _counts; }

private:
    glm::ivec2 _size{0};
    glm::ivec2 _count{0};
    std::vector<std::uint8_t> _isUsed;
    std::vector<int> _firsts;
    std::vector<int> _counts;
};

} // namespace osgLego
