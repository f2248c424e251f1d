#include "BookletText.h"

#include <common/ColorName.h>
#include <common/NumberText.h>

#include <algorithm>
#include <array>
#include <iterator>
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
    return spellGray(nameColor(color));
}

std::string spellGray(std::string name)
{
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
    return step.falls() && !chapter.isCallout()
               ? "Hold the " + nameBuilt(chapter) + " after this step: it does not stand by itself yet."
               : std::string();
}

std::string describePieces(const BookletChapter& chapter, const BookletStep& step, const std::string& advice)
{
    const auto own = std::find_if(chapter.steps.begin(), chapter.steps.end(),
                                  [&step](const BookletStep& other) { return other.numPlaced == step.numPlaced; });
    const bool isFirst = own == chapter.steps.begin() || std::prev(own)->numPieces <= 1;
    const auto joining =
        std::find_if(own, chapter.steps.end(), [](const BookletStep& other) { return other.numPieces <= 1; });
    const bool isSoon = joining != chapter.steps.end() && joining - own < 2;
    if (!isFirst || isSoon) return {};
    return "Pieces lie apart" + (joining == chapter.steps.end() ? "" : " until step " + joining->name) + ": " + advice;
}

std::string describeNotes(const BookletModel& model, const BookletChapter& chapter, const BookletStep& step)
{
    const auto describe = [&model](const std::vector<BookletItem>& items)
    {
        std::vector<std::string> words;
        words.reserve(items.size());
        for (const BookletItem& item : items)
            words.push_back(describeParts(model.getKinds()[item.kind], item.quantity));
        return joinWords(words);
    };
    std::string notes;
    const auto add = [&notes](const std::string& note)
    {
        if (!note.empty()) notes += (notes.empty() ? "" : " ") + note;
    };
    if (!step.joined.empty()) add("Join " + describe(step.joined) + " with the new parts above before you place them.");
    if (!step.pressed.empty()) add("Press " + describe(step.pressed) + " on from below.");
    add(describePieces(chapter, step, "place them by the squares on the table, each a stud wide."));
    add(describeHold(chapter, step));
    return notes;
}

std::string describeCount(const BookletModel& model, const BookletStep& step)
{
    constexpr std::size_t MOST_NAMED = 2;
    std::string text = step.numDirect > 0 ? countOf(step.numDirect, "part") : std::string();
    const auto add = [&text](const std::string& added) { text += (text.empty() ? "" : " + ") + added; };
    const std::vector<std::size_t> originals = model.getOriginals(step);
    if (originals.size() > MOST_NAMED)
        add(countOf(step.submodels.size(), "submodel"));
    else
        for (const std::size_t submodel : originals)
        {
            const BookletChapter& own = model.getChapters()[submodel];
            add((own.quantity > 1 ? std::to_string(own.quantity) + " × " : "") + own.letter);
        }
    return text;
}

std::string joinWords(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t word = 0; word < words.size(); ++word)
        text += (word == 0 ? "" : word + 1 < words.size() ? ", " : " and ") + words[word];
    return text;
}

} // namespace osgLego
