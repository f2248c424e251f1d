#include <osgLego/stability/StabilityAnalysis.h>

#include <osgLego/stability/ContactFinder.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <osg/Timer>

namespace osgLego
{

namespace
{

class Groups
{
public:
    explicit Groups(std::size_t count) : _parents(count) { std::iota(_parents.begin(), _parents.end(), 0u); }

    std::uint32_t find(std::uint32_t member)
    {
        while (_parents[member] != member)
            member = _parents[member] = _parents[_parents[member]];
        return member;
    }
    void join(std::uint32_t a, std::uint32_t b) { _parents[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> _parents;
};

} // namespace

class StabilityAnalysis::Implementation
{
public:
    Implementation(const BrickModel& model, BuildingBase) : _boxes(findPartBoxes(model)), _contacts(findContacts(model))
    {
    }

    std::optional<StabilityReport> solve(std::span<const std::uint32_t> parts)
    {
        if (isCancelled && isCancelled()) return std::nullopt;
        StabilityReport report;
        report.loads.assign(_boxes.size(), 0.0f);
        select(parts);
        const std::size_t base = _boxes.size();
        Groups groups(base + 1);
        for (const std::uint32_t part : parts)
            if (_boxes[part].low.z == _lowest) groups.join(part, static_cast<std::uint32_t>(base));
        for (const Contact& contact : _contacts)
            if (contact.kind == Contact::STUDS && _isSelected[contact.lower] && _isSelected[contact.upper])
                groups.join(contact.lower, contact.upper);
        for (const std::uint32_t part : parts)
            if (groups.find(part) != groups.find(static_cast<std::uint32_t>(base))) report.falling.push_back(part);
        std::sort(report.falling.begin(), report.falling.end());
        for (const std::uint32_t part : report.falling)
            report.loads[part] = 1.0f;
        report.stands = report.safe = report.falling.empty();
        if (!report.stands) report.margin = -1.0;
        return report;
    }

    std::function<bool()> isCancelled;

private:
    void select(std::span<const std::uint32_t> parts)
    {
        _isSelected.assign(_boxes.size(), false);
        _lowest = parts.empty() ? 0 : _boxes[parts.front()].low.z;
        for (const std::uint32_t part : parts)
        {
            _isSelected[part] = true;
            _lowest = std::min(_lowest, _boxes[part].low.z);
        }
    }

    const std::vector<PartBox> _boxes;
    const std::vector<Contact> _contacts;
    std::vector<bool> _isSelected;
    int _lowest = 0;
};

StabilityAnalysis::StabilityAnalysis(const BrickModel& model, BuildingBase base) :
    _implementation(std::make_unique<Implementation>(model, base))
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

} // namespace osgLego
