#include "BookletModels.h"
#include "FakePictures.h"

#include <booklet/BookletPage.h>

#include <PartModels.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Lines = std::vector<std::string>;

/** @param showsAll whether finished submodels show all their parts. */
std::string write(const BookletModel& model, const Lines& warnings = {}, bool showsAll = false)
{
    BookletFacts facts;
    facts.title = "Tower";
    facts.warnings = warnings;
    facts.endStep = model.getMainChapter().steps.size();
    FakePictures pictures(model);
    pictures.showsAll = showsAll;
    std::ostringstream stream;
    std::size_t numPictures = 0;
    BookletPage page(model, facts, pictures, [&](const std::string&) { ++numPictures; });
    page.write(stream);
    EXPECT_EQ(page.countPictures(), numPictures);
    return stream.str();
}

/** Replace everything from each `begin` to the following `end`. */
void replaceAll(std::string& text, const std::string& begin, const std::string& end, const std::string& replacement)
{
    for (std::size_t place = 0; (place = text.find(begin, place)) != std::string::npos; place += replacement.size())
        text.replace(place, text.find(end, place) + end.size() - place, replacement);
}

/** The words that a reader sees: without descriptions for screen readers, symbols, styles and scripts. */
std::string toVisibleText(std::string html)
{
    for (const auto& [begin, end] :
         {std::pair("<head>", "</head>"), std::pair("<script>", "</script>"),
          std::pair("<svg class=\"symbols\"", "</svg>"), std::pair("<svg class=\"arrows\"", "</svg>"),
          std::pair("<span class=\"hidden\">", "</span>"), std::pair("<h2 class=\"hidden\">", "</h2>")})
        replaceAll(html, begin, end, "");
    replaceAll(html, "<", ">", " ");
    std::replace(html.begin(), html.end(), '\n', ' ');
    html.erase(std::unique(html.begin(), html.end(), [](char a, char b) { return a == ' ' && b == ' '; }), html.end());
    return html;
}

/** The part of a page from an element with an id up to the next begin or end of a section. */
std::string findElement(const std::string& html, const std::string& id)
{
    const auto place = html.find("id=\"" + id + "\"");
    EXPECT_NE(place, std::string::npos) << id;
    const auto begin = html.rfind('<', place);
    return html.substr(begin, std::min(html.find("<section", place), html.find("</section", place)) - begin);
}

TEST(BookletPage, ShowsNumbersQuantitiesAndLettersInEachStep)
{
    const std::string html = write(createTower());
    const auto textOf = [&html](const std::string& id) { return toVisibleText(findElement(html, id)); };
    EXPECT_EQ(textOf("step-1"), " 1 2 parts 2× ") << "two red bricks of 2x4";
    EXPECT_EQ(textOf("step-2"), " 2 A ") << "its parts are in a submodel";
    EXPECT_EQ(textOf("step-3"), " 3 2 parts 1× 1× ") << "a red brick of 1x1 and a blue one of 2x4";
}

TEST(BookletPage, ShowsSubmodelsOfFewPartsInTheStepThatAttachesThem)
{
    const std::string html = write(createTower());
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-a")), " A 1× 1× A1 ");
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-b")), " B 1× B1 ");
    const auto step = html.find("id=\"step-2\"");
    EXPECT_LT(step, html.find("id=\"submodel-a\""));
    EXPECT_LT(html.find("id=\"submodel-a\""), html.find("id=\"submodel-b\""));
    EXPECT_LT(html.find("id=\"submodel-b\""), html.find("id=\"step-a2\"")) << "a step of A attaches B";
    EXPECT_LT(html.find("id=\"step-a2\""), html.find("id=\"step-3\""));
}

TEST(BookletPage, ShowsEqualSubmodelsOfAStepOnceWithTheirNumber)
{
    const std::string html = write(createTwins());
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-a")), " A 1× 1× A1 2× ");
    EXPECT_NE(html.find("alt=\"Step 2 of 3: adds 2 submodels A\""), std::string::npos);
    EXPECT_EQ(html.find("id=\"submodel-c\""), std::string::npos);
    const std::string arrows = html.substr(html.find("adds 2 submodels A"));
    EXPECT_NE(arrows.find("<text x=\"100\" y=\"35\" font-size=\"30\">A</text>"), std::string::npos);
    EXPECT_NE(arrows.find("<text x=\"200\" y=\"35\" font-size=\"30\">A</text>"), std::string::npos);
}

