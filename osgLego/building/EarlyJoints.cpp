#include <osgLego/building/EarlyJoints.h>

#include <osgLego/building/GrowingPieces.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

/** Makes the order of joinEarly(). */
class EarlyJoints
{
public:
    EarlyJoints(const JointGraph& graph, const Symmetry& symmetry, const std::vector<std::uint32_t>& order) :
        _graph(graph), _ranks(order.size()), _pieces(graph, symmetry, _ranks)
    {
        for (std::uint32_t rank = 0; rank < order.size(); ++rank)
            _ranks[order[rank]] = rank;
        for (const std::uint32_t part : order)
        {
            place(part);
            joinPieces(part);
            std::erase_if(_loose, [this](std::uint32_t other) { return isJoined(other); });
            if (_loose.size() < MOST_LOOSE) continue;
            for (const std::uint32_t other : std::exchange(_loose, {}))
                if (!isJoined(other)) join(other);
        }
    }

    const std::vector<std::uint32_t>& getOrder() const { return _order; }

private:
    static constexpr std::uint32_t NONE = GrowingPieces::NONE;
    // A step of as many parts can be shown before others hide them.
    static constexpr std::size_t MOST_LOOSE = 5;

    /** Place a part, and the part that mirrors it if that was to follow and nothing is missing below it. */
    void place(std::uint32_t part)
    {
        if (_pieces.isPlaced(part)) return;
        _pieces.place(part);
        _order.push_back(part);
        if (_graph.isOnBase(part)) _loose.push_back(part);
        const std::uint32_t twin = _pieces.findTwin(part);
        if (twin != NONE && _pieces.canBePlaced(twin)) place(twin);
    }

    /** Place parts that join large pieces and would come long after a part. */
    void joinPieces(std::uint32_t part)
    {
        for (std::uint32_t joint = _pieces.findLateJoint(part); joint != NONE; joint = _pieces.findLateJoint(part))
            place(joint);
    }

    /** The parts below a part that are not placed, in their order. */
    std::vector<std::uint32_t> getMissing(std::uint32_t part) const
    {
        std::vector<std::uint32_t> missing;
        for (const PartLink& link : _graph.getNextBelow(part))
            if (!_pieces.isPlaced(link.part)) missing.push_back(link.part);
        std::sort(missing.begin(), missing.end(),
                  [this](std::uint32_t a, std::uint32_t b) { return _ranks[a] < _ranks[b]; });
        return missing;
    }

    bool isJoined(std::uint32_t part) const
    {
        const auto above = _graph.getJointsAbove(part);
        return std::any_of(above.begin(), above.end(),
                           [this](const PartLink& joint) { return _pieces.isPlaced(joint.part); });
    }

    /** Place a part that joins a loose part to others on the base, if there is one. */
    void join(std::uint32_t part)
    {
        std::uint32_t best = NONE;
        std::vector<std::uint32_t> fewest;
        for (const PartLink& joint : _graph.getJointsAbove(part))
        {
            const std::vector<std::uint32_t> missing = getMissing(joint.part);
            if (!joins(joint.part) || (best != NONE && missing.size() >= fewest.size())) continue;
            best = joint.part;
            fewest = missing;
        }
        if (best == NONE) return;
        for (const std::uint32_t other : fewest)
            place(other);
        place(best);
    }

    /** Whether a part joins several parts, all on the base, and is above no others. */
    bool joins(std::uint32_t part) const
    {
        const auto below = _graph.getNextBelow(part);
        return _graph.getJointsBelow(part).size() > 1 &&
               std::all_of(below.begin(), below.end(),
                           [this](const PartLink& link) { return _graph.isOnBase(link.part); });
    }

    const JointGraph& _graph;
    std::vector<std::uint32_t> _ranks;
    GrowingPieces _pieces;
    std::vector<std::uint32_t> _order;
    std::vector<std::uint32_t> _loose; // on the base
};

} // namespace

std::vector<std::uint32_t> joinEarly(const JointGraph& graph, const Symmetry& symmetry,
                                     const std::vector<std::uint32_t>& order)
{
    return EarlyJoints(graph, symmetry, order).getOrder();
}

} // namespace osgLego
