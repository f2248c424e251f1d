#pragma once

#include <osgLego/model/HangingParts.h>
#include <osgLego/model/SupportColumns.h>
#include <osgLego/model/SupportedLayout.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace osgLego
{

/** Adds columns below parts that hang, so that a layout can be built from bottom to top.
 *
 * A builder makes a submodel of parts that hang together, and attaches it when the parts that hold it are in place.
 * Where more than a submodel should have hang together, a column is added below the part that carries most of them
 * upwards; of those that carry nearly as many, where it is seen least. Columns that don't make the largest group much
 * smaller are left out.
 *
 * Usage:
 *
 *     if (!BuildingColumns(layout, isCancelled).run()) ... // cancelled
 *
 * The layout must exist as long as this object. One thread. */
class BuildingColumns
{
public:
    static constexpr std::size_t MOST_HANGING = 150; //!< parts that may hang together: BuildingUnits::MOST_PARTS
    static constexpr std::size_t MOST_COLUMNS = 8;

    /** @param layout that stands.
     * @param mostHanging parts that may hang together. */
    BuildingColumns(SupportedLayout& layout, const std::function<bool()>& isCancelled,
                    std::size_t mostHanging = MOST_HANGING);

    /** @return false if it was cancelled. */
    bool run();

private:
    std::optional<SupportColumn> findBelow(const std::vector<std::uint32_t>& group) const;
    bool standsOnGround(const SupportColumn& column) const;
    void carry(const SupportColumn& column);
    bool keep(const std::vector<SupportColumn>& columns);

    SupportedLayout& _layout;
    const std::function<bool()>& _isCancelled;
    std::size_t _mostHanging;
    SupportColumns _places;
    HangingParts _hanging;
    std::size_t _numHanging; //!< at first
};

} // namespace osgLego
