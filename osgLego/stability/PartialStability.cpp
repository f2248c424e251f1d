#include <osgLego/stability/PartialStability.h>

#include <osgLego/PartType.h>
#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/StabilityAnalysis.h>

#include <utility>

namespace osgLego
{

namespace
{

std::vector<double> findWeights(const BrickModel& model, const std::vector<std::uint32_t>& parts)
{
    std::vector<double> weights;
    for (const std::uint32_t part : parts)
    {
        const PartType* type = findPartType(model.getParts()[part], model.getGrid());
        weights.push_back(type ? EquilibriumProgram::NEWTONS_PER_GRAM * type->mass : 0.0);
    }
    return weights;
}

/** Whether all members of a set are in another. */
bool includes(const std::vector<bool>& set, const std::vector<bool>& members)
{
    for (std::size_t index = 0; index < set.size(); ++index)
        if (members[index] && !set[index]) return false;
    return true;
}

/** A part of a model that is built upside down. */
Part turnOver(Part part, const BrickGrid& grid)
{
    const auto up = static_cast<std::size_t>(grid.getUpIndex());
    part.cell[up] = static_cast<std::uint16_t>(grid.dimensions[grid.getUpIndex()] - part.cell[up] - part.size[up]);
    return part;
}

} // namespace

PartialStability::PartialStability(const BrickModel& model, const std::vector<std::uint32_t>& parts,
                                   const JointGraph& graph, Setting setting) :
    _model(model),
    _parts(parts), _setting(std::move(setting)), _joints(graph, findWeights(model, parts), _setting.base),
    _flow(_joints), _springs(_joints)
{
    _forces = _proven = createNoForces();
}

PartialStability::~PartialStability() = default;

/** Whether forces are found that keep parts in equilibrium. */
bool PartialStability::isBalanced(const std::vector<bool>& isPlaced)
{
    if (includes(isPlaced, _forces.isPlaced) && _flow.add(_forces, isPlaced)) return true;
    for (const BearingForces& start : {createNoForces(), _proven})
        if (includes(isPlaced, start.isPlaced))
            if (std::optional<BearingForces> forces = _springs.add(start, isPlaced))
            {
                _forces = std::move(*forces);
                return true;
            }
    return false;
}

BearingForces PartialStability::createNoForces() const
{
    return {std::vector<bool>(_parts.size(), false), std::vector<double>(_joints.getPoints().size(), 0.0),
            std::vector<VerticalLoad>(_parts.size(), VerticalLoad::Zero())};
}

std::optional<std::vector<std::uint32_t>> PartialStability::findFalling(const std::vector<bool>& isPlaced)
{
    if (isBalanced(isPlaced)) return std::vector<std::uint32_t>();
    if (_numSolved >= _setting.mostSolved) return std::nullopt;
    if (!_analysis) createAnalysis();
    std::vector<std::uint32_t> placed;
    for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
        if (isPlaced[part]) placed.push_back(_toAnalysis[part]);
    _numSolved += placed.size();
    const std::optional<StabilityReport> report = _analysis->solve(placed);
    if (!report || (!report->stands && !report->falls())) return std::nullopt;
    std::vector<std::uint32_t> falling;
    for (const std::uint32_t part : report->falling)
        falling.push_back(_fromAnalysis[part]);
    if (falling.empty())
    {
        // Assume that every contact point, also with a base plate, pulls as much as the one that pulls most. The loads
        // on the base are unknown, but the base bears them; the forces added to them must be an equilibrium by
        // themselves.
        _proven = createNoForces();
        _proven.isPlaced = isPlaced;
        _proven.floorPull = (1.0 - report->margin) * StabilityReport::CAPACITY;
        _proven.pressures.assign(_proven.pressures.size(), -_proven.floorPull);
        _forces = _proven;
    }
    return falling;
}

/** Prepare the analysis of the parts alone, turned as they are built. */
void PartialStability::createAnalysis()
{
    const BrickGrid& grid = _model.getGrid();
    std::vector<Part> selected;
    for (const std::uint32_t part : _parts)
    {
        const Part& found = _model.getParts()[part];
        selected.push_back(_setting.isUpsideDown ? turnOver(found, grid) : found);
    }
    const osg::ref_ptr<const BrickModel> model = BrickModel::createOfParts(grid, selected);
    _fromAnalysis.resize(selected.size());
    for (std::uint32_t part = 0; part < selected.size(); ++part)
    {
        const auto index =
            static_cast<std::uint32_t>(model->findPart(selected[part].getCell()) - model->getParts().data());
        _toAnalysis.push_back(index);
        _fromAnalysis[index] = part;
    }
    _analysis = std::make_unique<StabilityAnalysis>(*model, _setting.base);
    _analysis->setCancellation(_setting.isCancelled);
}

} // namespace osgLego
