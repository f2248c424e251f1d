#pragma once

#include <osgLego/data/PassConstants.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgLego
{

/** The colour of a cell that several triangles cover. */
enum class CellColor
{
    MEAN,    //!< the mean of their colours, weighted by their areas in the cell
    DOMINANT //!< one of their colours (DominantColors), since a palette may lack a mixture of its colours
};

/** How well a colour stands for a mean, both 0 to 1 per channel: the distance between them, and a little more for
 * bright colours. The lower, the better. */
inline float dominanceScore(const glm::vec3& color, const glm::vec3& mean)
{
    const glm::vec3 bias(PassConstants::RED_BIAS, PassConstants::GREEN_BIAS, PassConstants::BLUE_BIAS);
    return glm::distance(color, mean) + glm::dot(color, bias);
}

/** The share of the distance from a cell's colour before that is added to a score: where two colours meet, the cell
 * changes to the other one when this covers 0.6 of the area, and back at 0.4, so that it does not flicker. */
constexpr float STICKINESS = 0.2f;

/** Chooses one colour for each cell out of those that triangles contribute to it: the colour nearest to their mean,
 * which is the one whose squared difference from the surface of the cell is least.
 *
 * Where two colours meet, it is the one with the larger area, however many triangles share it. Where a colour changes
 * gradually, it differs little from the mean. shaders/voxelization/dominant_color.frag states the same rule for the
 * GPU.
 *
 * Reusable. One thread at a time.
 */
class DominantColors
{
public:
    /** Add a colour, 0 to 1 per channel, that a triangle contributes to a cell. @param cell the number of its sum. */
    void add(std::size_t cell, const glm::vec3& color) { _pieces.push_back({color, static_cast<std::uint32_t>(cell)}); }

    /** The colour, 0 to 1 per channel, that a cell had before; none for a new cell. @param cell the number of its sum.
     */
    using FindPrevious = std::function<std::optional<glm::vec3>(std::size_t cell)>;

    /** Replace the sums of weighted colours, and of weights, by the chosen colours with a weight of 1, and start again
     * without colours. Sums to which no colour was added stay the same.
     * @param findPrevious called for cells with several colours; may be empty. */
    void choose(std::span<glm::vec4> sums, const FindPrevious& findPrevious = {});

private:
    struct Piece
    {
        glm::vec3 color;
        std::uint32_t cell;
    };

    void findPreviousColors(const FindPrevious& findPrevious);

    std::vector<Piece> _pieces;
    std::vector<glm::vec4> _chosen;   // the best colours so far, and their scores
    std::vector<glm::vec4> _previous; // the colours before, and 1, or 0 without
};

} // namespace osgLego
