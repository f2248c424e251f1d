#include <booklet/SimilarColors.h>

#include <PartModels.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A row of bricks of 1x1 in colours of LDraw, and one of 1x2 in the first of them. */
BookletModel createRow(const std::vector<std::int32_t>& codes)
{
    std::vector<Part> parts;
    BuildingStep step;
    const auto add = [&](std::int32_t code, std::uint8_t length)
    {
        const auto known = Palette::getKnownColors();
        const auto color =
            std::find_if(known.begin(), known.end(), [code](const PaletteColor& own) { return own.code == code; });
        step.parts.push_back(static_cast<std::uint32_t>(parts.size()));
        parts.push_back({{static_cast<std::uint16_t>(2 * parts.size()), 0, 0}, {length, 1, 1}, color->color, code});
    };
    for (const std::int32_t code : codes)
        add(code, 1);
    add(codes.front(), 2);
    const std::size_t number = parts.size();
    const auto bricks = BrickModel::createOfParts(test::createPartGrid({static_cast<int>(2 * number + 2), 1, 1}, 1.2),
                                                  std::move(parts));
    return {*bricks, *BuildingPlan::create(number, {step}), Palette::getKnownColors()};
}

/** The colours for which kinds are chosen. */
std::vector<std::string> chooseColors(const BookletModel& model, const std::set<std::size_t>& kinds)
{
    std::vector<std::string> colors;
    for (const std::size_t kind : SimilarColors(model).chooseKinds(kinds))
        colors.push_back(model.getKinds()[kind].color.name);
    std::sort(colors.begin(), colors.end());
    return colors;
}

} // namespace

TEST(SimilarColorsTest, BrownsAndDarkGreysAreNamedOnceEach)
{
    // Dark Brown, Reddish Brown, Black, Dark Bluish Grey, White.
    const BookletModel model = createRow({308, 70, 0, 72, 15});
    ASSERT_EQ(model.getKinds().size(), 6u) << "Dark Brown has two kinds";
    EXPECT_EQ(chooseColors(model, {0, 1, 2, 3, 4, 5}),
              (std::vector<std::string>{"Black", "Dark_Brown", "Reddish_Brown"}));
    for (std::size_t kind = 0; kind < 6; ++kind)
    {
        const std::string& name = model.getKinds()[kind].color.name;
        EXPECT_EQ(chooseColors(model, {kind}).empty(), name == "White" || name == "Dark_Bluish_Grey") << name;
    }
}

TEST(SimilarColorsTest, ColoursThatDifferMuchHaveNoNames)
{
    EXPECT_TRUE(chooseColors(createRow({4, 1, 14, 15}), {0, 1, 2, 3, 4}).empty()) << "red, blue, yellow, white";
}

} // namespace osgLego
