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
#include <vector>

namespace osgLego
{

namespace
{

// The least parts of a component that may be large, and the products of blocks in a factorization from which it is: a
// linear program takes about thirty, of a second on two cores.
constexpr std::size_t LEAST_PARTS = 4'000;
constexpr double MOST_PRODUCTS = 1e8;
// The size of a group of parts, in studs and plates: about fifty parts of a solid.
constexpr glm::ivec3 GROUP_SIZE{12, 12, 24};
// The most parts that fall in groups and are looked at one by one afterwards.
constexpr std::size_t MOST_SEPARATE_PARTS = 1'000;

/** Parts that are joined to rigid bodies. */
class RigidGroups
{
public:
    /** @param places equal ones for parts of a body. */
    RigidGroups(std::span<const std::uint32_t> parts, const std::vector<std::array<int, 3>>& places) : _parts(parts)
    {
        std::map<std::array<int, 3>, std::uint32_t> numbers;
        for (std::size_t index = 0; index < parts.size(); ++index)
        {
            const auto [number, isNew] = numbers.emplace(places[index], static_cast<std::uint32_t>(numbers.size()));
            if (isNew) _first.push_back(static_cast<std::uint32_t>(index));
            _bodies.push_back(number->second);
        }
    }

    /** Find the parts that fall. @return nothing if it is not known that any do, or if it was cancelled. */
    std::optional<ComponentStability> findFall(std::span<const PartBox> boxes, std::span<const Contact> contacts,
                                               const std::function<bool()>& isCancelled) const
    {
        const std::optional<BodyFall> fall =
            osgLego::findFall(boxes, _parts, _bodies, selectContacts(contacts), isCancelled);
        if (!fall || fall->falling.empty()) return std::nullopt;
        ComponentStability result;
        result.tension = std::numeric_limits<double>::infinity();
        result.isTensionBound = true;
        result.loads.assign(_parts.size(), std::numeric_limits<float>::quiet_NaN());
        for (std::size_t index = 0; index < _parts.size(); ++index)
        {
            const std::uint32_t body = _bodies[index];
            if (std::binary_search(fall->falling.begin(), fall->falling.end(), body))
                result.falling.push_back(static_cast<std::uint32_t>(index));
            result.bodies.push_back(_first[fall->bodies[body]]);
        }
        return result;
    }

private:
    /** The contacts between different bodies, and those with the base. */
    std::vector<Contact> selectContacts(std::span<const Contact> contacts) const
    {
        const auto findBody = [this](std::uint32_t part) {
            return _bodies[static_cast<std::size_t>(std::lower_bound(_parts.begin(), _parts.end(), part) -
                                                    _parts.begin())];
        };
        std::vector<Contact> selected;
        for (const Contact& contact : contacts)
            if (contact.lower == Contact::BASE || findBody(contact.lower) != findBody(contact.upper))
                selected.push_back(contact);
        return selected;
    }

    std::span<const std::uint32_t> _parts;
    std::vector<std::uint32_t> _bodies; //!< for each part, the number of its body
    std::vector<std::uint32_t> _first;  //!< for each body, the index of its lowest part
};

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
    return findFallOfGroups(boxes, parts, contacts, GROUP_SIZE, isCancelled);
}

std::optional<ComponentStability> findFallOfGroups(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                                   std::span<const Contact> contacts, const glm::ivec3& size,
                                                   const std::function<bool()>& isCancelled)
{
    std::vector<std::array<int, 3>> places;
    for (const std::uint32_t part : parts)
    {
        const glm::ivec3 place = (boxes[part].low + boxes[part].high) / (2 * size);
        places.push_back({place.x, place.y, place.z});
    }
    std::optional<ComponentStability> groups = RigidGroups(parts, places).findFall(boxes, contacts, isCancelled);
    if (!groups || groups->falling.size() > MOST_SEPARATE_PARTS) return groups;
    constexpr int SEPARATE = -1; // in place of a coordinate
    for (const std::uint32_t index : groups->falling)
        places[index] = {static_cast<int>(index), SEPARATE, SEPARATE};
    std::optional<ComponentStability> separate = RigidGroups(parts, places).findFall(boxes, contacts, isCancelled);
    return separate ? separate : groups;
}

} // namespace osgLego
