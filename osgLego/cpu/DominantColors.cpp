#include <osgLego/cpu/DominantColors.h>

#include <limits>

namespace osgLego
{

void DominantColors::choose(std::span<glm::vec4> sums)
{
    if (_pieces.empty()) return;
    _chosen.resize(sums.size());
    for (const Piece& piece : _pieces)
        _chosen[piece.cell].a = std::numeric_limits<float>::max();
    for (const Piece& piece : _pieces)
    {
        const glm::vec4& sum = sums[piece.cell];
        const float score = dominanceScore(piece.color, glm::vec3(sum) / sum.a);
        glm::vec4& chosen = _chosen[piece.cell];
        if (score < chosen.a) chosen = glm::vec4(piece.color, score);
    }
    for (const Piece& piece : _pieces)
        sums[piece.cell] = glm::vec4(glm::vec3(_chosen[piece.cell]), 1.0f);
    _pieces.clear();
}

} // namespace osgLego
