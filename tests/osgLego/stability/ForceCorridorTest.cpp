#include "BearingTests.h"
#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/PartType.h>
#include <osgLego/stability/ContactFinder.h>
#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/ForceCorridor.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
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
    CorridorTower(osg::ref_ptr<const BrickModel> model, BuildingBase base) :
        _model(std::move(model)), _base(base), _graph(createBuildingBoxes(*_model)),
        _joints(_graph, findMasses(*_model), base), _corridor(_joints, getCellPlates(_model->getGrid()), {}),
        _beside(findContacts(*_model))
    {
        std::erase_if(_beside, [](const Contact& contact) { return contact.kind == Contact::STUDS; });
    }

    void pressBeside() { _corridor.setBeside(_beside); }
    const std::vector<Contact>& getBeside() const { return _beside; }

    std::size_t getNumParts() const { return _model->getParts().size(); }
    const BearingJoints& getJoints() const { return _joints; }
    const ForceCorridor& getCorridor() const { return _corridor; }

    /** The parts from bottom to top. */
    std::vector<std::uint32_t> getOrder() const
    {
        std::vector<std::uint32_t> order(getNumParts());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [this](std::uint32_t a, std::uint32_t b)
                         { return _graph.getBox(a).lower.z < _graph.getBox(b).lower.z; });
        return order;
    }

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
    std::vector<Contact> _beside;
};

/** The largest force or torque that is missing at a part that does not stand on the base, in newtons and pitches. */
double findMissing(const CorridorTower& tower, const BearingForces& forces)
{
    const BearingJoints& joints = tower.getJoints();
    const JointGraph& graph = joints.getGraph();
    const auto scale = [&](const glm::ivec3& corner)
    { return Eigen::Vector3d(corner.x, corner.y, tower.getCellHeight() * corner.z); };
    const auto findMiddle = [&](std::uint32_t part, std::uint32_t other)
    {
        const BuildingBox& a = graph.getBox(part);
        const BuildingBox& b = graph.getBox(other);
        return Eigen::Vector3d(0.5 * (scale(glm::max(a.lower, b.lower)) + scale(glm::min(a.upper, b.upper))));
    };
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
            const Eigen::Vector3d middle = findMiddle(joint.lower, joint.upper);
            for (std::size_t point = joint.firstPoint; point < joint.endPoint; ++point)
                add({joints.getPoints()[point].x(), joints.getPoints()[point].y(), middle.z()},
                    {0.0, 0.0, sign * forces.pressures[point]});
            add(middle, {sign * forces.sideways[index].x(), sign * forces.sideways[index].y(), 0.0});
            torque.z() += sign * forces.sideways[index].z();
        }
        for (std::size_t index = 0; index < forces.beside.size(); ++index)
        {
            const Contact& contact = tower.getBeside()[index];
            if (contact.lower != part && contact.upper != part) continue;
            const std::uint32_t other = contact.upper == part ? contact.lower : contact.upper;
            const bool isGreater = box.lower[contact.kind] > graph.getBox(other).lower[contact.kind];
            const Wrench wrench = (isGreater ? 1.0 : -1.0) * forces.beside[index];
            add(findMiddle(contact.lower, contact.upper), wrench.head<3>());
            torque += wrench.tail<3>();
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
            const CorridorTower tower(createRandomTower(seed, 30), base);
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
                EXPECT_LE(findMissing(tower, forces), 1e-4) << seed << ", " << last;
                EXPECT_GE(*std::min_element(forces.pressures.begin(), forces.pressures.end()), -0.98);
            }
        }
        EXPECT_GT(numNarrow, 20);
        EXPECT_GT(numFalling, 5);
    }
}

