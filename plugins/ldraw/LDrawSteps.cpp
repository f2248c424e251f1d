#include "LDrawSteps.h"

#include "LDrawColors.h"
#include "LDrawText.h"

#include <common/BasePlate.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace osgLego
{

namespace
{

void append(std::string& line, double number)
{
    // Far below the precision of real parts, and above the rounding errors of transforms.
    constexpr double STEPS = 1e9;
    number = std::round(number * STEPS) / STEPS;
    if (number == 0.0) number = 0.0; // without a sign
    std::array<char, 64> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    line.append(text.data(), result.ptr);
    line += ' ';
}

std::string formatColor(const Part& part)
{
    if (part.colorCode != Part::NO_CODE) return std::to_string(part.colorCode);
    std::array<char, 16> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), LDrawColors::toDirect(part.color), 16);
    return "0x" + std::string(text.data(), result.ptr);
}

LDrawTransform moveTo(const glm::dvec3& place)
{
    LDrawTransform transform;
    transform.place = place;
    return transform;
}

} // namespace

void writeReference(std::ostream& stream, const std::string& color, const LDrawTransform& transform,
                    std::string_view name)
{
    std::string line = "1 " + color + " ";
    for (int axis = 0; axis < 3; ++axis)
        append(line, transform.place[axis]);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            append(line, transform.axes[column][row]);
    stream << line << name << LDRAW_END_OF_LINE;
}

LDrawSteps::LDrawSteps(const LDrawModel& model, std::string stem, bool isOnPlate) :
    _model(model), _stem(std::move(stem)), _isOnPlate(isOnPlate), _frame(*model.bricks)
{
    const std::vector<Submodel>& submodels = model.plan->getSubmodels();
    _depths.assign(submodels.size(), 0);
    for (std::uint32_t index = 0; index < submodels.size(); ++index)
        findDepth(index);
    _numbers.assign(submodels.size(), 0);
    for (std::uint32_t index = 0; index < submodels.size(); ++index)
        if (isFile(index))
        {
            _submodels.push_back(index);
            _numbers[index] = static_cast<std::uint32_t>(_submodels.size());
        }
    findOrigins();
}

/** Submodels may come before those that they contain. */
std::size_t LDrawSteps::findDepth(std::uint32_t submodel)
{
    std::size_t& depth = _depths[submodel];
    if (depth > 0) return depth;
    std::size_t deepest = 0;
    for (const BuildingStep& step : _model.plan->getSubmodels()[submodel].steps)
        for (const std::uint32_t inner : step.submodels)
            deepest = std::max(deepest, findDepth(inner));
    return depth = deepest + 1;
}

void LDrawSteps::findOrigins()
{
    for (const Submodel& submodel : _model.plan->getSubmodels())
    {
        std::vector<std::uint32_t> parts;
        for (const BuildingStep& step : submodel.steps)
            for (const std::uint32_t part : _model.plan->getPlacedParts(step))
                parts.push_back(part);
        _origins.push_back(_frame.getBottomCenter(parts));
    }
}

std::string LDrawSteps::getName(std::uint32_t submodel) const
{
    return _stem + "-sub-" + std::to_string(_numbers[submodel]) + ".ldr";
}

void LDrawSteps::writeParts(std::ostream& stream, const LDrawTransform& transform)
{
    writeBasePlate(stream, transform);
    std::size_t numWritten = 0;
    const std::vector<BuildingStep>& steps = _model.plan->getSteps();
    for (std::size_t index = 0; index < steps.size(); ++index)
    {
        for (; numWritten < _model.plan->getNumPlaced(index); ++numWritten)
            writePart(stream, _model.plan->getOrder()[numWritten], transform);
        endStep(stream, steps[index]);
    }
}

void LDrawSteps::writeMain(std::ostream& stream)
{
    writeBasePlate(stream, {});
    writeSteps(stream, _model.plan->getSteps(), glm::dvec3(0.0));
}

void LDrawSteps::writeSubmodel(std::ostream& stream, std::uint32_t submodel)
{
    writeSteps(stream, _model.plan->getSubmodels()[submodel].steps, _origins[submodel]);
}

void LDrawSteps::writeBasePlate(std::ostream& stream, const LDrawTransform& transform) const
{
    if (!_isOnPlate) return;
    const BasePlate plates(*_model.bricks);
    const std::string color = std::to_string(BasePlate::COLOR_CODE);
    for (const LDrawTransform& place : _frame.getTransforms(plates))
        writeReference(stream, color, transform * place, toPartFile(plates.getNumber()));
}

void LDrawSteps::writeSteps(std::ostream& stream, const std::vector<BuildingStep>& steps, const glm::dvec3& origin)
{
    _view = {};
    for (const BuildingStep& step : steps)
    {
        writeContent(stream, step, origin);
        endStep(stream, step);
    }
}

void LDrawSteps::writeContent(std::ostream& stream, const BuildingStep& step, const glm::dvec3& origin)
{
    for (const std::uint32_t part : step.parts)
        writePart(stream, part, moveTo(-origin));
    for (const std::uint32_t submodel : step.submodels)
    {
        if (isFile(submodel))
            writeReference(stream, std::to_string(LDrawDocument::MAIN_COLOR), moveTo(_origins[submodel] - origin),
                           getName(submodel));
        else
            for (const BuildingStep& inner : _model.plan->getSubmodels()[submodel].steps)
                writeContent(stream, inner, origin);
    }
}

void LDrawSteps::writePart(std::ostream& stream, std::uint32_t index, const LDrawTransform& transform)
{
    const Part& part = _model.bricks->getParts()[index];
    const PartType* type = findPartType(part, _model.bricks->getGrid());
    writeReference(stream, formatColor(part), transform * _frame.getTransform(part), toPartFile(type->number));
}

void LDrawSteps::endStep(std::ostream& stream, const BuildingStep& step)
{
    const View view{step.turns, step.isFromBelow};
    if (view == View())
    {
        if (_view != view) stream << "0 ROTSTEP END" << LDRAW_END_OF_LINE;
    }
    else if (view != _view)
    {
        // The model is turned over about x, and then to the left, which shows its right side. From an azimuth of 33
        // degrees, k quarters show the sides at 33 + 90 k; but turned over, those at 147 - 90 k, and the plan wants
        // those at 33 + 90 turns: k = 1 - turns shows the same two sides.
        constexpr int QUARTER = 90;
        const int turns =
            view.isFromBelow ? (1 - view.turns + BuildingStep::NUM_TURNS) % BuildingStep::NUM_TURNS : view.turns;
        const int degrees = turns == 3 ? -QUARTER : QUARTER * turns;
        stream << "0 ROTSTEP " << (view.isFromBelow ? 2 * QUARTER : 0) << " " << degrees << " 0 REL"
               << LDRAW_END_OF_LINE;
    }
    _view = view;
    stream << "0 STEP" << LDRAW_END_OF_LINE;
}

} // namespace osgLego
