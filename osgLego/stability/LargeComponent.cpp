#include <osgLego/stability/LargeComponent.h>

#include <osgLego/stability/EquilibriumProgram.h>
#include <osgLego/stability/JointLoads.h>
#include <osgLego/stability/RowEquations.h>
#include <osgLego/stability/TensionBound.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace osgLego
{

namespace
{

// The least parts of a component that may be large, and the products of blocks in a factorization from which it is: a
// linear program takes about thirty, of a second on two cores.
constexpr std::size_t LEAST_PARTS = 4'000;
constexpr double MOST_PRODUCTS = 1e8;
// The size of a group of parts, in studs and plates: about fifty parts of a solid.
constexpr int GROUP_WIDTH = 12;
constexpr int GROUP_HEIGHT = 24;

/** Parts in groups, and the contacts between different groups. */
struct PartGroups
{
    std::vector<std::uint32_t> groups; //!< for each part, the number of its group
    std::vector<std::uint32_t> first;  //!< for each group, the index of its lowest part
    std::vector<Contact> contacts;
};

PartGroups groupParts(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                      std::span<const Contact> contacts)
{
    PartGroups result;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    for (std::size_t index = 0; index < parts.size(); ++index)
    {
        const PartBox& box = boxes[parts[index]];
        const std::array<int, 3> place{(box.low.x + box.high.x) / (2 * GROUP_WIDTH),
                                       (box.low.y + box.high.y) / (2 * GROUP_WIDTH), box.low.z / GROUP_HEIGHT};
        const auto [number, isNew] = numbers.emplace(place, static_cast<std::uint32_t>(numbers.size()));
        if (isNew) result.first.push_back(static_cast<std::uint32_t>(index));
        result.groups.push_back(number->second);
    }
    const auto findGroup = [&](std::uint32_t part)
    {
        const auto place = std::lower_bound(parts.begin(), parts.end(), part) - parts.begin();
        return result.groups[static_cast<std::size_t>(place)];
    };
    for (const Contact& contact : contacts)
        if (contact.lower == Contact::BASE || findGroup(contact.lower) != findGroup(contact.upper))
            result.contacts.push_back(contact);
    return result;
}

std::optional<ComponentStability> boundTension(const EquilibriumProgram& program, std::span<const Contact> contacts,
                                               const std::function<bool()>& isCancelled)
{
    const std::optional<std::vector<double>> pulls =
        TensionBound(program, isCancelled).find(StabilityReport::SAFE_CAPACITY);
    if (!pulls) return std::nullopt;
    ComponentStability result;
    result.loads = findLoads(program, *pulls);
    const auto most = std::max_element(pulls->begin(), pulls->end());
    if (*most < ComponentStability::TENSION_TOLERANCE) return result;
    const Contact& weakest = contacts[static_cast<std::size_t>(most - pulls->begin())];
    result.tension = *most;
    result.isTensionBound = true;
    result.weakest = {weakest.lower, weakest.upper};
    return result;
}

std::optional<ComponentStability> findFallOfGroups(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                                   std::span<const Contact> contacts,
                                                   const std::function<bool()>& isCancelled)
{
    const PartGroups groups = groupParts(boxes, parts, contacts);
    const std::optional<BodyFall> fall = findFall(boxes, parts, groups.groups, groups.contacts, isCancelled);
    if (!fall || fall->falling.empty()) return std::nullopt;
    ComponentStability result;
    result.tension = std::numeric_limits<double>::infinity();
    result.isTensionBound = true;
    result.loads.assign(parts.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t index = 0; index < parts.size(); ++index)
    {
        const std::uint32_t group = groups.groups[index];
        if (std::binary_search(fall->falling.begin(), fall->falling.end(), group))
            result.falling.push_back(static_cast<std::uint32_t>(index));
        result.bodies.push_back(groups.first[fall->bodies[group]]);
    }
    return result;
}

} // namespace

std::optional<ComponentStability> solveLargeComponent(std::span<const PartBox> boxes,
                                                      std::span<const std::uint32_t> parts,
                                                      std::span<const Contact> contacts,
                                                      const std::function<bool()>& isCancelled)
{
    if (parts.size() < LEAST_PARTS) return std::nullopt;
    const EquilibriumProgram program(boxes, parts, contacts);
    if (RowEquations::countProducts(program, isCancelled) < MOST_PRODUCTS) return std::nullopt;
    std::optional<ComponentStability> standing = boundTension(program, contacts, isCancelled);
    if (standing || (isCancelled && isCancelled())) return standing;
    return findFallOfGroups(boxes, parts, contacts, isCancelled);
}

} // namespace osgLego
