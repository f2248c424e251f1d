#pragma once

#include <osgLego/data/CellKeys.h>
#include <osgLego/layout/LayoutProblem.h>
#include <osgLego/model/CellExposure.h>
#include <osgLego/model/Join.h>
#include <osgLego/model/PieceMap.h>
#include <osgLego/model/RecoloringCosts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Finds the cheapest way to join a piece to another one, by Dijkstra's algorithm.
 *
 * A path leads from a cell of the piece through empty cells to a cell of another piece. Two cells above each other are
 * always connected. Two cells beside each other are connected if a part covers both, so they need a common colour, and
 * a path can't turn within a layer. Only a part that covers all cells of a piece joins one without cells above each
 * other to a cell beside it. An empty cell costs HIDDEN, and up to EXPOSED more if it can be seen. A covered cell at
 * either end may get another colour instead.
 *
 * The arguments must exist as long as this object; joins may be added to the map between searches. One thread. */
class JoinSearch
{
public:
    static constexpr double HIDDEN = 1.0;      //!< the cost of an empty cell
    static constexpr double EXPOSED = 6.0;     //!< the additional cost of one with CellExposure 1
    static constexpr double BESIDE = 0.25;     //!< the cost of a step sideways, which needs a certain part
    static constexpr double RECOLORING = 0.25; //!< the cost of another colour, and
    static constexpr double DIFFERENCE = 0.04; //!< of each unit of CIEDE2000 by which the cell then differs more
    static constexpr double LIMIT = 24.0;      //!< the cost of the most expensive join

    /** Additional costs of cells near joins that failed. */
    struct Penalties
    {
        std::unordered_map<CellKey, double> changes;     //!< of covering an empty cell, or changing a covered one
        std::unordered_map<CellKey, double> directSteps; //!< from a covered cell to the next piece, without a change

        bool isEmpty() const { return changes.empty() && directSteps.empty(); }
    };

    JoinSearch(PieceMap& map, const CellExposure& exposure, const RecoloringCosts& costs, const Penalties& penalties) :
        _map(map), _exposure(exposure), _costs(costs), _penalties(penalties)
    {
    }

    /** @param piece a result of PieceMap::getUnion().
     * @return the cheapest join of a piece; nothing if there is none up to LIMIT. */
    std::optional<Join> find(std::uint32_t piece);

private:
    /** A cell that a path has reached: an empty one, which the path covers with a part of some colour. */
    struct State
    {
        CellKey cell = 0;
        std::uint16_t color = LayoutCell::ANY_COLOR;
        std::uint8_t axis = NO_AXIS; //!< of the steps within its layer

        auto operator<=>(const State&) const = default;
    };
    struct Reached
    {
        double cost = 0.0;
        State before;
        bool isFirst = true; //!< whether there is no state before
        bool isDone = false;
        glm::ivec3 begin{0};
        std::optional<Join::Change> recolored; //!< at the beginning
    };
    struct Open
    {
        double cost = 0.0;
        State state;

        bool operator<(const Open& other) const { return cost != other.cost ? cost > other.cost : state > other.state; }
    };

    static constexpr std::uint8_t NO_AXIS = 2;

    void begin(const glm::ivec3& cell);
    void continueFrom(const State& state);
    void reach(const State& state, Reached reached);
    void finish(const Reached& last, const State* state, const glm::ivec3& end, std::optional<Join::Change> recolored,
                double cost);
    void joinBeside(const glm::ivec3& cell, const glm::ivec3& other);
    void recolor(const Reached& last, const State* state, const glm::ivec3& cell, std::uint16_t color, double cost);

    double getCost(const glm::ivec3& cell);
    double getPenaltyOfChange(const glm::ivec3& cell) const;
    double getPenaltyOfDirectStep(const glm::ivec3& cell) const;
    double getRecoloringCost(const glm::ivec3& cell, std::uint16_t color) const;
    bool mayBeRecolored(const glm::ivec3& cell);
    bool isInColumn(const glm::ivec3& cell) const;
    bool mayExtend(std::uint32_t piece, std::size_t axis);
    bool isOfOther(const glm::ivec3& cell);

    PieceMap& _map;
    const CellExposure& _exposure;
    const RecoloringCosts& _costs;
    const Penalties& _penalties;
    std::unordered_map<CellKey, double> _cellCosts;
    std::unordered_map<std::uint32_t, std::array<bool, 2>> _extensible; //!< by piece and axis, during one find()

    std::uint32_t _piece = 0;
    std::map<State, Reached> _reached;
    std::vector<Open> _open;
    std::optional<Join> _best;
};

} // namespace osgLego
