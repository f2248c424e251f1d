#include <osgLego/stability/PartialStability.h>

#include <osgLego/PartType.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/StabilityAnalysis.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace osgLego
{

namespace
{

// The most added parts for which a linear program of them and of parts near them is tried.
constexpr std::size_t MOST_ADDED = 100;
constexpr int NEAR = 2; // joints away
// The widths of corridors about new parts and paths from them to the base, in joints.
constexpr int NARROW = 2;
constexpr int WIDE = 6;
// How many times smaller than all parts in place: large corridors take as long as all parts, and may find nothing.
constexpr std::size_t LEAST_SMALLER = 3;

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

std::vector<std::uint32_t> listPlaced(const std::vector<bool>& isPlaced)
{
    std::vector<std::uint32_t> placed;
    for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
        if (isPlaced[part]) placed.push_back(part);
    return placed;
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
    _graph(graph), _parts(parts), _setting(std::move(setting)),
    _joints(graph, findWeights(model, parts), _setting.base), _flow(_joints), _springs(_joints),
    _corridor(_joints, getCellPlates(model.getGrid()), _setting.isCancelled), _standing(parts.size(), false)
{
    _forces = createNoForces(_joints);
}

PartialStability::~PartialStability() = default;

/** Keep forces that were found. @return whether there are any. */
bool PartialStability::keep(std::optional<BearingForces> forces)
{
    if (!forces) return false;
    _forces = std::move(*forces);
    return true;
}

/** Whether the known forces, and those due to new parts, which they pass on downwards, keep parts in equilibrium. */
bool PartialStability::flows(const std::vector<bool>& isPlaced)
{
    return includes(isPlaced, _forces.isPlaced) && _flow.add(_forces, isPlaced);
}

/** The same with forces due to new parts as if contact points were springs, first of corridors, then of all parts. If
 * other parts are in place than those of the known forces, all are new. */
bool PartialStability::isSprung(const std::vector<bool>& isPlaced)
{
    const BearingForces start = includes(isPlaced, _forces.isPlaced) ? _forces : createNoForces(_joints);
    for (const int numJoints : {NARROW, WIDE})
        if (const std::optional<std::vector<bool>> isInside = findCorridor(start, isPlaced, numJoints);
            isInside && keep(_springs.add(start, isPlaced, *isInside)))
            return true;
    return keep(_springs.add(start, isPlaced, isPlaced));
}

/** Whether forces are found that keep parts in equilibrium, all others being as they are known.
 * @param numJoints the width of the corridor. */
bool PartialStability::isBalancedNear(const std::vector<bool>& isPlaced, int numJoints)
{
    if (_numBodies >= _setting.mostSolved || !includes(isPlaced, _forces.isPlaced)) return false;
    const std::optional<std::vector<bool>> isInside = findCorridor(_forces, isPlaced, numJoints);
    if (!isInside) return false;
    _numBodies += listPlaced(*isInside).size();
    return keep(_corridor.add(_forces, isPlaced, *isInside));
}

/** The parts near new ones, and near paths from them to the base. Nothing if no parts are new, or if there are hardly
 * fewer than all in place.
 * @param start forces between the parts that are not new.
 * @param numJoints the width. */
std::optional<std::vector<bool>> PartialStability::findCorridor(const BearingForces& start,
                                                                const std::vector<bool>& isPlaced, int numJoints) const
{
    const PartList placed = listPlaced(isPlaced);
    PartList added;
    std::copy_if(placed.begin(), placed.end(), std::back_inserter(added),
                 [&start](std::uint32_t part) { return !start.isPlaced[part]; });
    if (added.empty() || LEAST_SMALLER * added.size() > placed.size()) return std::nullopt;
    std::vector<bool> isInside = findNear(findPaths(added, isPlaced), isPlaced, numJoints);
    if (LEAST_SMALLER * listPlaced(isInside).size() > placed.size()) return std::nullopt;
    return isInside;
}

/** Whether forces are found that keep parts in equilibrium, of the linear program of all of them. */
bool PartialStability::isBalancedAnew(const std::vector<bool>& isPlaced)
{
    if (_numSolved >= _setting.mostSolved) return false;
    if (!_analysis) createAnalysis();
    _numSolved += listPlaced(isPlaced).size();
    return keep(_corridor.add(createNoForces(_joints), isPlaced, isPlaced));
}

std::optional<std::vector<std::uint32_t>> PartialStability::findFalling(const std::vector<bool>& isPlaced)
{
    std::optional<PartList> falling = findFallingAgain(isPlaced);
    if (falling && falling->empty() && !flows(isPlaced))
    {
        falling = findFallingNear(isPlaced);
        if (falling && falling->empty() && !isSprung(isPlaced) && !isBalancedNear(isPlaced, NARROW) &&
            !isBalancedNear(isPlaced, WIDE) && !isBalancedAnew(isPlaced))
            falling = findAllFalling(isPlaced);
    }
    if (!falling) return std::nullopt;
    if (falling->empty())
    {
        _standing = isPlaced;
        std::erase_if(_falling, [&](std::uint32_t part) { return isPlaced[part]; });
    }
    else
        _falling = *falling;
    return falling;
}

/** Those of the parts that fell last that are in place, if the bodies in which they fell still fall. */
std::optional<PartialStability::PartList> PartialStability::findFallingAgain(const std::vector<bool>& isPlaced)
{
    PartList former;
    std::copy_if(_falling.begin(), _falling.end(), std::back_inserter(former),
                 [&](std::uint32_t part) { return isPlaced[part]; });
    if (former.empty() || _numBodies >= _setting.mostSolved) return PartList();
    PartList bodies = _bodies;
    const std::optional<PartList> falling = findFallingBodies(isPlaced, bodies);
    if (!falling) return std::nullopt;
    if (falling->empty()) return PartList();
    _bodies = std::move(bodies);
    return former;
}

/** Of new parts, and those near them, the parts that fall if studs join all others to rigid bodies. None if there are
 * too many. */
std::optional<PartialStability::PartList> PartialStability::findFallingNear(const std::vector<bool>& isPlaced)
{
    PartList added;
    for (const std::uint32_t part : listPlaced(isPlaced))
        if (!_standing[part]) added.push_back(part);
    if (added.size() > MOST_ADDED || _numBodies >= _setting.mostSolved) return PartList();
    if (!_analysis) createAnalysis();
    const std::vector<bool> isNear = findNear(added, isPlaced, NEAR);
    const auto isFar = [&](std::uint32_t part) { return isPlaced[part] && !isNear[part]; };
    UnionFind sets;
    sets.reset(isPlaced.size());
    for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
        for (const PartLink& joint : _graph.getJointsAbove(part))
            if (isFar(part) && isFar(joint.part))
                sets.join(static_cast<std::int32_t>(part), static_cast<std::int32_t>(joint.part));
    PartList bodies(isPlaced.size());
    for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
        bodies[_toAnalysis[part]] = _toAnalysis[static_cast<std::size_t>(sets.find(static_cast<std::int32_t>(part)))];
    std::optional<PartList> falling = findFallingBodies(isPlaced, bodies);
    if (!falling) return std::nullopt;
    std::erase_if(*falling, [&](std::uint32_t part) { return !isNear[part]; });
    if (!falling->empty()) _bodies = std::move(bodies);
    return falling;
}

/** The parts of bodies that fall; none if all stand. */
std::optional<PartialStability::PartList> PartialStability::findFallingBodies(const std::vector<bool>& isPlaced,
                                                                              PartList& bodies)
{
    const PartList placed = toAnalysis(listPlaced(isPlaced));
    PartList numbers;
    for (const std::uint32_t part : placed)
        numbers.push_back(bodies[part]);
    std::sort(numbers.begin(), numbers.end());
    const auto numBodies = std::unique(numbers.begin(), numbers.end()) - numbers.begin();
    _numBodies += static_cast<std::size_t>(numBodies);
    const std::optional<PartList> falling = _analysis->findFalling(placed, bodies);
    if (!falling) return std::nullopt;
    return fromAnalysis(*falling);
}

/** The parts that fall of all; none if all stand. */
std::optional<PartialStability::PartList> PartialStability::findAllFalling(const std::vector<bool>& isPlaced)
{
    if (_numSolved >= _setting.mostSolved) return std::nullopt;
    if (!_analysis) createAnalysis();
    const PartList placed = toAnalysis(listPlaced(isPlaced));
    _numSolved += placed.size();
    _numHard += placed.size();
    const std::optional<StabilityReport> report = _analysis->solve(placed);
    if (!report || (!report->stands && !report->falls())) return std::nullopt;
    if (!report->falling.empty()) _bodies = _analysis->getBodies();
    return fromAnalysis(report->falling);
}

/** Parts, and those in place that few joints connect to them. */
std::vector<bool> PartialStability::findNear(PartList parts, const std::vector<bool>& isPlaced, int numJoints) const
{
    std::vector<bool> isFound(isPlaced.size(), false);
    for (const std::uint32_t part : parts)
        isFound[part] = true;
    std::size_t first = 0;
    for (int round = 0; round < numJoints; ++round)
    {
        const std::size_t end = parts.size();
        for (; first < end; ++first)
        {
            const std::uint32_t part = parts[first];
            for (const auto& links : {_graph.getJointsBelow(part), _graph.getJointsAbove(part)})
                for (const PartLink& link : links)
                    if (isPlaced[link.part] && !isFound[link.part])
                    {
                        isFound[link.part] = true;
                        parts.push_back(link.part);
                    }
        }
    }
    return isFound;
}

/** Parts, and those on a shortest path of joints from each to the base, if there is one. */
PartialStability::PartList PartialStability::findPaths(const PartList& parts, const std::vector<bool>& isPlaced) const
{
    constexpr std::uint32_t UNREACHED = 0xffffffff;
    PartList reached;
    PartList next(isPlaced.size(), UNREACHED); // towards the base
    const auto reach = [&](std::uint32_t part, std::uint32_t from)
    {
        if (!isPlaced[part] || next[part] != UNREACHED) return;
        next[part] = from;
        reached.push_back(part);
    };
    for (std::uint32_t part = 0; part < isPlaced.size(); ++part)
        if (_graph.isOnBase(part)) reach(part, part);
    for (std::size_t index = 0; index < reached.size(); ++index)
        for (const auto& links : {_graph.getJointsBelow(reached[index]), _graph.getJointsAbove(reached[index])})
            for (const PartLink& link : links)
                reach(link.part, reached[index]);
    std::vector<bool> isFound(isPlaced.size(), false);
    PartList paths;
    for (std::uint32_t part : parts)
        for (; part != UNREACHED && !isFound[part]; part = next[part])
        {
            isFound[part] = true;
            paths.push_back(part);
        }
    return paths;
}

PartialStability::PartList PartialStability::toAnalysis(std::span<const std::uint32_t> parts) const
{
    PartList result;
    for (const std::uint32_t part : parts)
        result.push_back(_toAnalysis[part]);
    return result;
}

PartialStability::PartList PartialStability::fromAnalysis(std::span<const std::uint32_t> parts) const
{
    PartList result;
    for (const std::uint32_t part : parts)
        result.push_back(_fromAnalysis[part]);
    return result;
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
    std::vector<Contact> beside;
    for (const Contact& contact : findContacts(*model))
        if (contact.kind == Contact::SIDE_X || contact.kind == Contact::SIDE_Y)
            beside.push_back({_fromAnalysis[contact.lower], _fromAnalysis[contact.upper], contact.kind});
    _corridor.setBeside(std::move(beside));
}

} // namespace osgLego
