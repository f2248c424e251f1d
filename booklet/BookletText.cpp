#include "BookletText.h"

#include <common/ColorName.h>
#include <common/NumberText.h>

#include <algorithm>
#include <array>
#include <utility>

#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

/** The colours whose names differ by more than the spelling of grey. */
constexpr std::array<std::pair<int, const char*>, 7> OTHER_NAMES{{{32, "Light Orange"},
                                                                  {56, "Rose Pink"},
                                                                  {89, "Dark Purple"},
                                                                  {93, "Light Purple"},
                                                                  {97, "Blue-Violet"},
                                                                  {109, "Dark Blue-Violet"},
                                                                  {245, "Lilac"}}};

} // namespace

std::string nameType(const PartType& type)
{
    const char* family = type.family == PartFamily::BRICK ? "Brick" : "Plate";
    return std::string(family) + "\u00a0" + std::to_string(type.width) + "\u202f×\u202f" + std::to_string(type.length);
}

std::string nameBrickLinkColor(const PaletteColor& color)
{
    if (color.brickLink < 0) return {};
    for (const auto& [number, name] : OTHER_NAMES)
        if (number == color.brickLink) return name;
    std::string name = nameColor(color);
    if (const auto place = name.find("Grey"); place != std::string::npos) name.replace(place, 4, "Gray");
    return name;
}

std::string describeParts(const PartsList::Row& row, std::size_t quantity)
{
    const std::string name = osgDB::convertToLowerCase(row.type->getName());
    const auto space = name.find(' ');
    const std::string color =
        row.color.code == Part::NO_CODE ? row.color.name : osgDB::convertToLowerCase(nameColor(row.color));
    return formatNumber(quantity) + " " + color + " " + name.substr(0, space) + (quantity == 1 ? "" : "s") +
           name.substr(space);
}

std::string nameBuilt(const BookletChapter& chapter)
{
    return chapter.isSubmodel ? "submodel" : "model";
}

std::string describeHold(const BookletChapter& chapter, const BookletStep& step)
{
    if (step.numUnheld > 0) return "Nothing holds " + countOf(step.numUnheld, "part") + " of this step.";
    return step.falls() ? "Hold the " + nameBuilt(chapter) + " after this step: it does not stand by itself yet."
                        : std::string();
}

std::string joinWords(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t word = 0; word < words.size(); ++word)
        text += (word == 0 ? "" : word + 1 < words.size() ? ", " : " and ") + words[word];
    return text;
}

} // namespace osgLego
