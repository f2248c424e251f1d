#pragma once

#include <osgLego/data/BuildingBox.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** Two parts, one above the other. */
struct PartLink
{
    std::uint32_t part = 0; //!< the other one
    int studs = 0;          //!< the columns that they share
};

/** The parts above and below each part: joined by studs, or farther away in the same column.
 *
 * Immutable once created; every function may be called from any thread. */
class JointGraph
{
public:
    /** @param boxes without common cells. */
    explicit JointGraph(std::vector<BuildingBox> boxes);

    std::size_t getNumParts() const { return _boxes.size(); }
    const std::vector<BuildingBox>& getBoxes() const { return _boxes; }
    const BuildingBox& getBox(std::uint32_t part) const { return _boxes[part]; }

    /** The parts whose studs hold a part from below. */
    std::span<const PartLink> getJointsBelow(std::uint32_t part) const { return _jointsBelow.get(part); }
    /** The parts on the studs of a part. */
    std::span<const PartLink> getJointsAbove(std::uint32_t part) const { return _jointsAbove.get(part); }
    /** For each column of a part, the next part above, whether it touches or not. */
    std::span<const PartLink> getNextAbove(std::uint32_t part) const { return _nextAbove.get(part); }
    std::span<const PartLink> getNextBelow(std::uint32_t part) const { return _nextBelow.get(part); }

    /** The lowest layer in which a part begins. */
    int getLowestLayer() const { return _lowestLayer; }
    bool isOnBase(std::uint32_t part) const { return _boxes[part].lower.z == _lowestLayer; }

private:
    /** For each part, a list of links. */
    class Lists
    {
    public:
        /** @param pairs from a part to another, sorted; repeated ones are counted. */
        void build(std::size_t numParts, const std::vector<std::uint64_t>& pairs);
        std::span<const PartLink> get(std::uint32_t part) const
        {
            return std::span(_links).subspan(_starts[part], _starts[part + 1] - _starts[part]);
        }

    private:
        std::vector<std::size_t> _starts;
        std::vector<PartLink> _links;
    };

    std::vector<BuildingBox> _boxes;
    Lists _jointsBelow;
    Lists _jointsAbove;
    Lists _nextAbove;
    Lists _nextBelow;
    int _lowestLayer = 0;
};

} // namespace osgLego
