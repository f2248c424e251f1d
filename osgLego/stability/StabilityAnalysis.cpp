#include <osgLego/stability/StabilityAnalysis.h>

#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/ComponentSolver.h>
#include <osgLego/stability/ContactFinder.h>
#include <osgLego/stability/TiltSolver.h>
#include <osgLego/stability/TippingAngle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

namespace osgLego
{

namespace
{

/** Disjoint sets of indices of parts. */
class PartSets
{
public:
    explicit PartSets(std::size_t count) { _sets.reset(count); }

    std::uint32_t find(std::uint32_t part) { return static_cast<std::uint32_t>(_sets.find(toNumber(part))); }
    /** @return whether the parts were in different sets. */
    bool join(std::uint32_t a, std::uint32_t b) { return _sets.join(toNumber(a), toNumber(b)); }

private:
    static std::int32_t toNumber(std::uint32_t part) { return static_cast<std::int32_t>(part); }

    UnionFind _sets;
};

std::vector<PartBox> findLoadedBoxes(const BrickModel& model, std::span<const AddedWeight> weights)
{
    std::vector<PartBox> boxes = findPartBoxes(model);
    for (const AddedWeight& weight : weights)
    {
        if (weight.part >= boxes.size() || !std::isfinite(weight.grams) || weight.grams < 0.0)
            throw std::invalid_argument("an added weight is on no part, negative or not finite; expected 0 or more "
                                        "grams on one of the " +
                                        std::to_string(boxes.size()) + " parts");
        boxes[weight.part].addedMass += weight.grams;
    }
    return boxes;
}

} // namespace

class StabilityAnalysis::Implementation
{
public:
    Implementation(const BrickModel& model, BuildingBase base, std::span<const AddedWeight> weights) :
        _base(base), _boxes(findLoadedBoxes(model, weights)), _contacts(findContacts(model)), _bodies(_boxes.size())
    {
    }

    std::optional<StabilityReport> solve(std::span<const std::uint32_t> parts)
    {
        StabilityReport report;
        report.loads.assign(_boxes.size(), 0.0f);
        report.numComponents = select(parts);
        for (const std::uint32_t part : parts)
            if (!_isHeld[part]) drop(part, report);
        if (report.falls()) report.margin = -1.0;
        const std::vector<Component> components = findComponents(parts);
        std::vector<std::optional<ComponentStability>> results(components.size());
        tbb::parallel_for(std::size_t(0), components.size(),
                          [&](std::size_t index) { results[index] = solve(components[index]); });
        std::iota(_bodies.begin(), _bodies.end(), 0u);
        Cache cache;
        // Not report.margin, which is -1 if nothing holds some part.
        double leastMargin = std::numeric_limits<double>::infinity();
        for (std::size_t index = 0; index < components.size(); ++index)
        {
            if (!results[index]) return std::nullopt;
            add(components[index], *results[index], report, leastMargin);
            noteBodies(components[index].parts, results[index]->bodies);
            cache.emplace(components[index].parts, std::move(*results[index]));
        }
        _cache = std::move(cache);
        std::sort(report.falling.begin(), report.falling.end());
        std::sort(report.unknown.begin(), report.unknown.end());
        if (_base == BuildingBase::TABLE) addTipping(parts, report);
        report.safe = report.safe && !report.tipsEasily();
        return report;
    }

    std::optional<std::vector<std::uint32_t>> findFalling(std::span<const std::uint32_t> parts, RigidBodies& bodies)
    {
        select(parts);
        std::vector<std::uint32_t> sorted(parts.begin(), parts.end());
        std::sort(sorted.begin(), sorted.end());
        std::map<std::uint32_t, std::uint32_t> numbers; // of bodies
        std::vector<std::uint32_t> first;               // part of each body
        std::vector<std::uint32_t> numbersOfParts;
        std::vector<Contact> contacts;
        for (const std::uint32_t part : sorted)
        {
            const auto number = static_cast<std::uint32_t>(numbers.size());
            const auto place = numbers.emplace(bodies[part], number);
            if (place.second) first.push_back(part);
            numbersOfParts.push_back(place.first->second);
            if (_boxes[part].low.z == _lowest) contacts.push_back(createBaseContact(part));
        }
        for (const Contact& contact : _contacts)
            if (_isSelected[contact.lower] && _isSelected[contact.upper] &&
                bodies[contact.lower] != bodies[contact.upper])
                contacts.push_back(contact);
        const std::optional<BodyFall> fall = findFall(_boxes, sorted, numbersOfParts, contacts, isCancelled);
        if (!fall) return std::nullopt;
        std::vector<std::uint32_t> falling;
        if (fall->falling.empty()) return falling;
        for (std::size_t index = 0; index < sorted.size(); ++index)
        {
            const std::uint32_t body = numbersOfParts[index];
            if (std::binary_search(fall->falling.begin(), fall->falling.end(), body)) falling.push_back(sorted[index]);
            bodies[sorted[index]] = first[fall->bodies[body]];
        }
        return falling;
    }