TEST(ForceCorridor, WithPressureBesideEachOtherOnlyPartsThatStandByClpDoAndNearlyAllOfThem)
{
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
    {
        int numFalling = 0;
        int numNarrow = 0;
        int numStanding = 0;
        int numFound = 0;
        for (unsigned int seed = 1; seed <= 20; ++seed)
        {
            // Models with y upwards are mirrored in the graph.
            const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 30);
            CorridorTower tower(seed % 2 == 0 ? tilt(*model) : model, base);
            tower.pressBeside();
            BearingForces forces = createNoForces(tower.getJoints(), 0.0);
            const std::vector<std::uint32_t> order = tower.getOrder();
            for (std::size_t last = 0; last < order.size(); ++last)
            {
                if ((last + seed) % 6 == 0) continue; // a gap, over which parts fall
                std::vector<bool> isPlaced = forces.isPlaced;
                isPlaced[order[last]] = true;
                const bool stands = tower.standsByClp(isPlaced);
                numFalling += !stands;
                const std::vector<bool> isChosen = chooseInside(last, order.size());
                std::vector<bool> isInside(order.size());
                for (std::size_t place = 0; place < order.size(); ++place)
                    isInside[order[place]] = isChosen[place] && isPlaced[order[place]];
                const auto narrow = tower.getCorridor().add(forces, isPlaced, isInside);
                EXPECT_TRUE(stands || !narrow) << seed << ", " << last;
                EXPECT_LE(narrow ? findMissing(tower, *narrow) : 0.0, 1e-4) << seed << ", " << last;
                numNarrow += narrow.has_value();
                const auto whole = tower.getCorridor().add(createNoForces(tower.getJoints(), 0.0), isPlaced, isPlaced);
                EXPECT_TRUE(stands || !whole) << seed << ", " << last;
                numStanding += stands;
                numFound += whole.has_value();
                if (!whole) continue;
                EXPECT_LE(findMissing(tower, *whole), 1e-4) << seed << ", " << last;
                forces = last % 2 == 0 && narrow ? *narrow : *whole;
            }
        }
        EXPECT_GE(numFound, numStanding - 1); // one attempt of the solver may fail
        EXPECT_GT(numFalling, 5);
        EXPECT_GT(numNarrow, 20);
    }
}

TEST(ForceCorridor, BeamsThatPressEachOtherBearMore)
{
    // Two beams, each on a post at its outer end, that meet in the middle.
    const JointGraph graph({{{0, 0, 0}, {16, 2, 1}},
                            {{0, 0, 1}, {2, 2, 2}},
                            {{14, 0, 1}, {16, 2, 2}},
                            {{0, 0, 2}, {8, 2, 3}},
                            {{8, 0, 2}, {16, 2, 3}}});
    using Contacts = std::vector<Contact>;
    const auto bears = [&graph](double weight, const Contacts& beside)
    {
        const BearingJoints joints(graph, {10.0, 0.1, 0.1, weight, weight}, BuildingBase::TABLE);
        ForceCorridor corridor(joints, 3, {});
        corridor.setBeside(beside);
        const std::vector<bool> isPlaced(graph.getNumParts(), true);
        return corridor.add(createNoForces(joints), isPlaced, isPlaced).has_value();
    };
    EXPECT_TRUE(bears(2.5, {}));
    EXPECT_FALSE(bears(4.0, {}));
    EXPECT_TRUE(bears(4.0, {{3, 4, Contact::SIDE_X}}));
    EXPECT_TRUE(bears(4.0, {{4, 3, Contact::SIDE_X}}));
}

TEST(ForceCorridor, KnowsTheLoadsOnATable)
{
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
        const CorridorTower tower(createRandomTower(seed, 30), BuildingBase::TABLE);
        const std::vector<bool> isPlaced(tower.getNumParts(), true);
        const auto forces = tower.getCorridor().add(createNoForces(tower.getJoints(), 0.0), isPlaced, isPlaced);
        if (!forces) continue;
        VerticalLoad weights = VerticalLoad::Zero();
        VerticalLoad loads = VerticalLoad::Zero();
        for (std::uint32_t part = 0; part < tower.getNumParts(); ++part)
        {
            weights += tower.getJoints().getWeight(part);
            loads += forces->floorLoads[part];
            EXPECT_TRUE(!tower.getJoints().getGraph().isOnBase(part) ||
                        tower.getJoints().bears(part, forces->floorLoads[part], 0.0));
        }
        // Horizontal forces between parts do not change the sums over all parts.
        EXPECT_LE((weights - loads).lpNorm<Eigen::Infinity>(), 1e-3) << seed;
    }
}

} // namespace

} // namespace osgLego::test
