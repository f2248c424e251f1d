#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace osgLego::test
{

/** Builds a model by a plan, cell by cell, and counts the mistakes that would prevent building it by hand. */
class PlanCheck
{
public:
    PlanCheck(const BrickModel& model, const BuildingPlan& plan);

    /** Parts and submodels that nothing holds when they are placed, except those that the plan lists as such. */
    const std::vector<std::string>& getUnheld() const { return _unheld; }
    /** Parts and submodels that are placed below others, where they can't be reached from above, nor
     * from below. */
    const std::vector<std::string>& getUnreachable() const { return _unreachable; }
    /** Parts that are pressed on from below: nothing below them holds them. */
    std::size_t getNumPressedOn() const { return _numPressedOn; }
    /** Submodels that joints do not connect. */
    const std::vector<std::string>& getDisconnected() const { return _disconnected; }
    /** Steps of fewer than 5 parts, which neither attach a submodel nor are the last of their sequence. */
    const std::vector<std::string>& getShort() const { return _short; }
    /** Steps of more than 12 parts, a submodel counting as two, or without any. */
    const std::vector<std::string>& getLong() const { return _long; }

    /** All mistakes, one in each line; empty if there are none. */
    std::string toString() const;

private:
    using PartList = std::vector<std::uint32_t>;

    void checkSequence(const std::vector<BuildingStep>& steps, const std::string& name);
    PartList findInHand(std::span<const std::uint32_t> parts);
    void place(const PartList& parts, const std::string& name);
    bool isConnected(const PartList& parts) const;
    template <typename Visitor>
    void visitCells(std::uint32_t part, const Visitor& visit) const;
    std::size_t toIndex(const glm::ivec3& cell) const;
    bool isCovered(const glm::ivec3& cell) const;

    const BrickModel& _model;
    const BuildingPlan& _plan;
    int _up;
    int _way = 1;       // of building: 1 upwards, -1 if the sequence is built upside down
    int _baseLayer = 0; // of the sequence
    std::vector<bool> _isPlaced;
    std::size_t _numPressedOn = 0;
    std::vector<std::string> _unheld;
    std::vector<std::string> _unreachable;
    std::vector<std::string> _disconnected;
    std::vector<std::string> _short;
    std::vector<std::string> _long;
};

/** The parts of `all` alone, in the grid of the model. */
osg::ref_ptr<const BrickModel> selectParts(const BrickModel& model, const std::vector<std::uint32_t>& parts);

} // namespace osgLego::test