TEST(BookletPage, ShowsTheStepsOfSubmodelsOfManyPartsBeforeTheStepThatAttachesThem)
{
    const std::string html = write(createTwins());
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-b")), " B 5× ");
    EXPECT_EQ(toVisibleText(findElement(html, "step-b2")), " B2 1 part 1× ");
    EXPECT_EQ(toVisibleText(findElement(html, "step-3")), " 3 B B ") << "below its number, and in the list of parts";
    EXPECT_LT(html.find("id=\"submodel-b\""), html.find("id=\"step-b1\""));
    EXPECT_LT(html.find("id=\"step-b5\""), html.find("id=\"step-3\""));
}

TEST(BookletPage, ListsOfSubmodelsNameTheSubmodelsWithinThemInsteadOfTheirParts)
{
    // A brick on which A stands: two bricks, five of B, and one in the box of C.
    std::vector<Part> parts;
    for (std::uint16_t z = 0; z < 9; ++z)
        parts.push_back({{0, 0, z}, {2, 2, 1}, {180, 0, 0}, 4});
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, 9}, 1.2), parts);
    const Submodel outer{{createStep({1, 2}), createStep({}, {1}), createStep({}, {2})}};
    const Submodel inner{{createStep({3, 4, 5}), createStep({6, 7})}};
    const auto plan =
        BuildingPlan::create(9, {createStep({0}), createStep({}, {0})}, {outer, inner, {{createStep({8})}}});
    const std::string html = write({*bricks, *plan, Palette::getKnownColors()});
    const std::string list = findElement(html, "submodel-a");
    EXPECT_EQ(toVisibleText(list), " A B 3× ") << "the two bricks, and that of C";
    EXPECT_NE(list.find("aria-label=\"Submodel B\" style=\"--w:300\""), std::string::npos) << list;
    EXPECT_NE(list.find("<use href=\"#submodel-b-picture\"/>"), std::string::npos) << list;
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-b")), " B 5× ");
}

TEST(BookletPage, ShowsNoStepsOfSubmodelsOfFewPartsIfTheirPictureShowsAllParts)
{
    const std::string html = write(createTwins(), {}, true);
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-a")), " A 1× 1× 2× ");
    EXPECT_EQ(html.find("id=\"step-a1\""), std::string::npos);
    EXPECT_NE(html.find("id=\"step-b1\""), std::string::npos) << "too many parts for one picture";
    const std::string nested = write(createTower(), {}, true);
    EXPECT_NE(nested.find("id=\"step-a1\""), std::string::npos) << "its second step attaches a submodel";
    EXPECT_EQ(nested.find("id=\"step-b1\""), std::string::npos);
}

TEST(BookletPage, ShowsSubmodelsOfOneStepOnce)
{
    const std::string html = write(createTwins(false, true));
    EXPECT_EQ(html.find("id=\"submodel-b\""), std::string::npos) << "its list and picture would be those of its step";
    EXPECT_EQ(toVisibleText(findElement(html, "step-b1")), " B1 5 parts 5× ");
    EXPECT_NE(findElement(html, "step-3").find("<use href=\"#submodel-b-picture\"/>"), std::string::npos);
    EXPECT_NE(html.find("<symbol id=\"submodel-b-picture\""), std::string::npos);
}

TEST(BookletPage, ListsTheQuantityOfEachKindAndAllThatIsNeededToOrderIt)
{
    const std::string text = toVisibleText(findElement(write(createTower()), "parts"));
    EXPECT_NE(text.find("6 parts of 3 kinds"), std::string::npos) << text;
    // In the order of sizes and then of LDraw's codes, with the numbers of BrickLink.
    const auto one = text.find("1× Brick\u00a01\u202f×\u202f1 3005 Red BrickLink\u00a05 LDraw\u00a04");
    const auto blue = text.find("2× Brick\u00a02\u202f×\u202f4 3001 Blue BrickLink\u00a07 LDraw\u00a01");
    const auto red = text.find("3× Brick\u00a02\u202f×\u202f4 3001 Red BrickLink\u00a05 LDraw\u00a04");
    EXPECT_LT(one, blue) << text;
    EXPECT_LT(blue, red) << text;
    EXPECT_NE(red, std::string::npos) << text;
}

