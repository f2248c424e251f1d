#include "BrickTowers.h"

#include <osgLego/stability/EquilibriumSearch.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

std::vector<std::uint32_t> listAll(std::size_t count)
{
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

/** The contacts of a model that stands on a table. */
std::vector<Contact> findAllContacts(const BrickModel& model)
{
    std::vector<Contact> contacts = findContacts(model);
    for (std::uint32_t part = 0; part < model.getParts().size(); ++part)
        if (model.getParts()[part].cell[2] == 0) contacts.push_back({Contact::BASE, part, Contact::TABLE});
    return contacts;
}

TEST(EquilibriumSearch, KnowsWhatIsMissingWhateverTheStrengthOfJoints)
{
    int numLacking = 0;
    for (unsigned int seed = 21; seed <= 40; ++seed)
    {
        const osg::ref_ptr<const BrickModel> tower = createRandomTower(seed, 4 + static_cast<int>(seed));
        const std::vector<PartBox> boxes = findPartBoxes(*tower);
        EquilibriumSearch search(boxes, listAll(boxes.size()), findAllContacts(*tower), {});
        const EquilibriumProgram& program = search.getProgram();
        double previous = 1e9;
        for (const double capacity : {0.001, 0.01, 0.05, 0.98})
        {
            const Equilibrium found = *search.find(capacity, {});
            EXPECT_TRUE(found.hasConverged) << seed << ", " << capacity;
            Eigen::VectorXd rows;
            program.multiply(found.forces.matrix(), rows);
            EXPECT_LT((rows + found.residuals.matrix() - program.getLoad()).lpNorm<Eigen::Infinity>(), 1e-7)
                << seed << ", " << capacity;
            const double missing = found.residuals.abs().sum();
            EXPECT_LT(missing, previous + 1e-6) << seed << ", " << capacity;
            previous = missing;
            numLacking += !EquilibriumSearch::isComplete(found);
        }
    }
    EXPECT_GT(numLacking, 10);
    EXPECT_LT(numLacking, 80);
}

} // namespace

} // namespace osgLego::test
