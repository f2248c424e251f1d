#include "JoinedParts.h"

#include <osgLego/stability/ContactFinder.h>

namespace osgLego
{

std::vector<std::vector<std::uint32_t>> findJoinedParts(const BrickModel& model)
{
    std::vector<std::vector<std::uint32_t>> joined(model.getParts().size());
    for (const Contact& contact : findContacts(model))
    {
        if (contact.kind != Contact::STUDS) continue;
        joined[contact.lower].push_back(contact.upper);
        joined[contact.upper].push_back(contact.lower);
    }
    return joined;
}

} // namespace osgLego