TEST(BookletPage, DescribesForScreenReadersAsManyPartsAsItShows)
{
    const std::string step = findElement(write(createTower()), "step-1");
    EXPECT_NE(step.find("aria-label=\"2 red bricks 2 x 4\""), std::string::npos) << step;
    EXPECT_NE(step.find("Step 1 of 3: adds 2 red bricks 2 x 4\""), std::string::npos) << step;
}

TEST(BookletPage, DescribesPicturesInSentences)
{
    const std::string step = findElement(write(createTower()), "step-3");
    EXPECT_NE(step.find("alt=\"Step 3 of 3: adds 1 red brick 1 x 1 and 1 blue brick 2 x 4\""), std::string::npos)
        << step;
}

TEST(BookletPage, TheCoverCountsTheStepsOfSubmodelsApart)
{
    // Three steps, two of submodel A and one of B.
    EXPECT_NE(toVisibleText(findElement(write(createTower()), "cover")).find("Steps 3, and 3 in submodels "),
              std::string::npos);
}

TEST(BookletPage, ListsABasePlateThatIsNoPartOfTheModel)
{
    const std::string plate = "1× Base plate 8\u202f×\u202f16 3865 Green, drawn smaller";
    const std::string onPlate = write(createTower({.base = BuildingBase::PLATE}));
    EXPECT_NE(toVisibleText(findElement(onPlate, "parts")).find(plate), std::string::npos);
    EXPECT_NE(onPlate.find("<dt>Parts</dt><dd>6</dd>"), std::string::npos);
    EXPECT_EQ(toVisibleText(write(createTower())).find("Base plate"), std::string::npos);
}

TEST(BookletPage, TheCoverNamesTheStepsOfAnExtract)
{
    const BookletModel model = createTower();
    BookletFacts facts;
    facts.firstStep = 1;
    facts.endStep = 3;
    FakePictures pictures(model);
    std::ostringstream stream;
    BookletPage(model, facts, pictures, [](const std::string&) {}).write(stream);
    EXPECT_NE(toVisibleText(findElement(stream.str(), "cover")).find("Steps 2 to 3 of 3 "), std::string::npos);
    EXPECT_EQ(stream.str().find("id=\"step-1\""), std::string::npos);
}

TEST(BookletPage, ShowsThePictureOfEachStepInIt)
{
    const std::string html = write(createTower());
    // "step 0-0", "step 0-2" and "step 1-1" in base64.
    EXPECT_NE(findElement(html, "step-1").find("c3RlcCAwLTA="), std::string::npos);
    EXPECT_NE(findElement(html, "step-3").find("c3RlcCAwLTI="), std::string::npos);
    EXPECT_NE(html.find("c3RlcCAxLTE="), std::string::npos);
}

TEST(BookletPage, SaysWhenTheBuilderMustHoldTheModelAndWhichPartsNothingHolds)
{
    const BookletModel model = createTower({.fallingSteps = {0}, .unheldParts = {5}});
    const std::string html = write(model);
    const auto textOf = [&html](const std::string& id) { return toVisibleText(findElement(html, id)); };
    EXPECT_EQ(textOf("step-1"), " 1 2 parts 2× Hold the model after this step: it does not stand by itself yet. ");
    EXPECT_EQ(textOf("step-2"), " 2 A ");
    EXPECT_EQ(textOf("step-3"), " 3 2 parts 1× 1× Nothing holds 1 part of this step. ");
}

TEST(BookletPage, SaysWhenTheBuilderMustHoldASubmodel)
{
    EXPECT_EQ(toVisibleText(findElement(write(createTwins(true)), "step-b2")),
              " B2 1 part 1× Hold the submodel after this step: it does not stand by itself yet. ");
}

