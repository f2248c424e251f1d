#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/PaletteColor.h>

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/ref_ptr>

namespace osgLego
{

/** How much the look of a model suffers if a cell gets another colour of a layout. */
class RecoloringCosts
{
public:
    /** @param cells in the colours of the surface. @param colors those of the layout. */
    RecoloringCosts(const BrickModel& cells, const std::vector<PaletteColor>& colors);

    /** The increase of the difference (CIEDE2000 between places of toMatchingLab()) between a cell and its surface.
     * @param place of a cell of the layout. @return at least 0; 0 for cells that can't be seen. */
    double get(const std::array<std::uint16_t, 3>& place, std::uint16_t from, std::uint16_t to) const;

private:
    osg::ref_ptr<const BrickModel> _cells;
    std::vector<glm::dvec3> _colors; // by toMatchingLab()
};

} // namespace osgLego
