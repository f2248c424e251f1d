#include <osgLego/cpu/DominantColors.h>

#include <limits>

namespace osgLego
{

void DominantColors::choose(std::span<glm::vec4> sums, const FindPrevious& findPrevious)
{
    if (_pieces.empty()) return;
    _chosen.resize(sums.size());
    for (const Piece& piece : _pieces)
        _chosen[piece.cell] = glm::vec4(piece.color, std::numeric_limits<float>::max());
    if (findPrevious) findPreviousColors(findPrevious);
    for (const Piece& piece : _pieces)
    {
        const glm::vec4& sum = sums[piece.cell];
        float score = dominanceScore(piece.color, glm::vec3(sum) / sum.a);
        if (findPrevious)
        {
            const glm::vec4& previous = _previous[piece.cell];
            score += STICKINESS * previous.a * glm::distance(piece.color, glm::vec3(previous));
        }
        glm::vec4& chosen = _chosen[piece.cell];
        if (score < chosen.a) chosen = glm::vec4(piece.color, score);
    }
    for (const Piece& piece : _pieces)
        sums[piece.cell] = glm::vec4(glm::vec3(_chosen[piece.cell]), 1.0f);
    _pieces.clear();
}

/** Find the colours that cells with several ones had before. Each chosen colour is that of the cell's last piece. */
void DominantColors::findPreviousColors(const FindPrevious& findPrevious)
{
    constexpr float UNKNOWN = -1.0f;
    _previous.resize(_chosen.size());
    for (const Piece& piece : _pieces)
        _previous[piece.cell] = glm::vec4(0.0f, 0.0f, 0.0f, UNKNOWN);
    for (const Piece& piece : _pieces)
    {
        glm::vec4& previous = _previous[piece.cell];
        if (previous.a != UNKNOWN || piece.color == glm::vec3(_chosen[piece.cell])) continue;
        const std::optional<glm::vec3> found = findPrevious(piece.cell);
        previous = found ? glm::vec4(*found, 1.0f) : glm::vec4(0.0f);
    }
    for (const Piece& piece : _pieces)
        if (_previous[piece.cell].a == UNKNOWN) _previous[piece.cell].a = 0.0f;
}

} // namespace osgLego