TEST(BookletPage, CountsThePartsOfEachPage)
{
    const auto count = [](const BookletModel& model)
    {
        std::vector<int> numbers;
        const std::string html = write(model);
        const std::string begin = "class=\"sheet-parts\">";
        for (std::size_t place = 0; (place = html.find(begin, place)) != std::string::npos;)
        {
            place += begin.size();
            numbers.push_back(std::stoi(html.substr(place)));
        }
        return numbers;
    };
    for (const auto& [numbers, expected] : {std::pair(count(createTower()), 6), std::pair(count(createTwins()), 10)})
    {
        EXPECT_GT(numbers.size(), 1u);
        EXPECT_EQ(std::accumulate(numbers.begin(), numbers.end(), 0), expected) << "each part is on one page";
    }
}

TEST(BookletPage, NamesSimilarColoursOnTheirPages)
{
    EXPECT_EQ(write(createTower()).find("class=\"colors\""), std::string::npos) << "red and blue";
    const auto bricks =
        BrickModel::createOfParts(createPartGrid({8, 2, 1}, 1.2),
                                  {{{0, 0, 0}, {4, 2, 1}, {95, 49, 9}, 70}, {{4, 0, 0}, {4, 2, 1}, {53, 33, 0}, 308}});
    const std::string html =
        write({*bricks, *BuildingPlan::create(2, {createStep({0, 1})}), Palette::getKnownColors()});
    const std::string colors = html.substr(html.find("<ul class=\"colors\""));
    EXPECT_EQ(toVisibleText(colors.substr(0, colors.find("</footer>"))),
              " Reddish Brown Dark Brown 2 parts in these steps ");
}

TEST(BookletPage, ListsThePartsOfBags)
{
    // 201 bricks in a row: as many red ones of 2x4 as fit into the first bag, and others.
    std::vector<Part> parts;
    std::vector<BuildingStep> steps;
    for (std::uint32_t part = 0; part < 201; ++part)
    {
        const auto x = static_cast<std::uint16_t>(4 * part);
        parts.push_back({{x, 0, 0}, {4, 2, 1}, {180, 0, 0}, 4});
        if (part % 10 == 0) steps.emplace_back();
        steps.back().parts.push_back(part);
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({804, 2, 1}, 1.2), parts);
    const std::string html = write({*bricks, *BuildingPlan::create(201, steps), Palette::getKnownColors()});
    EXPECT_NE(toVisibleText(html).find(" Bag 1 of 2 100 parts of 1 kind 100× "), std::string::npos);
    EXPECT_NE(toVisibleText(html).find(" Bag 2 of 2 101 parts of 1 kind 101× "), std::string::npos);
    EXPECT_LT(html.find("id=\"bag-1\""), html.find("id=\"step-1\""));
    EXPECT_LT(html.find("id=\"step-10\""), html.find("id=\"bag-2\""));
    EXPECT_LT(html.find("id=\"bag-2\""), html.find("id=\"step-11\""));
    EXPECT_EQ(write(createTower()).find("id=\"bag-1\""), std::string::npos);
    // "place" in base64: the picture of the model in the header of each bag.
    EXPECT_NE(html.find("cGxhY2U=", html.find("id=\"bag-1\"")), std::string::npos);
    EXPECT_NE(html.find("cGxhY2U=", html.find("id=\"bag-2\"")), std::string::npos);
}

TEST(BookletPage, LongListsAreSmaller)
{
    // A brick on which a submodel of 60 kinds is attached: as many colours, one above another.
    std::vector<Part> parts{{{0, 0, 0}, {2, 2, 1}, {180, 0, 0}, 4}};
    Submodel submodel;
    for (std::uint32_t part = 1; part <= 60; ++part)
    {
        const auto shade = static_cast<std::uint8_t>(4 * part);
        parts.push_back({{0, 0, static_cast<std::uint16_t>(part)}, {2, 2, 1}, {shade, 0, 0}, Part::NO_CODE});
        if (part % 5 == 1) submodel.steps.emplace_back();
        submodel.steps.back().parts.push_back(part);
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, 61}, 1.2), parts);
    const auto plan = BuildingPlan::create(61, {createStep({0}), createStep({}, {0})}, {submodel});
    const std::string html = write({*bricks, *plan, Palette::getKnownColors()});
    const auto scaleOf = [&html](const std::string& id)
    {
        const std::string tag = html.substr(html.find("id=\"" + id + "\""), 200);
        return std::stod(tag.substr(tag.find("--scale:") + 8));
    };
    EXPECT_EQ(scaleOf("step-1"), 1.0);
    EXPECT_LT(scaleOf("submodel-a"), 0.8) << "20 rows of three, each a seventh of the sheet's height";
    EXPECT_GT(scaleOf("submodel-a"), 0.3);
}

