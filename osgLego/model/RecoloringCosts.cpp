#include <osgLego/model/RecoloringCosts.h>

#include <osgLego/layout/LayoutModel.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <algorithm>

namespace osgLego
{

RecoloringCosts::RecoloringCosts(const BrickModel& cells, const std::vector<PaletteColor>& colors) : _cells(&cells)
{
    _colors.reserve(colors.size());
    for (const PaletteColor& color : colors)
        _colors.push_back(toMatchingLab(color.color));
}

double RecoloringCosts::get(const std::array<std::uint16_t, 3>& place, std::uint16_t from, std::uint16_t to) const
{
    const Brick* const brick = _cells->find(toGridCell({place[0], place[1], place[2]}, _cells->getGrid()));
    if (!brick || brick->openSides == 0 || from >= _colors.size() || to >= _colors.size()) return 0.0;
    const glm::dvec3 surface = toMatchingLab(brick->color);
    return std::max(0.0, ciede2000(_colors[to], surface) - ciede2000(_colors[from], surface));
}

} // namespace osgLego
