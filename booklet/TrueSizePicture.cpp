#include "TrueSizePicture.h"

#include "BookletText.h"

#include <osgLego/BrickDimensions.h>

#include <algorithm>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

// Millimetres.
constexpr double TRUE_PITCH = 8.0;
constexpr double TRUE_PLATE = 3.2;
constexpr double TRUE_BRICK = 9.6;
constexpr double NAME_SPACE = 5.0;    // above each part
constexpr double NUMBERS_SPACE = 3.5; // below
constexpr double CAPTION_SPACE = 6.0;
constexpr double OUTLINE_WIDTH = 0.25; // half of it is beside the outline
constexpr double TRUE_STUD = BrickDimensions::STUD_HEIGHT * TRUE_PITCH;

double getTrueHeight(const PartType& type)
{
    return type.family == PartFamily::BRICK ? TRUE_BRICK : TRUE_PLATE;
}

double measureTypes(const std::vector<const PartType*>& types)
{
    double height = 0.0;
    for (const PartType* type : types)
        height += NAME_SPACE + TRUE_STUD + getTrueHeight(*type) + NUMBERS_SPACE;
    return height;
}

} // namespace

double measureTrueSize(const std::vector<const PartType*>& types)
{
    return CAPTION_SPACE + measureTypes(types);
}

std::string drawTrueSize(const std::vector<const PartType*>& types)
{
    constexpr double GAP = BrickDimensions::GAP * TRUE_PITCH;
    const int longest = (*std::max_element(types.begin(), types.end(),
                                           [](const PartType* a, const PartType* b) { return a->length < b->length; }))
                            ->length;
    const double width = longest * TRUE_PITCH + OUTLINE_WIDTH;
    const double height = measureTypes(types);
    std::string label;
    std::string content;
    double top = 0.0;
    for (const PartType* type : types)
    {
        label += (label.empty() ? "" : " and ") + type->getName();
        const double bottom = top + NAME_SPACE + TRUE_STUD + getTrueHeight(*type);
        content += fmt::format(R"(<text class="name" x="0" y="{:.2f}">{}</text><path d="M{:.2f} {:.2f}V{:.2f})",
                               top + NAME_SPACE - 1.5, nameType(*type), GAP, bottom, bottom - getTrueHeight(*type));
        for (int stud = 0; stud < type->length; ++stud)
        {
            const double middle = (stud + 0.5) * TRUE_PITCH;
            const double radius = BrickDimensions::STUD_RADIUS * TRUE_PITCH;
            content +=
                fmt::format("H{:.2f}v{:.2f}h{:.2f}v{:.2f}", middle - radius, -TRUE_STUD, 2.0 * radius, TRUE_STUD);
        }
        content += fmt::format("H{:.2f}V{:.2f}Z\"/>", type->length * TRUE_PITCH - GAP, bottom);
        for (int stud = 0; stud < type->length; ++stud)
            content += fmt::format(R"(<text x="{:.1f}" y="{:.2f}">{}</text>)", (stud + 0.5) * TRUE_PITCH,
                                   bottom + NUMBERS_SPACE - 0.7, stud + 1);
        top = bottom + NUMBERS_SPACE;
    }
    return fmt::format(
        R"(<svg role="img" aria-label="{} in true size" style="width:{:.2f}mm;height:{:.2f}mm" viewBox="{:.3f} 0 {:.2f} {:.2f}">{}</svg>)",
        label, width, height, -0.5 * OUTLINE_WIDTH, width, height, content);
}

} // namespace osgLego
