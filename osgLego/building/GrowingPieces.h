#pragma once

#include <osgLego/building/Symmetry.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/JointGraph.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace osgLego
{

/** The pieces of a model that grow while its parts are placed in some order, and the parts that could join them.
 *
 *     for (const std::uint32_t part : order)
 *     {
 *         pieces.place(part);
 *         const std::uint32_t joint = pieces.findLateJoint(part);
 *         if (joint != GrowingPieces::NONE) ... // place it now
 *     }
 *
 * One thread. */
class GrowingPieces
{
public:
    static constexpr std::uint32_t NONE = Symmetry::NONE;

    /** @param ranks the place of each part in the order. The arguments must outlive this object. */
    GrowingPieces(const JointGraph& graph, const Symmetry& symmetry, const std::vector<std::uint32_t>& ranks);

    bool isPlaced(std::uint32_t part) const { return _isPlaced[part]; }
    void place(std::uint32_t part);
    /** Whether all parts below a part are in place. */
    bool canBePlaced(std::uint32_t part) const;
    /** The part that mirrors a part, if they follow each other in the order; otherwise NONE. */
    std::uint32_t findTwin(std::uint32_t part) const;

    /** The first part that comes long after another one, but could be placed before it and join two large pieces that
     * stand on the base; NONE if there is none. Its twin can be placed then, too. */
    std::uint32_t findLateJoint(std::uint32_t part);

private:
    struct Piece
    {
        std::size_t numParts = 1;
        bool isOnBase = false;
        /** Parts that can be placed on the piece and others; empty for large pieces. */
        std::vector<std::uint32_t> joints = {};

        bool isLarge() const { return isOnBase && numParts >= LEAST_LARGE; }
    };

    static constexpr std::size_t LEAST_LARGE = 4; // parts

    void join(std::uint32_t part, std::uint32_t other);
    std::uint32_t find(std::uint32_t part)
    {
        return static_cast<std::uint32_t>(_sets.find(static_cast<std::int32_t>(part)));
    }
    bool isReady(std::uint32_t part) const;
    void addJoint(std::uint32_t part);
    bool joinsLargePieces(std::uint32_t part);

    const JointGraph& _graph;
    const Symmetry& _symmetry;
    const std::vector<std::uint32_t>& _ranks;
    std::vector<bool> _isPlaced;
    UnionFind _sets;
    std::vector<Piece> _pieces; // by their first part
    // Parts that joined large pieces when they were added, with their ranks. They may have been placed since, or their
    // pieces been joined.
    std::set<std::pair<std::uint32_t, std::uint32_t>> _largeJoints;
};

} // namespace osgLego
