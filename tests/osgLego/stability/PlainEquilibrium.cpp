#include "PlainEquilibrium.h"

#include <osgLego/PartType.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Clp_C_Interface.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace osgLego::test
{

namespace
{

constexpr double UNLIMITED = 1e300;

struct Box
{
    glm::dvec3 low, high; // in pitches
    double weight;
    double addedWeight = 0.0; // at the middle of its top
};

/** A linear program of forces at points. */
class Program
{
public:
    explicit Program(std::vector<Box> boxes) : _boxes(std::move(boxes)) {}

    /** Add a force on one box, and its opposite on another; -1 is the base. */
    void addForce(int upper, int lower, const glm::dvec3& point, const glm::dvec3& force, bool isDrag = false)
    {
        _starts.push_back(static_cast<CoinBigIndex>(_values.size()));
        for (const auto& [box, sign] : {std::pair(upper, 1.0), std::pair(lower, -1.0)})
        {
            if (box < 0) continue;
            const glm::dvec3 torque = glm::cross(point, force);
            const std::array<double, 6> values{force.x, force.y, force.z, torque.x, torque.y, torque.z};
            for (int row = 0; row < 6; ++row)
                addValue(6 * box + row, sign * values[static_cast<std::size_t>(row)]);
        }
        if (isDrag) addValue(6 * static_cast<int>(_boxes.size()) + _numDrags++, 1.0);
    }

    /** @param gravity the direction of weights, of length 1. */
    std::optional<double> minimizeTension(const glm::dvec3& gravity)
    {
        const auto numEquations = 6 * static_cast<int>(_boxes.size());
        _starts.push_back(static_cast<CoinBigIndex>(_values.size()));
        for (int drag = 0; drag < _numDrags; ++drag)
            addValue(numEquations + drag, -1.0);
        _starts.push_back(static_cast<CoinBigIndex>(_values.size()));
        std::vector<double> low(static_cast<std::size_t>(numEquations), 0.0);
        for (std::size_t box = 0; box < _boxes.size(); ++box)
        {
            const glm::dvec3 center = 0.5 * (_boxes[box].low + _boxes[box].high);
            const glm::dvec3 top(center.x, center.y, _boxes[box].high.z);
            const glm::dvec3 force = -(_boxes[box].weight + _boxes[box].addedWeight) * gravity;
            const glm::dvec3 torque =
                glm::cross(center, -_boxes[box].weight * gravity) + glm::cross(top, -_boxes[box].addedWeight * gravity);
            for (int axis = 0; axis < 3; ++axis)
            {
                low[6 * box + static_cast<std::size_t>(axis)] = force[axis];
                low[6 * box + static_cast<std::size_t>(3 + axis)] = torque[axis];
            }
        }
        std::vector<double> high = low;
        low.resize(low.size() + static_cast<std::size_t>(_numDrags), -UNLIMITED);
        high.resize(low.size(), 0.0);
        const auto numColumns = static_cast<int>(_starts.size()) - 1;
        std::vector<double> costs(static_cast<std::size_t>(numColumns), 0.0);
        costs.back() = 1.0;
        Clp_Simplex* clp = Clp_newModel();
        Clp_setLogLevel(clp, 0);
        Clp_loadProblem(clp, numColumns, static_cast<int>(low.size()), _starts.data(), _rows.data(), _values.data(),
                        nullptr, nullptr, costs.data(), low.data(), high.data());
        Clp_setPrimalTolerance(clp, 1e-9);
        Clp_setDualTolerance(clp, 1e-9);
        Clp_dual(clp, 0);
        std::optional<double> tension;
        if (Clp_status(clp) == 0) tension = Clp_objectiveValue(clp);
        Clp_deleteModel(clp);
        return tension;
    }

private:
    void addValue(int row, double value)
    {
        if (value == 0.0) return;
        _rows.push_back(row);
        _values.push_back(value);
    }

    std::vector<Box> _boxes;
    int _numDrags = 0;
    std::vector<CoinBigIndex> _starts;
    std::vector<int> _rows;
    std::vector<double> _values;
};

std::vector<Box> findBoxes(const BrickModel& model)
{
    const bool isUpright = model.getGrid().upAxis == UpAxis::Z;
    const double height = model.getGrid().cellSize[isUpright ? 2 : 1] / model.getGrid().cellSize.x;
    std::vector<Box> boxes;
    for (const Part& part : model.getParts())
    {
        const auto toPitches = [&](const glm::ivec3& cell) {
            return isUpright ? glm::dvec3(cell.x, cell.y, height * cell.z)
                             : glm::dvec3(cell.x, cell.z, height * cell.y);
        };
        boxes.push_back({toPitches(part.getCell()), toPitches(part.getCell() + part.getSize()),
                         9.8e-3 * findPartType(part, model.getGrid())->mass});
    }
    return boxes;
}

/** The contact points at a stud, relative to it, under a part of the given size whose centre is at `center`. */
std::vector<glm::dvec2> findPoints(const glm::dvec2& size, const glm::dvec2& center)
{
    if (std::min(size.x, size.y) == 1.0) return {{0.25, 0.0}, {-0.25, 0.0}, {0.0, 0.25}, {0.0, -0.25}};
    const glm::dvec2 out(center.x < 0.0 ? 1.0 : -1.0, center.y < 0.0 ? 1.0 : -1.0);
    if (size.x == size.y) return {{0.25 * out.x, 0.0}, {0.0, 0.25 * out.y}, {-0.125 * out.x, -0.125 * out.y}};
    if (size.x < size.y) return {{0.25 * out.x, 0.0}, {-0.125 * out.x, 0.125}, {-0.125 * out.x, -0.125}};
    return {{0.0, 0.25 * out.y}, {0.125, -0.125 * out.y}, {-0.125, -0.125 * out.y}};
}

/** @param isRough whether the friction of one contact point holds against turning. */
void addStud(Program& program, int upper, int lower, const glm::dvec3& stud, const Box& part, bool isRough)
{
    const glm::dvec3 size = part.high - part.low;
    const glm::dvec3 center = 0.5 * (part.low + part.high) - stud;
    for (const glm::dvec2& point : findPoints({std::round(size.x), std::round(size.y)}, {center.x, center.y}))
    {
        const glm::dvec3 place = stud + glm::dvec3(point, 0.0);
        program.addForce(upper, lower, place, {0, 0, 1});
        program.addForce(upper, lower, place, {0, 0, -1}, true);
    }
    for (const glm::dvec3& side :
         {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)})
        program.addForce(upper, lower, stud, side);
    for (const double side : {1.0, -1.0})
        if (isRough) program.addForce(upper, lower, stud + glm::dvec3(0.25, 0.0, 0.0), {0.0, side, 0.0}, true);
}

/** Add the forces between two parts, if they touch and the second one is above or beyond the first. */
void addContact(Program& program, const std::vector<Box>& boxes, int lower, int upper, bool isRough)
{
    const Box& a = boxes[static_cast<std::size_t>(lower)];
    const Box& b = boxes[static_cast<std::size_t>(upper)];
    const glm::dvec3 low = glm::max(a.low, b.low);
    const glm::dvec3 high = glm::min(a.high, b.high);
    for (int axis = 0; axis < 3; ++axis)
    {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        if (std::abs(a.high[axis] - b.low[axis]) > 1e-9 || high[u] - low[u] < 1e-9 || high[v] - low[v] < 1e-9) continue;
        if (axis == 2)
        {
            for (double y = low.y + 0.5; y < high.y; y += 1.0)
                for (double x = low.x + 0.5; x < high.x; x += 1.0)
                    addStud(program, upper, lower, {x, y, b.low.z}, b, isRough);
            continue;
        }
        for (int corner = 0; corner < 4; ++corner)
        {
            glm::dvec3 point(b.low);
            point[u] = corner & 1 ? low[u] : high[u];
            point[v] = corner & 2 ? low[v] : high[v];
            glm::dvec3 force(0.0);
            force[axis] = 1.0;
            program.addForce(upper, lower, point, force);
        }
    }
}

/** @param isRough whether a table holds sideways, and studs against turning. */
void addBase(Program& program, const Box& box, int index, BuildingBase base, bool isRough)
{
    if (base == BuildingBase::PLATE)
    {
        for (double y = box.low.y + 0.5; y < box.high.y; y += 1.0)
            for (double x = box.low.x + 0.5; x < box.high.x; x += 1.0)
                addStud(program, index, -1, {x, y, box.low.z}, box, isRough);
        return;
    }
    for (const double x : {box.low.x, box.high.x})
        for (const double y : {box.low.y, box.high.y})
        {
            program.addForce(index, -1, {x, y, box.low.z}, {0, 0, 1});
            if (!isRough) continue;
            for (const double side : {-2.0, 2.0})
            {
                program.addForce(index, -1, {x, y, box.low.z}, {side, 0, 1});
                program.addForce(index, -1, {x, y, box.low.z}, {0, side, 1});
            }
        }
}

std::optional<double> minimizeTension(const BrickModel& model, BuildingBase base,
                                      const std::vector<AddedWeight>& weights, const glm::dvec3& gravity, bool isRough)
{
    std::vector<Box> boxes = findBoxes(model);
    for (const AddedWeight& weight : weights)
        boxes[weight.part].addedWeight += 9.8e-3 * weight.grams;
    Program program(boxes);
    double bottom = boxes.front().low.z;
    for (const Box& box : boxes)
        bottom = std::min(bottom, box.low.z);
    for (int upper = 0; upper < static_cast<int>(boxes.size()); ++upper)
    {
        const Box& box = boxes[static_cast<std::size_t>(upper)];
        if (box.low.z < bottom + 1e-9) addBase(program, box, upper, base, isRough);
        for (int lower = 0; lower < static_cast<int>(boxes.size()); ++lower)
            if (lower != upper) addContact(program, boxes, lower, upper, isRough);
    }
    return program.minimizeTension(gravity);
}

} // namespace

std::optional<double> computePlainTension(const BrickModel& model, BuildingBase base,
                                          const std::vector<AddedWeight>& weights)
{
    return minimizeTension(model, base, weights, {0, 0, -1}, false);
}

double computePlainTilt(const BrickModel& model, BuildingBase base, const glm::ivec2& direction,
                        const std::vector<AddedWeight>& weights)
{
    const auto stands = [&](double tangent)
    {
        const glm::dvec3 gravity = glm::normalize(glm::dvec3(tangent * glm::dvec2(direction), -1.0));
        const std::optional<double> tension = minimizeTension(model, base, weights, gravity, true);
        return tension && *tension <= StabilityReport::CAPACITY;
    };
    if (stands(1.0)) return 1.0;
    double least = 0.0;
    double most = 1.0;
    while (most - least > 1e-5)
    {
        const double middle = 0.5 * (least + most);
        (stands(middle) ? least : most) = middle;
    }
    return least;
}

} // namespace osgLego::test
