#include <osgLego/building/GrowingPieces.h>

#include <algorithm>
#include <utility>

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
    {
        if (!isReady(next.part)) continue;
        addJoint(next.part);
        if (const std::uint32_t twin = findTwin(next.part); twin != NONE) addJoint(twin);
    }
}

/** Remember a part that can be placed: if its pieces are large, as one that joins them, and otherwise with those of its
 * pieces that are not large yet. Adding it again does no harm. */
void GrowingPieces::addJoint(std::uint32_t part)
{
    if (joinsLargePieces(part)) _largeJoints.emplace(_ranks[part], part);
    for (const PartLink& joint : _graph.getJointsBelow(part))
        if (Piece& piece = _pieces[find(joint.part)]; !piece.isLarge()) piece.joints.push_back(part);
}

void GrowingPieces::join(std::uint32_t part, std::uint32_t other)
{
    std::uint32_t a = find(part);
    std::uint32_t b = find(other);
    if (a == b) return;
    if (_pieces[a].joints.size() < _pieces[b].joints.size()) std::swap(a, b);
    Piece joined = std::move(_pieces[a]);
    const Piece added = std::exchange(_pieces[b], {});
    joined.numParts += added.numParts;
    joined.isOnBase = joined.isOnBase || added.isOnBase;
    joined.joints.insert(joined.joints.end(), added.joints.begin(), added.joints.end());
    _sets.join(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
    Piece& piece = _pieces[find(a)] = std::move(joined);
    if (!piece.isLarge()) return;
    for (const std::uint32_t joint : std::exchange(piece.joints, {}))
        if (joinsLargePieces(joint)) _largeJoints.emplace(_ranks[joint], joint);
}

std::uint32_t GrowingPieces::findLateJoint(std::uint32_t part)
{
    constexpr std::uint32_t SOON = 16; // parts: about two steps
    auto joint = _largeJoints.lower_bound({_ranks[part] + SOON + 1, 0});
    // A part that no longer joins large pieces is added again when another of its pieces becomes large.
    while (joint != _largeJoints.end() && (_isPlaced[joint->second] || !joinsLargePieces(joint->second)))
        joint = _largeJoints.erase(joint);
    return joint == _largeJoints.end() ? NONE : joint->second;
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

bool GrowingPieces::joinsLargePieces(std::uint32_t part)
{
    std::uint32_t known = NONE;
    for (const PartLink& joint : _graph.getJointsBelow(part))
    {
        const std::uint32_t piece = find(joint.part);
        if (!_pieces[piece].isLarge()) continue;
        if (known != NONE && known != piece) return true;
        known = piece;
    }
    return false;
}

} // namespace osgLego
