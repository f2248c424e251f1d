#include "SimilarColors.h"

#include <osgLego/Palette.h>

#include <algorithm>

namespace osgLego
{

SimilarColors::SimilarColors(const BookletModel& model) : _isSimilar(model.getKinds().size(), false)
{
    const std::vector<PartsList::Row>& kinds = model.getKinds();
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    {
        const PaletteColor& own = kinds[kind].color;
        std::size_t first = kind;
        for (std::size_t other = 0; other < kinds.size(); ++other)
        {
            const PaletteColor& color = kinds[other].color;
            if (color.code == own.code && color.color == own.color)
                first = std::min(first, other);
            else if (Palette::getDifference(own.color, color.color) < LEAST_DIFFERENCE)
                _isSimilar[kind] = true;
        }
        _first.push_back(first);
    }
}

std::vector<std::size_t> SimilarColors::chooseKinds(const std::set<std::size_t>& kinds) const
{
    std::vector<std::size_t> chosen;
    std::set<std::size_t> colors;
    for (const std::size_t kind : kinds)
        if (_isSimilar[kind] && colors.insert(_first[kind]).second) chosen.push_back(kind);
    return chosen;
}

} // namespace osgLego
