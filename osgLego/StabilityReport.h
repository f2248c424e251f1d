#pragma once

#include <osgLego/Export.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace osgLego
{

/** The surface on which a model stands. */
enum class BuildingBase
{
    TABLE, //!< a bare table, which only pushes
    PLATE  //!< a studded base plate, which also holds
};

/** The stability of a model of parts under gravity, and its most loaded joints.
 *
 * The model stands if forces at the contacts of its parts exist that keep every part in equilibrium: pressure between
 * parts, and at each contact of a stud up to CAPACITY newtons against pulling it out (Liu et al. 2024, "StableLego:
 * Stability Analysis of Block Stacking Assembly", arXiv 2402.10711). docs/stability.md has the linear program. */
struct OSGLEGO_EXPORT StabilityReport
{
    static constexpr double CAPACITY = 0.98;      //!< newtons at a contact point that joints bear (StableLego)
    static constexpr double SAFE_CAPACITY = 0.70; //!< newtons that worn joints bear, too (Luo et al. 2015)

    /** Two parts that hold each other, as indices into BrickModel::getParts(). */
    struct Joint
    {
        static constexpr std::uint32_t BASE = 0xffffffff; //!< instead of a part: the base on which the model stands

        std::uint32_t lower = BASE;
        std::uint32_t upper = BASE;
    };

    bool stands = true; //!< whether forces within CAPACITY are known to keep all parts in equilibrium
    /** Whether forces within SAFE_CAPACITY are known to do so, and the model does not tip over on a table that is
     * tilted by SAFE_TILT. */
    bool safe = true;
    /** The share of CAPACITY that is left at the contact point that bears most, if forces are spread so that this point
     * bears as little as possible: 1 if nothing pulls, 0 at the limit, negative beyond it, and -1 if twice the capacity
     * does not suffice. */
    double margin = 1.0;
    /** Whether the true margin may be larger: forces that leave `margin` were found, but maybe not the best ones, or,
     * if it is -1, twice the capacity may suffice. */
    bool isMarginBound = false;
    /** Of the contact points that bear most, the joint of that whose capacity matters most; unset if nothing pulls, or
     * if only parts that fall are known. */
    std::optional<Joint> weakest;
    /** Parts that are not in equilibrium within CAPACITY, or that nothing connects to the base, in ascending order. In
     * a large component, they may be all parts of groups of which some are not. */
    std::vector<std::uint32_t> falling;
    /** The parts, in ascending order, of pieces that studs hold together, that fall at least partly, and whose centre
     * of mass is not above the convex hull of their lowest faces: they tip over as a whole, even if `falling` lacks
     * some of their parts. Empty on a base plate, which holds them. */
    std::vector<std::uint32_t> tipping;
    /** Parts of pieces whose forces can't be computed precisely enough to know whether they stand, in ascending order.
     * If there are any, `stands` is false, and `margin` is a bound of -1. */
    std::vector<std::uint32_t> unknown;
    /** For each part, the share of CAPACITY that its most loaded contact point bears, at least 0; 1 for parts that
     * fall, and not a number for those in `unknown`, nor for the others of a component of which only groups that fall
     * are known (docs/stability.md, "Large components"). */
    std::vector<float> loads;
    /** The angle in degrees, from 0 to 90, by which the table can be tilted in any direction before a piece that
     * studs hold together tips over about an edge of its foot, if nothing slides and all joints hold; the joints may
     * give way before. 0 if
     * parts fall, and unset on a base plate, for no parts and if it is unknown whether the model stands. */
    std::optional<double> tippingAngle;
    static constexpr double SAFE_TILT =
        2.0; //!< degrees; a model that tips over at less falls if somebody bumps the table
    static constexpr double MOST_TILT = 45.0; //!< the greatest of `tiltAngles`
    /** The angles in degrees, from 0 to MOST_TILT, by which the base can be tilted towards +x, -x, +y and -y of the
     * ground, so that this side descends, before the model falls: because a piece tips over, joints break, or a part
     * turns about a single stud, whose friction holds up to CAPACITY at a quarter of the pitch. Nothing slides. y is
     * the grid's axis beside x that is not the up axis. 0 if parts fall; unset if StabilityOptions::findsTilt is not
     * set, for no parts, and if they are unknown. */
    std::optional<std::array<double, 4>> tiltAngles;
    /** Whether a true angle may be larger, as for isMarginBound. */
    bool isTiltBound = false;
    std::size_t numComponents = 0; //!< pieces without contact to each other, which are computed separately
    double milliseconds = 0.0;     //!< the time taken

    /** Whether the model tips over on a table that is tilted by SAFE_TILT. */
    bool tipsEasily() const { return tippingAngle && *tippingAngle < SAFE_TILT; }
    /** Whether the model falls for certain; if it neither does nor stands, that is unknown. */
    bool falls() const { return !falling.empty(); }
    /** Of `falling`, those that are not in `tipping`. */
    std::vector<std::uint32_t> findUnheld() const;
    /** Whether the model falls only because pieces tip over as a whole. */
    bool tips() const { return falls() && findUnheld().empty(); }
    /** The verdict and the margin in a line of English. */
    std::string toString() const;
};

} // namespace osgLego
