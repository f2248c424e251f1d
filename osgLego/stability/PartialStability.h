#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/stability/ForceCorridor.h>
#include <osgLego/stability/SpringBalance.h>
#include <osgLego/stability/WeightFlow.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace osgLego
{

class StabilityAnalysis;

/** Finds the parts that fall if only some of the parts of a model or submodel are in place.
 *
 * Simpler methods than the linear program prove that most partial models stand; the program is solved only for the
 * others. First it is solved for few rigid bodies, such as those that moved as one when parts fell before: if bodies
 * fall, so do parts. WeightFlow and SpringBalance add the weights of new parts to forces that are known, since the sum
 * of two equilibria is an equilibrium; SpringBalance does so in corridors first: parts near the new ones, and near
 * paths from them to the base. ForceCorridor solves the program for corridors, with known forces between all others,
 * and for all parts.
 *
 * One thread. */
class PartialStability
{
public:
    /** The most parts over all linear programs of all parts, and over all others, which bounds the time. */
    static constexpr std::size_t MOST_SOLVED = 120'000;

    /** How the parts are built. */
    struct Setting
    {
        bool isUpsideDown = false;
        BuildingBase base = BuildingBase::TABLE;
        std::function<bool()> isCancelled;
        std::size_t mostSolved = MOST_SOLVED;
    };

    /** @param model and graph must outlive this object.
     * @param parts those of the graph, in its order, as indices into BrickModel::getParts(). */
    PartialStability(const BrickModel& model, const std::vector<std::uint32_t>& parts, const JointGraph& graph,
                     Setting setting);
    ~PartialStability();

    /** @param isPlaced for each part of the graph.
     * @return parts that fall, as indices into the graph, perhaps not all; none if all stand; nothing if that is not
     * known: the simpler methods do not prove that the parts stand, and linear programs have had `mostSolved` parts or
     * more or can't be solved precisely enough, or it was cancelled. */
    std::optional<std::vector<std::uint32_t>> findFalling(const std::vector<bool>& isPlaced);

    /** The parts over all analyses of all parts in place, which come last: these nearly fall, or do. */
    std::size_t getNumHard() const { return _numHard; }

private:
    using PartList = std::vector<std::uint32_t>;

    std::optional<PartList> findFallingAgain(const std::vector<bool>& isPlaced);
    std::optional<PartList> findFallingNear(const std::vector<bool>& isPlaced);
    std::optional<PartList> findFallingBodies(const std::vector<bool>& isPlaced, PartList& bodies);
    std::optional<PartList> findAllFalling(const std::vector<bool>& isPlaced);
    std::vector<bool> findNear(PartList parts, const std::vector<bool>& isPlaced, int numJoints) const;
    PartList findPaths(const PartList& parts, const std::vector<bool>& isPlaced) const;
    PartList toAnalysis(std::span<const std::uint32_t> parts) const;
    PartList fromAnalysis(std::span<const std::uint32_t> parts) const;
    bool flows(const std::vector<bool>& isPlaced);
    bool isSprung(const std::vector<bool>& isPlaced);
    bool isBalancedNear(const std::vector<bool>& isPlaced, int numJoints);
    std::optional<std::vector<bool>> findCorridor(const BearingForces& start, const std::vector<bool>& isPlaced,
                                                  int numJoints) const;
    bool isBalancedAnew(const std::vector<bool>& isPlaced);
    bool keep(std::optional<BearingForces> forces);
    void createAnalysis();

    const BrickModel& _model;
    const JointGraph& _graph;
    PartList _parts;
    Setting _setting;
    std::size_t _numSolved = 0; // parts, over all linear programs of parts
    std::size_t _numHard = 0;   // over the analyses that come last
    std::size_t _numBodies = 0; // over all linear programs of bodies
    BearingJoints _joints;
    WeightFlow _flow;
    SpringBalance _springs;
    ForceCorridor _corridor;
    BearingForces _forces;                        // those that were found last
    std::vector<bool> _standing;                  // the parts that stood last
    PartList _falling;                            // those that fell last, and have not stood since
    PartList _bodies;                             // StabilityAnalysis::RigidBodies in which they fell
    std::unique_ptr<StabilityAnalysis> _analysis; // null until it is needed
    PartList _toAnalysis;                         // from indices into the graph to those of the analysis
    PartList _fromAnalysis;
};

} // namespace osgLego
