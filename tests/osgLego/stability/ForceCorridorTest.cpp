#include "BearingTests.h"
#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/PartType.h>
#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/ForceCorridor.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A random tower, built part by part. */
class CorridorTower
{
public:
    CorridorTower(unsigned int seed, BuildingBase base) :
        _model(createRandomTower(seed, 30)), _base(base), _graph(createBuildingBoxes(*_model)),
        _joints(_graph, findMasses(*_model), base), _corridor(_joints, getCellPlates(_model->getGrid()), {})
    {
    }

    std::size_t getNumParts() const { return _model->getParts().size(); }
    const BearingJoints& getJoints() const { return _joints; }
    const ForceCorridor& getCorridor() const { return _corridor; }

    double getCellHeight() const { return 0.4 * getCellPlates(_model->getGrid()); } // pitches

    bool standsByClp(const std::vector<bool>& isPlaced) const
    {
        std::vector<Part> placed;
        for (std::size_t part = 0; part < isPlaced.size(); ++part)
            if (isPlaced[part]) placed.push_back(_model->getParts()[part]);
        const std::optional<double> tension =
            computePlainTension(*BrickModel::createOfParts(_model->getGrid(), std::move(placed)), _base);
        return tension && *tension <= 0.98;
    }

private:
    static std::vector<double> findMasses(const BrickModel& model)
    {
        std::vector<double> weights;
        for (const Part& part : model.getParts())
            weights.push_back(EquilibriumProgram::NEWTONS_PER_GRAM * findPartType(part, model.getGrid())->mass);
        return weights;
    }

    osg::ref_ptr<const BrickModel> _model;
    BuildingBase _base;
    JointGraph _graph;
    BearingJoints _joints;
    ForceCorridor _corridor;
};

/** The largest force or torque that is missing at a part that does not stand on the base, in newtons and pitches. */
double findMissing(const BearingJoints& joints, double cellHeight, const BearingForces& forces)
{
    const JointGraph& graph = joints.getGraph();
    const auto scale = [&](const glm::ivec3& corner)
    { return Eigen::Vector3d(corner.x, corner.y, cellHeight * corner.z); };
    double most = 0.0;
    for (std::uint32_t part = 0; part < graph.getNumParts(); ++part)
    {
        if (!forces.isPlaced[part] || graph.isOnBase(part)) continue;
        Eigen::Vector3d force = Eigen::Vector3d::Zero();
        Eigen::Vector3d torque = Eigen::Vector3d::Zero(); // about the origin
        const auto add = [&](const Eigen::Vector3d& place, const Eigen::Vector3d& push)
        {
            force += push;
            torque += place.cross(push);
        };
        const BuildingBox& box = graph.getBox(part);
        add(0.5 * (scale(box.lower) + scale(box.upper)), {0.0, 0.0, -joints.getWeight(part)[0]});
        for (const std::uint32_t index : joints.getJointsOf(part))
        {
            const BearingJoints::Joint& joint = joints.getJoints()[index];
            const double sign = joint.upper == part ? 1.0 : -1.0;
            const BuildingBox& lower = graph.getBox(joint.lower);
            const BuildingBox& upper = graph.getBox(joint.upper);
            const Eigen::Vector3d middle =
                0.5 * (scale(glm::max(lower.lower, upper.lower)) + scale(glm::min(lower.upper, upper.upper)));
            for (std::size_t point = joint.firstPoint; point < joint.endPoint; ++point)
                add({joints.getPoints()[point].x(), joints.getPoints()[point].y(), middle.z()},
                    {0.0, 0.0, sign * forces.pressures[point]});
            add(middle, {sign * forces.sideways[index].x(), sign * forces.sideways[index].y(), 0.0});
            torque.z() += sign * forces.sideways[index].z();
        }
        most = std::max({most, force.lpNorm<Eigen::Infinity>(), torque.lpNorm<Eigen::Infinity>()});
    }
    return most;
}

/** Parts whose indices are near the last one, and every third of the others. */
std::vector<bool> chooseInside(std::size_t last, std::size_t numParts)
{
    std::vector<bool> isInside(numParts, false);
    for (std::size_t part = 0; part <= last; ++part)
        isInside[part] = part + 10 > last || part % 3 == 0;
    return isInside;
}

TEST(ForceCorridor, PartsThatItAddsOneAfterTheOtherStandByClp)
{
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
    {
        int numNarrow = 0;
        int numFalling = 0;
        for (unsigned int seed = 1; seed <= 20; ++seed)
        {
            const CorridorTower tower(seed, base);
            BearingForces forces = createNoForces(tower.getJoints(), 0.0);
            for (std::size_t last = 0; last < tower.getNumParts(); ++last)
            {
                if ((last + seed) % 6 == 0) continue; // a gap, over which parts fall
                std::vector<bool> isPlaced = forces.isPlaced;
                isPlaced[last] = true;
                std::vector<bool> isInside = chooseInside(last, tower.getNumParts());
                std::transform(isInside.begin(), isInside.end(), isPlaced.begin(), isInside.begin(),
                               [](bool inside, bool placed) { return inside && placed; });
                const bool stands = tower.standsByClp(isPlaced);
                std::optional<BearingForces> found = tower.getCorridor().add(forces, isPlaced, isInside);
                EXPECT_TRUE(stands || !found) << seed << ", " << last;
                numNarrow += found && isInside != isPlaced;
                numFalling += !stands;
                if (!found) found = tower.getCorridor().add(forces, isPlaced, isPlaced);
                EXPECT_TRUE(stands || !found) << seed << ", " << last;
                if (!found) continue;
                forces = std::move(*found);
                EXPECT_LE(findMissing(tower.getJoints(), tower.getCellHeight(), forces), 1e-4) << seed << ", " << last;
                EXPECT_GE(*std::min_element(forces.pressures.begin(), forces.pressures.end()), -0.98);
            }
        }
        EXPECT_GT(numNarrow, 20);
        EXPECT_GT(numFalling, 5);
    }
}

} // namespace

} // namespace osgLego::test
