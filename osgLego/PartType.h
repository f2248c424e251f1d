#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/Export.h>
#include <osgLego/Part.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace osgLego
{

/** The height of a part. */
enum class PartFamily
{
    BRICK, //!< 9.6 mm
    PLATE  //!< 3.2 mm, a third of a brick
};

/** One of the 22 rectangular parts that models are built from: bricks and plates of 1x1 to 2x8 studs.
 *
 * Usage:
 *
 *     for (const osgLego::Part& part : model->getParts())
 *         if (const osgLego::PartType* type = osgLego::findPartType(part, model->getGrid()))
 *             std::cout << type->getName() << '\n';
 *
 * A plain value without GL; every function may be called from any thread. Numbers of parts are those of LDraw and
 * BrickLink.
 */
struct OSGLEGO_EXPORT PartType
{
    PartFamily family = PartFamily::BRICK;
    int width = 1;           //!< the shorter side, in studs
    int length = 1;          //!< the longer side, in studs
    std::string_view number; //!< such as "3001", the file 3001.dat in LDraw's library
    double mass = 0.0;       //!< grams

    /** The name, such as "Brick 2 x 4". */
    std::string getName() const;
    /** The index of its size in PART_SIZES. */
    std::size_t getSizeIndex() const;
};

/** The sizes of parts, shorter side first, in studs. */
inline constexpr std::array<std::array<int, 2>, 11> PART_SIZES{
    {{1, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 6}, {1, 8}, {2, 2}, {2, 3}, {2, 4}, {2, 6}, {2, 8}}};

/** All types: bricks in the order of PART_SIZES, then plates. */
OSGLEGO_EXPORT std::span<const PartType> getPartTypes();

/** The type of the given size, in studs and in any order; null if there is none. */
OSGLEGO_EXPORT const PartType* findPartType(PartFamily family, int side, int otherSide);

/** The type of a part in a grid; null if no real part has its shape. */
OSGLEGO_EXPORT const PartType* findPartType(const Part& part, const BrickGrid& grid);

/** The height of a cell in plates: 3 in a grid of Proportions::BRICK, 1 for Proportions::PLATE, and 0 for other shapes,
 * from which nothing can be built. */
OSGLEGO_EXPORT int getCellPlates(const BrickGrid& grid);

} // namespace osgLego
