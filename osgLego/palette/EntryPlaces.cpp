#include <osgLego/palette/EntryPlaces.h>

#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <algorithm>

namespace osgLego
{

EntryPlaces::EntryPlaces() :
    _places(TableBlock::COUNT * TableBlock::SIDE * TableBlock::SIDE * TableBlock::SIDE), _radii(TableBlock::COUNT)
{
    TableBlock::forEach(
        [&](const TableBlock& block)
        {
            block.forEachEntry([&](std::size_t entry) { _places[entry] = toMatchingLab(middleOfEntry(entry)); });
            _radii[block.getIndex()] = findRadius(block);
        });
}

const EntryPlaces& EntryPlaces::get()
{
    static const EntryPlaces places;
    return places;
}

double EntryPlaces::findRadius(const TableBlock& block) const
{
    double radius = 0.0;
    for (const std::size_t blue : {std::size_t(0), TableBlock::SIDE - 1})
        for (const std::size_t green : {std::size_t(0), TableBlock::SIDE - 1})
            for (const std::size_t red : {std::size_t(0), TableBlock::SIDE - 1})
                radius =
                    std::max(radius, ciede2000(_places[block.getMiddle()], _places[block.getEntry(red, green, blue)]));
    return radius;
}

} // namespace osgLego
