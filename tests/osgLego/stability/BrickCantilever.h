#pragma once

#include <osgLego/stability/EquilibriumProgram.h>

#include <cstdint>
#include <vector>

namespace osgLego::test
{

/** A brick 1 x 8 with its first stud on a brick 1 x 1, which lies on a base plate. The upper brick turns about the
 * point a quarter pitch towards its end. Three drags hold it, whose distances from there are 1/2, 1/4 and 1/4 pitches:
 * with the tension t, weight * LEVER = t. The brick 1 x 1 is between them because a base plate has studs below all of a
 * brick; its weight relieves its joint with the plate. */
struct BrickCantilever
{
    static constexpr double WEIGHT_1X1 = 9.8e-3 * 0.43; // newtons
    static constexpr double WEIGHT_1X8 = 9.8e-3 * 3.03; // newtons
    static constexpr double LEVER = 3.25;               // pitches, of the upper weight about the point that presses

    static EquilibriumProgram createProgram()
    {
        static const std::vector<PartBox> BOXES{{{0, 0, 0}, {1, 1, 3}, 0.43}, {{0, 0, 3}, {8, 1, 6}, 3.03}};
        static const std::vector<std::uint32_t> BOTH{0, 1};
        return {BOXES, BOTH, std::vector<Contact>{{0, 1, Contact::STUDS}, {Contact::BASE, 0, Contact::STUDS}}};
    }
};

} // namespace osgLego::test
