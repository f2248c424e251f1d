#include "LDrawScene.h"

#include "LDrawFrame.h"

#include <common/PartsList.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLego/LegoNode.h>
#include <scene/VisibleLegoNodes.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

glm::dmat4 toGlm(const osg::Matrixd& matrix)
{
    return glm::make_mat4(
        matrix.ptr()); // rows that multiply vectors from the left are columns that do so from the right
}

std::string nameOf(const LegoNode& node)
{
    return node.getName().empty() ? "the model" : "'" + node.getName() + "'";
}

std::int32_t findCode(const Brick& brick, const Palette* palette)
{
    if (palette)
        for (const PaletteColor& color : palette->getColors())
            if (color.color == brick.color) return color.code;
    return Part::NO_CODE;
}

/** A model in which each cell is a separate part. */
osg::ref_ptr<const BrickModel> createOfCells(const BrickModel& model, const Palette* palette)
{
    std::vector<Part> parts;
    parts.reserve(model.getBricks().size());
    for (const Brick& brick : model.getBricks())
        parts.push_back({brick.cell, {1, 1, 1}, brick.color, findCode(brick, palette)});
    return BrickModel::createOfParts(model.getGrid(), std::move(parts));
}

/** Check that real parts have the shapes of a model's. @return one sentence; empty if they do. */
std::string findObstacle(const BrickModel& model, const std::string& name)
{
    if (getCellPlates(model.getGrid()) == 0)
        return name + " consists of cells that no real part has the shape of; expected proportions=brick or plate, or "
                      "parts=bricks";
    const auto isUnreal = [&model](const Part& part) { return !findPartType(part, model.getGrid()); };
    const auto unreal = std::find_if(model.getParts().begin(), model.getParts().end(), isUnreal);
    if (unreal == model.getParts().end()) return {};
    const glm::ivec3 size = unreal->getSize();
    return name + " has a part of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " x " +
           std::to_string(size.z) + " cells, which does not exist; expected sizes from 1x1 to 2x8";
}

/** The palette of a model. One that can't be read is a warning rather than an error: the colours of the bricks are
 * known without it. Only the codes of cells are lost, because parts store theirs. */
osg::ref_ptr<const Palette> readPalette(const LegoSettings& settings, bool hasParts, LDrawScene& scene)
{
    std::string error;
    osg::ref_ptr<const Palette> palette = Palette::read(settings, error);
    if (!error.empty())
        scene.warnings.push_back(error + (hasParts ? "; the built-in colours tell which parts were made"
                                                   : "; its colours are written directly, without codes"));
    return palette;
}

/** The plan of the node, or one made for it, with a warning if it is not known after which of its steps it stands. */
osg::ref_ptr<const BuildingPlan> createPlan(const LegoNode& node, const BrickModel& bricks, LDrawScene& scene)
{
    osg::ref_ptr<const BuildingPlan> plan = node.getBuildingPlan();
    if (plan && plan->getRanks().size() == bricks.getParts().size()) return plan;
    PlanningOptions options;
    options.checksStability = bricks.getParts().size() <= LDrawModel::MOST_CHECKED;
    plan = planBuilding(bricks, options);
    if (const std::size_t numUnchecked = plan->getNumUnchecked())
        scene.warnings.push_back(
            "it was not computed whether " + nameOf(node) + " stands after " + std::to_string(numUnchecked) +
            (numUnchecked == 1 ? " step" : " steps") + " of building" +
            (options.checksStability ? std::string()
                                     : "; expected at most " + std::to_string(LDrawModel::MOST_CHECKED) + " parts"));
    return plan;
}