    const RigidBodies& getBodies() const { return _bodies; }

    bool addTilt(std::span<const std::uint32_t> parts, StabilityReport& report)
    {
        static const std::array<Eigen::Vector2d, 4> DIRECTIONS{{{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};
        if (report.falls()) report.tiltAngles = {0.0, 0.0, 0.0, 0.0};
        if (!report.stands || parts.empty()) return true;
        select(parts);
        std::vector<Component> components = findComponents(parts);
        for (Component& component : components)
            for (Contact& contact : component.contacts)
                if (contact.kind == Contact::TABLE)
                    contact.kind = Contact::ROUGH_TABLE;
                else if (contact.kind == Contact::STUDS)
                    contact.kind = Contact::ROUGH_STUDS;
        std::vector<std::optional<ComponentTilt>> tilts(DIRECTIONS.size() * components.size());
        tbb::parallel_for(std::size_t(0), tilts.size(),
                          [&](std::size_t index)
                          {
                              const Component& component = components[index / DIRECTIONS.size()];
                              tilts[index] = TiltSolver(_boxes, component.parts, component.contacts, isCancelled)
                                                 .solve(DIRECTIONS[index % DIRECTIONS.size()]);
                          });
        std::array<double, DIRECTIONS.size()> angles;
        angles.fill(StabilityReport::MOST_TILT);
        for (std::size_t index = 0; index < tilts.size(); ++index)
        {
            const std::optional<ComponentTilt>& tilt = tilts[index];
            if (!tilt) return false;
            if (!tilt->isKnown) return true;
            double& angle = angles[index % DIRECTIONS.size()];
            angle = std::min(angle, std::atan(tilt->tangent) * 180.0 / std::numbers::pi);
            report.isTiltBound = report.isTiltBound || tilt->isTangentBound;
        }
        report.tiltAngles = angles;
        return true;
    }

    std::function<bool()> isCancelled;

private:
    /** Parts that are held, and their contacts. */
    struct Component
    {
        std::vector<std::uint32_t> parts; //!< ascending
        std::vector<Contact> contacts;
    };
    using Cache = std::map<std::vector<std::uint32_t>, ComponentStability>;

    /** Find the base of the selected parts, and those that are connected to it by studs.
     * @return the number of pieces that don't touch each other. */
    std::size_t select(std::span<const std::uint32_t> parts)
    {
        _isSelected.assign(_boxes.size(), false);
        _lowest = std::numeric_limits<int>::max();
        for (const std::uint32_t part : parts)
        {
            _isSelected[part] = true;
            _lowest = std::min(_lowest, _boxes[part].low.z);
        }
        const auto base = static_cast<std::uint32_t>(_boxes.size());
        PartSets studs(base + 1);
        PartSets pieces(base);
        std::size_t numPieces = parts.size();
        for (const std::uint32_t part : parts)
            if (_boxes[part].low.z == _lowest) studs.join(part, base);
        for (const Contact& contact : _contacts)
        {
            if (!_isSelected[contact.lower] || !_isSelected[contact.upper]) continue;
            numPieces -= pieces.join(contact.lower, contact.upper);
            if (contact.kind == Contact::STUDS) studs.join(contact.lower, contact.upper);
        }
        _isHeld.assign(_boxes.size(), false);
        for (const std::uint32_t part : parts)
            _isHeld[part] = studs.find(part) == studs.find(base);
        return numPieces;
    }

    Contact createBaseContact(std::uint32_t part) const
    {
        return {Contact::BASE, part, _base == BuildingBase::TABLE ? Contact::TABLE : Contact::STUDS};
    }

    /** Group the held parts by their contacts. */
    std::vector<Component> findComponents(std::span<const std::uint32_t> parts)
    {
        PartSets groups(_boxes.size());
        for (const Contact& contact : _contacts)
            if (_isHeld[contact.lower] && _isHeld[contact.upper]) groups.join(contact.lower, contact.upper);
        std::vector<std::uint32_t> held;
        std::copy_if(parts.begin(), parts.end(), std::back_inserter(held),
                     [&](std::uint32_t part) { return _isHeld[part]; });
        std::sort(held.begin(), held.end());
        std::vector<Component> components;
        std::map<std::uint32_t, std::size_t> indices;
        for (const std::uint32_t part : held)
        {
            const std::size_t index = indices.emplace(groups.find(part), components.size()).first->second;
            if (index == components.size()) components.emplace_back();
            components[index].parts.push_back(part);
            if (_boxes[part].low.z == _lowest) components[index].contacts.push_back(createBaseContact(part));
        }
        for (const Contact& contact : _contacts)
            if (_isHeld[contact.lower] && _isHeld[contact.upper])
                components[indices[groups.find(contact.lower)]].contacts.push_back(contact);
        return components;
    }

    std::optional<ComponentStability> solve(const Component& component) const
    {
        if (const auto place = _cache.find(component.parts); place != _cache.end()) return place->second;
        return solveComponent(_boxes, component.parts, component.contacts, isCancelled);
    }

    /** Note the parts of a component that move as one: all of them if it stands. */
    void noteBodies(const std::vector<std::uint32_t>& parts, const std::vector<std::uint32_t>& bodies)
    {
        for (std::size_t index = 0; index < parts.size(); ++index)
            _bodies[parts[index]] = parts[bodies.empty() ? 0 : bodies[index]];
    }

    /** The parts of each piece that studs hold together, by one of them. */
    std::map<std::uint32_t, std::vector<std::uint32_t>> findPieces(std::span<const std::uint32_t> parts) const
    {
        PartSets studs(_boxes.size());
        for (const Contact& contact : _contacts)
            if (contact.kind == Contact::STUDS && _isSelected[contact.lower] && _isSelected[contact.upper])
                studs.join(contact.lower, contact.upper);
        std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;
        for (const std::uint32_t part : parts)
            pieces[studs.find(part)].push_back(part);
        return pieces;
    }

    /** Each piece that studs hold together tips by itself. */
    void addTipping(std::span<const std::uint32_t> parts, StabilityReport& report) const
    {
        if (parts.empty() || (!report.falls() && !report.stands)) return;
        report.tippingAngle = report.falls() ? 0.0 : std::numeric_limits<double>::infinity();
        const auto falls = [&report](std::uint32_t part)
        { return std::binary_search(report.falling.begin(), report.falling.end(), part); };
        for (const auto& [root, piece] : findPieces(parts))
        {
            if (!_isHeld[piece.front()]) continue; // it is not on the table
            const double angle = findTippingAngle(_boxes, piece, _lowest);
            report.tippingAngle = std::min(*report.tippingAngle, angle);
            // Neighbours that it leans on may keep a piece from tipping.
            if (angle == 0.0 && std::any_of(piece.begin(), piece.end(), falls))
                report.tipping.insert(report.tipping.end(), piece.begin(), piece.end());
        }
        std::sort(report.tipping.begin(), report.tipping.end());
    }

    static void drop(std::uint32_t part, StabilityReport& report)
    {
        report.falling.push_back(part);
        report.loads[part] = 1.0f;
        report.stands = report.safe = false;
    }

    static void add(const Component& component, const ComponentStability& result, StabilityReport& report,
                    double& leastMargin)
    {
        for (std::size_t body = 0; body < component.parts.size(); ++body)
            report.loads[component.parts[body]] = result.loads[body];
        const double margin = std::max(-1.0, 1.0 - result.tension / StabilityReport::CAPACITY);
        if (result.weakest && (!report.weakest || margin < leastMargin))
        {
            report.weakest = result.weakest;
            leastMargin = margin;
        }
        if (margin < report.margin || (margin == report.margin && !result.isTensionBound))
            report.isMarginBound = result.isTensionBound;
        report.margin = std::min(report.margin, margin);
        report.stands = report.stands && result.isKnown && result.falling.empty();
        if (!result.isKnown)
            report.unknown.insert(report.unknown.end(), component.parts.begin(), component.parts.end());
        report.safe = report.safe && result.tension <= StabilityReport::SAFE_CAPACITY;
        for (const std::uint32_t body : result.falling)
            drop(component.parts[body], report);
    }

    const BuildingBase _base;
    const std::vector<PartBox> _boxes;
    const std::vector<Contact> _contacts;
    Cache _cache;
    RigidBodies _bodies;
    std::vector<bool> _isSelected;
    std::vector<bool> _isHeld;
    int _lowest = 0;
};

StabilityAnalysis::StabilityAnalysis(const BrickModel& model, BuildingBase base, std::span<const AddedWeight> weights) :
    _implementation(std::make_unique<Implementation>(model, base, weights))
{
}

StabilityAnalysis::~StabilityAnalysis() = default;

void StabilityAnalysis::setCancellation(std::function<bool()> isCancelled)
{
    _implementation->isCancelled = std::move(isCancelled);
}

std::optional<StabilityReport> StabilityAnalysis::solve(std::span<const std::uint32_t> parts)
{
    return _implementation->solve(parts);
}

const StabilityAnalysis::RigidBodies& StabilityAnalysis::getBodies() const
{
    return _implementation->getBodies();
}

std::optional<std::vector<std::uint32_t>> StabilityAnalysis::findFalling(std::span<const std::uint32_t> parts,
                                                                         RigidBodies& bodies)
{
    return _implementation->findFalling(parts, bodies);
}

bool StabilityAnalysis::addTilt(std::span<const std::uint32_t> parts, StabilityReport& report)
{
    return _implementation->addTilt(parts, report);
}

} // namespace osgLego
