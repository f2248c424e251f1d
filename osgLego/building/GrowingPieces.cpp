#include <osgLego/building/GrowingPieces.h>

#include <algorithm>

namespace osgLego
{

GrowingPieces::GrowingPieces(const JointGraph& graph, const Symmetry& symmetry,
                             const std::vector<std::uint32_t>& ranks) :
    _graph(graph),
    _symmetry(symmetry), _ranks(ranks), _isPlaced(graph.getNumParts(), false), _pieces(graph.getNumParts())
{
    _sets.reset(graph.getNumParts());
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
        _pieces[part].isOnBase = graph.isOnBase(part);
}

void GrowingPieces::place(std::uint32_t part)
{
    _isPlaced[part] = true;
    for (const auto& joints : {_graph.getJointsBelow(part), _graph.getJointsAbove(part)})
        for (const PartLink& joint : joints)
            if (_isPlaced[joint.part]) join(part, joint.part);
    for (const PartLink& next : _graph.getNextAbove(part))
        if (isReady(next.part)) _joints.push_back(next.part);
    std::erase_if(_joints, [this](std::uint32_t joint) { return _isPlaced[joint] || !joinsPieces(joint); });
}

void GrowingPieces::join(std::uint32_t part, std::uint32_t other)
{
    const std::uint32_t a = find(part);
    const std::uint32_t b = find(other);
    if (a == b) return;
    _sets.join(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
    _pieces[find(a)] = {_pieces[a].numParts + _pieces[b].numParts, _pieces[a].isOnBase || _pieces[b].isOnBase};
}

std::uint32_t GrowingPieces::findLateJoint(std::uint32_t part)
{
    constexpr std::uint32_t SOON = 16; // parts: about two steps
    std::uint32_t first = NONE;
    for (const std::uint32_t joint : _joints)
        if (_ranks[joint] > _ranks[part] + SOON && (first == NONE || _ranks[joint] < _ranks[first]) &&
            joinsLargePieces(joint))
            first = joint;
    return first;
}

bool GrowingPieces::canBePlaced(std::uint32_t part) const
{
    const auto below = _graph.getNextBelow(part);
    return std::all_of(below.begin(), below.end(), [this](const PartLink& link) { return _isPlaced[link.part]; });
}

/** Whether a part and its twin can be placed. */
bool GrowingPieces::isReady(std::uint32_t part) const
{
    const std::uint32_t twin = findTwin(part);
    return canBePlaced(part) && (twin == NONE || canBePlaced(twin));
}

std::uint32_t GrowingPieces::findTwin(std::uint32_t part) const
{
    const std::uint32_t twin = _symmetry.getTwin(part);
    const bool isNext = twin != NONE && (_ranks[twin] == _ranks[part] + 1 || _ranks[part] == _ranks[twin] + 1);
    return isNext ? twin : NONE;
}

bool GrowingPieces::joinsPieces(std::uint32_t part)
{
    const auto joints = _graph.getJointsBelow(part);
    return std::any_of(joints.begin(), joints.end(),
                       [&](const PartLink& joint) { return find(joint.part) != find(joints.front().part); });
}

/** Whether a part joins two pieces on the base, each of several parts. */
bool GrowingPieces::joinsLargePieces(std::uint32_t part)
{
    constexpr std::size_t LARGE = 4; // parts
    std::uint32_t known = NONE;
    for (const PartLink& joint : _graph.getJointsBelow(part))
    {
        const std::uint32_t piece = find(joint.part);
        if (!_pieces[piece].isOnBase || _pieces[piece].numParts < LARGE) continue;
        if (known != NONE && known != piece) return true;
        known = piece;
    }
    return false;
}

} // namespace osgLego