bool createModel(const LegoNode& node, LDrawScene& scene, std::string& error)
{
    osg::ref_ptr<const BrickModel> bricks = node.getBricks();
    const std::string name = nameOf(node);
    if (!bricks || bricks->getBricks().empty())
    {
        error = name + " has no bricks";
        return false;
    }
    const LegoSettings settings = node.getSettings();
    LDrawModel model;
    model.name = osgDB::getSimpleFileName(node.getName());
    model.header = ModelHeader::find(node);
    model.settings = settings.toString();
    error = findObstacle(*bricks, name);
    if (!error.empty()) return false;
    model.palette = readPalette(settings, !bricks->getParts().empty(), scene);
    if (bricks->getParts().empty())
    {
        scene.warnings.push_back(name + " has cells instead of parts, and each of them is written as a part of 1 x 1; "
                                        "expected parts=bricks");
        bricks = createOfCells(*bricks, model.palette);
    }
    model.bricks = bricks;
    model.plan = createPlan(node, *bricks, scene);
    scene.models.push_back(model);
    return true;
}

LDrawTransform toTransform(const glm::dmat4& matrix)
{
    return {glm::dmat3(matrix), glm::dvec3(matrix[3])};
}

bool isUsable(const LDrawTransform& transform)
{
    constexpr double SMALLEST = 1e-9;
    double largest = 0.0;
    bool isFinite = true;
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < 3; ++row)
        {
            isFinite = isFinite && std::isfinite(transform.axes[axis][row]) && std::isfinite(transform.place[row]);
            largest = std::max(largest, std::abs(transform.axes[axis][row]));
        }
    return isFinite && std::abs(glm::determinant(transform.axes)) > SMALLEST * largest * largest * largest;
}

/** Whether studs have another distance than in the first model. */
bool isScaled(const LDrawTransform& transform)
{
    constexpr double TOLERANCE = 1e-3;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(glm::length(transform.axes[axis]) - 1.0) > TOLERANCE) return true;
    return false;
}

void addWarnings(LDrawScene& scene)
{
    PartsList list;
    for (const LDrawPlacement& placement : scene.placements)
    {
        const LDrawModel& model = scene.models[placement.model];
        list.add(*model.bricks, model.palette ? model.palette->getColors() : std::span<const PaletteColor>());
    }
    if (const std::string text = list.describeNeverMade(); !text.empty()) scene.warnings.push_back(text);
    const auto numScaled = std::count_if(scene.placements.begin(), scene.placements.end(),
                                         [](const LDrawPlacement& placement) { return isScaled(placement.transform); });
    if (numScaled > 0)
        scene.warnings.push_back(
            std::to_string(numScaled) +
            (numScaled == 1 ? " node has bricks of another size than" : " nodes have bricks of other sizes than") +
            " the first, which exist in one size only; expected equal cells, as with cell=");
}

} // namespace

bool LDrawScene::create(const osg::Node& node, LDrawScene& scene, std::string& error)
{
    std::vector<const LegoNode*> known;
    glm::dmat4 toFirst(1.0); // from world coordinates to those of the first model
    for (const PlacedLegoNode& found : findVisibleLegoNodes(node))
    {
        const auto place = std::find(known.begin(), known.end(), found.node);
        const auto index = static_cast<std::size_t>(place - known.begin());
        if (place == known.end())
        {
            if (!createModel(*found.node, scene, error)) return false;
            known.push_back(found.node);
        }
        const glm::dmat4 toWorld = toGlm(found.toWorld) * LDrawFrame(*scene.models[index].bricks).getModelTransform();
        if (scene.placements.empty()) toFirst = glm::inverse(toWorld);
        const LDrawTransform transform = scene.placements.empty() ? LDrawTransform() : toTransform(toFirst * toWorld);
        if (!isUsable(transform))
        {
            error = nameOf(*found.node) + " is below a transform without an inverse; expected one that keeps volumes";
            return false;
        }
        scene.placements.push_back({index, transform});
    }
    if (scene.placements.empty()) error = "there are no bricks in it; expected a LegoNode, as from MESH.legolize";
    addWarnings(scene);
    return error.empty();
}

} // namespace osgLego