TEST(BookletPage, ListsThatDoNotFitOnASheetAreDividedAndKeepTheirScale)
{
    // A brick on which a submodel of 180 kinds is attached, and 60 other kinds.
    std::vector<Part> parts;
    std::vector<BuildingStep> steps;
    Submodel submodel;
    for (std::uint32_t part = 0; part < 240; ++part)
    {
        const auto shade = static_cast<std::uint8_t>(part);
        parts.push_back({{0, 0, static_cast<std::uint16_t>(part)}, {2, 2, 1}, {shade, 0, 0}, Part::NO_CODE});
        std::vector<BuildingStep>& own = part < 60 ? steps : submodel.steps;
        if (part % 6 == 0) own.emplace_back();
        own.back().parts.push_back(part);
    }
    steps.push_back(createStep({}, {0}));
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, 240}, 1.2), parts);
    const auto plan = BuildingPlan::create(240, steps, {submodel});
    const std::string html = write({*bricks, *plan, Palette::getKnownColors()});
    const auto countItems = [&html](const std::string& begin, const std::string& end)
    {
        std::size_t number = 0;
        std::size_t numLists = 0;
        for (std::size_t place = 0; (place = html.find(begin, place)) != std::string::npos; ++numLists)
        {
            const std::size_t last = html.find(end, place);
            EXPECT_GE(std::stod(html.substr(html.find("--scale:", place) + 8)), 0.75) << "letters of 2 mm";
            for (; (place = html.find("<li>", place)) < last; ++place)
                ++number;
            place = last;
        }
        EXPECT_GT(numLists, 2u) << begin;
        return number;
    };
    EXPECT_EQ(countItems("<section class=\"submodel", "</section>"), 180u);
    EXPECT_EQ(countItems("<header class=\"bag", "</header>"), 240u);
    EXPECT_NE(toVisibleText(html).find("More parts of A"), std::string::npos);
}

TEST(BookletPage, ManyNamesOfColoursAreHigherAndStillLarge)
{
    // Fifty similar colours in one step, and a red and a blue part in another one.
    std::vector<Part> parts;
    std::vector<BuildingStep> steps(2);
    for (std::uint32_t part = 0; part < 52; ++part)
    {
        const auto shade = static_cast<std::uint8_t>(part);
        parts.push_back({{0, 0, static_cast<std::uint16_t>(part)}, {2, 2, 1}, {shade, shade, 90}, Part::NO_CODE});
        if (part >= 50) parts.back().color = {255, static_cast<std::uint8_t>(255 * (part % 2)), 0};
        steps[part < 50 ? 0 : 1].parts.push_back(part);
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, 52}, 1.2), parts);
    const std::string html = write({*bricks, *BuildingPlan::create(52, steps), Palette::getKnownColors()});
    const auto findNumber = [&html](const std::string& name, std::size_t place)
    { return std::stod(html.substr(html.find(name, place) + name.size())); };
    const std::size_t first = html.find("class=\"last-line\"");
    const std::size_t second = html.find("class=\"last-line\"", first + 1);
    // Each "#00005a" and its swatch take 14 mm, so that six are in a line of 93 mm, which is 2.1 mm high.
    EXPECT_GT(findNumber("--more:", first), 2.1 * 8 - 5.0);
    EXPECT_LT(findNumber("--more:", first), 2.5 * 10 - 5.0);
    EXPECT_GE(2.4 * findNumber("--scale:", first), 2.0);
    EXPECT_EQ(findNumber("--more:", second), 0.0);
}

