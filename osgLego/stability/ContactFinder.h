#pragma once

#include <osgLego/BrickModel.h>

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The box of a part, with z upwards for every up axis of the grid. */
struct PartBox
{
    glm::ivec3 low{0};      //!< in studs, studs and plates
    glm::ivec3 high{0};     //!< exclusive
    double mass = 0.0;      //!< grams
    double addedMass = 0.0; //!< grams, at the middle of its top
};

/** Two parts that touch. */
struct Contact
{
    static constexpr std::uint32_t BASE = 0xffffffff; //!< instead of a part: that on which the model stands

    enum Kind : std::uint8_t
    {
        SIDE_X,      //!< `upper` is beside `lower`, towards +x
        SIDE_Y,      //!< `upper` is beside `lower`, towards +y
        TABLE,       //!< `upper` is on a smooth table, and `lower` is BASE
        STUDS,       //!< `upper` is on studs of `lower`
        ROUGH_TABLE, //!< as TABLE, but with friction
        ROUGH_STUDS  //!< as STUDS, but with friction against turning about a single one
    };

    std::uint32_t lower = BASE;
    std::uint32_t upper = BASE;
    Kind kind = STUDS;
};

/** The boxes of the parts of a model, in the order of BrickModel::getParts(). */
std::vector<PartBox> findPartBoxes(const BrickModel& model);

/** All pairs of parts of a model that touch, without the base, in ascending order of the lower part. */
std::vector<Contact> findContacts(const BrickModel& model);

} // namespace osgLego
