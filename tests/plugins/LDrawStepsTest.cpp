#include <ldraw/LDrawSteps.h>

#include <osgLego/BuildingPlan.h>

#include <PartModels.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using StepLines = std::vector<std::string>;

/** A column of bricks with a plan. */
LDrawModel createModel(const osg::ref_ptr<const BuildingPlan>& plan)
{
    std::vector<Part> parts;
    for (std::size_t z = 0; z < plan->getRanks().size(); ++z)
        parts.push_back({{0, 0, static_cast<std::uint16_t>(z)}, {1, 1, 1}, {200, 30, 20}, 4});
    const auto bricks =
        BrickModel::createOfParts(createPartGrid({1, 1, static_cast<int>(parts.size())}, 1.2), std::move(parts));
    LDrawModel model;
    model.bricks = bricks;
    model.plan = plan;
    return model;
}

BuildingStep createStep(std::vector<std::uint32_t> parts, int turns = 0, bool isFromBelow = false)
{
    BuildingStep step;
    step.parts = std::move(parts);
    step.turns = turns;
    step.isFromBelow = isFromBelow;
    return step;
}

/** The ends of steps and the changes of views. */
StepLines getCommands(const std::string& text)
{
    StepLines commands;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("0 ")) commands.push_back(line.substr(2, line.size() - 3));
    return commands;
}

TEST(LDrawSteps, TheViewOfAFileDoesNotDependOnTheFileBefore)
{
    // Main steps that end with a turned view, an upright submodel, and two in a row that are upside down.
    BuildingStep last = createStep({1}, 1);
    last.submodels = {0, 1, 2};
    const LDrawModel model = createModel(BuildingPlan::create(
        5, {createStep({0}), last}, {{{createStep({2})}}, {{createStep({3}, 0, true)}}, {{createStep({4}, 0, true)}}}));
    LDrawSteps steps(model, "a");
    const auto commandsOf = [&steps](std::uint32_t submodel)
    {
        std::ostringstream stream;
        steps.writeSubmodel(stream, submodel);
        return getCommands(stream.str());
    };
    std::ostringstream main;
    steps.writeMain(main);
    EXPECT_EQ(getCommands(main.str()), (StepLines{"STEP", "ROTSTEP 0 90 0 REL", "STEP"}));
    EXPECT_EQ(commandsOf(0), StepLines{"STEP"});
    const StepLines upsideDown{"ROTSTEP 180 90 0 REL", "STEP"};
    EXPECT_EQ(commandsOf(1), upsideDown);
    EXPECT_EQ(commandsOf(2), upsideDown);
    EXPECT_EQ(commandsOf(0), StepLines{"STEP"});
}

/** The rotation of a model, in LDraw's axes (x to the right, y downwards, z away), about x and then y: by the
 * right-hand rule, as LDraw's extensions by MLCad define ROTSTEP. */
glm::dmat3 rotate(double degreesX, double degreesY)
{
    const double x = degreesX * std::numbers::pi / 180.0;
    const double y = degreesY * std::numbers::pi / 180.0;
    // Columns: the images of the axes.
    const glm::dmat3 aboutX({1, 0, 0}, {0, std::cos(x), std::sin(x)}, {0, -std::sin(x), std::cos(x)});
    const glm::dmat3 aboutY({std::cos(y), 0, -std::sin(y)}, {0, 1, 0}, {std::sin(y), 0, std::cos(y)});
    return aboutY * aboutX;
}

/** The direction from a model to the eye that looks at it after the last ROTSTEP of a text, in cells: x to the right, y
 * away and z upwards. */
glm::dvec3 findDirectionToEye(const std::string& text)
{
    double x = 0.0;
    double y = 0.0;
    for (const std::string& command : getCommands(text))
    {
        if (!command.starts_with("ROTSTEP")) continue;
        double z = 0.0;
        std::string name;
        std::string mode;
        std::istringstream stream(command);
        stream >> name >> x >> y >> z >> mode;
        EXPECT_EQ(z, 0.0);
        EXPECT_EQ(mode, "REL") << command;
    }
    // From the front right and above: 33 degrees from the front, and 30 above the horizon.
    const glm::dvec3 toEye(0.866025403784 * 0.544639035015, -0.5, -0.866025403784 * 0.838670567945);
    // The eye stays where it is, and the model turns: seen from the model, the eye turns by the inverse.
    const glm::dvec3 seen = glm::transpose(rotate(x, y)) * toEye;
    return {seen.x, seen.z, -seen.y};
}

TEST(LDrawSteps, RotationsShowTheSidesThatTheTurnsOfThePlanShow)
{
    // From above, a quarter counter-clockwise moves the eye from the front right to the right of the back.
    glm::dvec3 expected(0.866025403784 * 0.544639035015, -0.866025403784 * 0.838670567945, 0.5);
    for (const int turns : {0, 1, 2, 3})
    {
        const LDrawModel model = createModel(BuildingPlan::create(1, {createStep({0}, turns)}));
        std::ostringstream stream;
        LDrawSteps(model, "a").writeMain(stream);
        EXPECT_NEAR(glm::distance(findDirectionToEye(stream.str()), expected), 0.0, 1e-9) << stream.str();
        expected = {-expected.y, expected.x, expected.z};
    }
}

TEST(LDrawSteps, RotationsOfSubmodelsThatAreBuiltUpsideDownShowThemFromBelow)
{
    for (const int turns : {0, 1, 2, 3})
    {
        BuildingStep attached = createStep({0});
        attached.submodels = {0};
        const LDrawModel model = createModel(BuildingPlan::create(2, {attached}, {{{createStep({1}, turns, true)}}}));
        std::ostringstream stream;
        LDrawSteps(model, "a").writeSubmodel(stream, 0);
        const glm::dvec3 toEye = findDirectionToEye(stream.str());
        EXPECT_NEAR(toEye.z, -0.5, 1e-9) << stream.str();
        // The same side as upright, although the model is turned over.
        const glm::dvec3 upright = findDirectionToEye("0 ROTSTEP 0 " + std::to_string(90 * turns) + " 0 REL\r\n");
        EXPECT_GT(glm::dot(glm::normalize(glm::dvec2(toEye)), glm::normalize(glm::dvec2(upright))), 0.8) << turns;
    }
}

TEST(LDrawSteps, EveryStepThatChangesTheViewSaysSoOnce)
{
    const LDrawModel model =
        createModel(BuildingPlan::create(6, {createStep({0}, 2), createStep({1}, 2), createStep({2}, 3),
                                             createStep({3}, 1), createStep({4}, 0), createStep({5}, 0)}));
    std::ostringstream stream;
    LDrawSteps(model, "a").writeMain(stream);
    EXPECT_EQ(getCommands(stream.str()),
              (StepLines{"ROTSTEP 0 180 0 REL", "STEP", "STEP", "ROTSTEP 0 -90 0 REL", "STEP", "ROTSTEP 0 90 0 REL",
                         "STEP", "ROTSTEP END", "STEP", "STEP"}));
}

} // namespace

} // namespace osgLego::test