TEST(BookletPage, SubmodelsOfMoreThan200PartsHaveNoListButThoseOfBags)
{
    std::vector<Part> parts;
    Submodel submodel;
    for (std::uint32_t part = 0; part < 201; ++part)
    {
        parts.push_back({{static_cast<std::uint16_t>(2 * part), 0, 0}, {2, 2, 1}, {180, 0, 0}, 4});
        if (part % 10 == 0) submodel.steps.emplace_back();
        submodel.steps.back().parts.push_back(part);
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({402, 2, 1}, 1.2), parts);
    const auto plan = BuildingPlan::create(201, {createStep({}, {0})}, {submodel});
    const std::string html = write({*bricks, *plan, Palette::getKnownColors()});
    EXPECT_EQ(toVisibleText(findElement(html, "submodel-a")), " A ");
    EXPECT_EQ(toVisibleText(findElement(html, "bag-2")), " Bag 2 of 2 101 parts of 1 kind 101× ");
    EXPECT_LT(html.find("id=\"step-a10\""), html.find("id=\"bag-2\""));
    EXPECT_LT(html.find("id=\"bag-2\""), html.find("id=\"step-a11\""));
}

TEST(BookletPage, ShowsThePartsOfASmallModelInTrueSize)
{
    EXPECT_NE(findElement(write(createTower()), "parts").find("aria-label=\"Brick 2 x 4 in true size\""),
              std::string::npos);
}

TEST(BookletPage, TheFinishedModelIsBesideTheLastSheetOnPaperThatHasTwo)
{
    for (const BookletModel& model : {createTower(), createTwins()})
    {
        const std::string html = write(model);
        std::size_t numSheets = 0;
        for (auto place = html.find("class=\"sheet\""); place != std::string::npos; ++numSheets)
            place = html.find("class=\"sheet\"", place + 1);
        EXPECT_EQ(html.find("class=\"finished beside\"") != std::string::npos, numSheets % 2 == 1) << numSheets;
    }
}

TEST(BookletPage, ShowsWarningsOnTheCover)
{
    const std::string cover = findElement(write(createTower(), {"It is <heavy>.", "It falls."}), "cover");
    EXPECT_NE(toVisibleText(cover).find("It is &lt;heavy&gt;. It falls."), std::string::npos) << cover;
}

TEST(BookletPage, TellsTheReaderToTurnTheModelBeforeStepsWithAnotherView)
{
    const std::string html = write(createTower({.turnsOfLastStep = 3, .isInnerUpsideDown = true}));
    EXPECT_EQ(findElement(html, "step-1").find("class=\"turn\""), std::string::npos);
    const std::string turned = findElement(html, "step-3");
    EXPECT_NE(turned.find("aria-label=\"Turn the model\"><use href=\"#turn\"/>"), std::string::npos) << turned;
    const std::string over = findElement(html, "submodel-b");
    EXPECT_NE(over.find("aria-label=\"Turn the model upside down\"><use href=\"#turn-over\"/>"), std::string::npos)
        << over;
}

TEST(BookletPage, DrawsAnArrowToEachSubmodelWithItsLetterIfThereAreSeveral)
{
    const auto arrowsOf = [](const std::string& html) { return html.substr(html.find("alt=\"Step 2 of 3")); };
    const std::string one = arrowsOf(write(createTower()));
    // A shaft as wide as the arrow and a head of three widths: from the tail at the top to the tip below.
    EXPECT_NE(one.find("<path d=\"M95 40L95 80L85 80L100 100L115 80L105 80L105 40Z\"/></svg>"), std::string::npos)
        << one;
    const std::string two = arrowsOf(write(createTower({.hasTwoSubmodels = true})));
    const auto first = two.find("<text x=\"100\" y=\"35\" font-size=\"30\">A</text>");
    const auto second = two.find("<text x=\"200\" y=\"35\" font-size=\"30\">B</text>");
    EXPECT_LT(first, second) << two;
    EXPECT_NE(second, std::string::npos) << two;
}

} // namespace

} // namespace osgLego::test
