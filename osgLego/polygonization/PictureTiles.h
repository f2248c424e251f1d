#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

/** Which squares of a picture something may lie in, so that a pass over the picture leaves out the others.
 *
 * Squares are numbered from the lower left one to the right and up; the last ones of a row and of a column reach over
 * the picture's edge. Used again and again it allocates no memory. A plain value without GL; one thread at a time.
 */
class PictureTiles
{
public:
    static constexpr int SIDE = 16; //!< of a tile, in pixels

    /** Begin anew, with nothing in a picture of a size in pixels. */
    void clear(const glm::ivec2& size);

    /** Add all that lies in a part of the picture: left, lower, right, upper, from -1 to 1. */
    void add(const glm::vec4& area);

    /** Find the runs of tiles that something lies in. */
    void findRuns();

    int getNumAcross() const { return _count.x; }

    // As glMultiDrawArrays takes them: the first tile of each run, and how many there are.
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
