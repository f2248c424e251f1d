#include "BookletModels.h"

#include <booklet/BookletText.h>
#include <booklet/BookletWords.h>

#include <common/RacingCar.h>
#include <osgLego/BuildingPlanner.h>
#include <osgLego/CpuLegolizer.h>

#include <PartModels.h>
#include <Settings.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

std::string write(const BookletModel& model, const BuildingView& front = {})
{
    std::ostringstream stream;
    BookletWords(model, front).write(stream, "Tower");
    return stream.str();
}

/** A part in words, and its lowest cell and size, or those of a submodel. */
struct Built
{
    std::string type;
    glm::ivec3 first{0};
    glm::ivec3 size{0};

    std::string toText() const
    {
        std::ostringstream text;
        text << first.z << ' ' << first.y << ' ' << first.x << ' ' << size.x << 'x' << size.y << 'x' << size.z << ' '
             << type;
        return text.str();
    }
};

/** Builds a model from the text alone, as a reader does: line by line, and submodels apart. */
class Reader
{
public:
    explicit Reader(const std::string& text) : _stream(text)
    {
        _chapters.emplace_back();
        for (std::string line; std::getline(_stream, line);)
            readLine(line);
    }

    /** @param numTurns quarter turns of the model, counter-clockwise from above. */
    std::vector<std::string> getParts(int numTurns = 0) const
    {
        std::vector<std::string> parts;
        for (const Built& part : turn(_chapters.front(), numTurns))
            parts.push_back(part.toText());
        std::sort(parts.begin(), parts.end());
        return parts;
    }

private:
    void readLine(const std::string& line)
    {
        static const std::regex part(R"(([A-Z]*\d+\.\d+): ([^,.]*)(?:, from [a-z ]*)?\. Columns? (\d+)(?: to (\d+))?, )"
                                     R"(rows? (\d+)(?: to (\d+))?, layers? (\d+)(?: to (\d+))?\.(.*))");
        static const std::regex submodel(R"(Submodel ([A-Z]+), of \d+ parts?\. Build it apart(?:, \d+ times)?\.)");
        static const std::regex attached(
            R"(Submodel ([A-Z]+)(?:, copy \d+)?(?:, turned by (\d+) degrees counter-clockwise as seen from above)?: )"
            R"(its .* comes? to column (\d+), row (\d+), layer (\d+)\..*)");
        static const std::regex finished(R"(Submodel ([A-Z]+) is finished\.)");
        std::smatch found;
        const auto number = [&found](std::size_t group) { return std::stoi(found[group]); };
        const auto last = [&found, &number](std::size_t group)
        { return found[group].matched ? number(group) : number(group - 1); };
        if (std::regex_match(line, found, part))
        {
            const glm::ivec3 first(number(3), number(5), number(7));
            const glm::ivec3 end(last(4), last(6), last(8));
            _chapters.back().push_back({found[2], first, end - first + 1});
            _places[found[1]] = first;
            checkEdges(first, found[9]);
        }
        else if (std::regex_match(line, submodel))
            _chapters.emplace_back();
        else if (std::regex_match(line, found, finished))
        {
            _submodels[found[1]] = _chapters.back();
            _chapters.pop_back();
        }
        else if (std::regex_match(line, found, attached))
            for (Built own : turn(_submodels.at(found[1]), found[2].matched ? number(2) / 90 : 0))
            {
                own.first += glm::ivec3(number(3), number(4), number(5)) - 1;
                _chapters.back().push_back(own);
            }
    }

    /** A submodel after quarter turns, counter-clockwise from above. */
    static std::vector<Built> turn(std::vector<Built> parts, int numTurns)
    {
        for (; numTurns > 0; --numTurns)
        {
            int depth = 0;
            for (const Built& part : parts)
                depth = std::max(depth, part.first.y + part.size.y);
            for (Built& part : parts)
            {
                part.first = {depth - part.first.y - part.size.y + 1, part.first.x, part.first.z};
                std::swap(part.size.x, part.size.y);
            }
        }
        return parts;
    }

    /** The edges beside a part in place, of the same chapter, lead to the same place. */
    void checkEdges(const glm::ivec3& first, const std::string& text)
    {
        static const std::regex edges(
            R"(.*Its left edge is (level with|(\d+) studs? (right|left) of) that of (\S+)(?: of copy \d+)?, )"
            R"(its front edge (level with|(\d+) studs? (behind|in front of)) that of (\S+)(?: of copy \d+)?\.)");
        std::smatch found;
        if (!std::regex_match(text, found, edges)) return;
        ++numEdges;
        const auto place = _places.find(found[4]);
        if (place == _places.end() || found[4].str()[0] > '9') return; // a submodel counts its own columns
        const int right = found[2].matched ? std::stoi(found[2]) * (found[3] == "right" ? 1 : -1) : 0;
        const int behind = found[6].matched ? std::stoi(found[6]) * (found[7] == "behind" ? 1 : -1) : 0;
        EXPECT_EQ(first.x, place->second.x + right) << text;
        EXPECT_EQ(first.y, place->second.y + behind) << text;
    }

    std::istringstream _stream;
    std::vector<std::vector<Built>> _chapters; // those that are being built, the innermost last
    std::map<std::string, std::vector<Built>> _submodels;
    std::map<std::string, glm::ivec3> _places;

public:
    int numEdges = 0;
};

/** The parts of a model with z upwards, as Reader gives them. */
std::vector<std::string> partsOf(const BrickModel& model, const PartsList& list)
{
    glm::ivec3 lowest(1 << 20);
    for (const Part& part : model.getParts())
        lowest = glm::min(lowest, part.getCell());
    const std::vector<std::size_t> rows = list.findRows(model);
    std::vector<std::string> parts;
    for (std::size_t part = 0; part < model.getParts().size(); ++part)
    {
        const Part& own = model.getParts()[part];
        parts.push_back(
            Built{describeParts(list.getRows()[rows[part]], 1).substr(2), own.getCell() - lowest + 1, own.getSize()}
                .toText());
    }
    std::sort(parts.begin(), parts.end());
    return parts;
}

/** On a plate of bricks, four submodels of a brick 2x3 with two of 1x1 on it, each turned by a quarter from the one
 * before, and a brick 1x1 on the last one. */
class TurnedCopies
{
public:
    explicit TurnedCopies(UpAxis up) : _up(up)
    {
        for (const int y : {0, 2, 4, 6})
            for (const int x : {0, 8})
                add({x, y, 0}, {8, 2, 1});
        const std::vector<glm::ivec3> corners{{0, 0, 1}, {1, 0, 1}, {2, 1, 1}, {0, 2, 1}};
        const std::vector<glm::ivec3> others{{1, 0, 1}, {1, 1, 1}, {1, 1, 1}, {0, 1, 1}};
        for (std::size_t index = 0; index < corners.size(); ++index)
        {
            const glm::ivec3 place(4 * static_cast<int>(index), 2, 1);
            add(place, index % 2 == 0 ? glm::ivec3(3, 2, 1) : glm::ivec3(2, 3, 1));
            add(place + corners[index], glm::ivec3(1));
            add(place + others[index], glm::ivec3(1));
        }
        add({12, 4, 3}, glm::ivec3(1));
    }

    BookletModel createModel() const
    {
        const auto bricks = BrickModel::createOfParts(
            createPartGrid(_up == UpAxis::Z ? glm::ivec3(16, 8, 4) : glm::ivec3(16, 4, 8), 1.2, _up), _parts);
        const auto find = [&](std::size_t part)
        { return static_cast<std::uint32_t>(bricks->findPart(_parts[part].getCell()) - bricks->getParts().data()); };
        constexpr std::size_t FIRST = 8; // part of the submodels
        constexpr std::size_t LAST = 20; // part of all
        std::vector<Submodel> submodels;
        for (std::size_t index = FIRST; index < LAST; index += 3)
            submodels.push_back({{createStep({find(index), find(index + 1), find(index + 2)})}});
        BuildingStep first;
        for (std::size_t index = 0; index < FIRST; ++index)
            first.parts.push_back(find(index));
        const auto plan = BuildingPlan::create(
            _parts.size(), {first, createStep({}, {0, 1, 2, 3}), createStep({find(LAST)})}, submodels);
        return {*bricks, *plan, Palette::getKnownColors()};
    }

    /** As Reader gives them. */
    std::vector<std::string> getParts() const
    {
        std::vector<std::string> texts = _texts;
        std::sort(texts.begin(), texts.end());
        return texts;
    }

private:
    /** @param lower the column, row and layer, from 0. */
    void add(const glm::ivec3& lower, const glm::ivec3& size)
    {
        // Of a grid with y upwards, rows count from the front, to which z points.
        const bool isZ = _up == UpAxis::Z;
        const glm::ivec3 cell = isZ ? lower : glm::ivec3(lower.x, lower.z, 8 - lower.y - size.y);
        const glm::ivec3 cells = isZ ? size : glm::ivec3(size.x, size.z, size.y);
        Part part;
        for (std::size_t axis = 0; axis < part.cell.size(); ++axis)
        {
            part.cell[axis] = static_cast<std::uint16_t>(cell[static_cast<int>(axis)]);
            part.size[axis] = static_cast<std::uint8_t>(cells[static_cast<int>(axis)]);
        }
        part.color = {180, 0, 0};
        part.colorCode = 4;
        _parts.push_back(part);
        const auto [least, most] = std::minmax(size.x, size.y);
        _texts.push_back(Built{fmt::format("red brick {} x {}", least, most), lower + 1, size}.toText());
    }

    UpAxis _up;
    std::vector<Part> _parts;
    std::vector<std::string> _texts;
};

} // namespace

TEST(BookletWordsTest, SaysWhereEachPartIsAndWhatItIsOn)
{
    const std::string text = write(createTower());
    for (const char* line :
         {"The model is 6 studs wide, 4 studs deep and 3 layers high. It has 6 parts in 3 steps, and 3 steps in "
          "submodels.\n",
          "3 red bricks 2 x 4.\n", "\nStep 1 of 3. Add 2 parts.\n",
          "1.1: red brick 2 x 4, from front to back. Columns 1 to 2, rows 1 to 4, layer 1. On the table.\n",
          "\nSubmodel A, of 2 parts. Build it apart.\n", "\nSubmodel B, of 1 part. Build it apart.\n",
          "Submodel B: its column 1, row 1 and layer 1 come to column 1, row 3, layer 1. On the table.\n",
          "Submodel A: its column 1, row 1 and layer 1 come to column 2, row 1, layer 2. On 1.1 and 1.2.\n",
          "3.1: blue brick 2 x 4, from left to right. Columns 2 to 5, rows 2 to 3, layer 3. On A1.1 and B1.1. Its left "
          "edge is level with that of A1.1, its front edge 1 stud behind that of A1.1.\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "is not in\n" << text;
}

TEST(BookletWordsTest, LayersAreThoseOfBricksIfThereIsNothingElse)
{
    // Bricks in a grid of plates, from its second layer on.
    std::vector<Part> parts{{{0, 0, 1}, {2, 2, 3}, RED, 4}, {{0, 0, 4}, {2, 2, 3}, RED, 4}};
    const auto describe = [&]
    {
        const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, 8}, 0.4), parts);
        const auto plan = BuildingPlan::create(2, {createStep({0}), createStep({1})});
        return write({*bricks, *plan, Palette::getKnownColors()});
    };
    const std::string text = describe();
    EXPECT_NE(text.find("2 studs deep and 2 layers high."), std::string::npos) << text;
    EXPECT_NE(text.find("A layer is as high as a brick.\n"), std::string::npos) << text;
    EXPECT_NE(text.find("rows 1 to 2, layer 2. On 1.1."), std::string::npos) << text;

    parts[1] = {{0, 0, 4}, {2, 2, 1}, RED, 4}; // a plate
    const std::string mixed = describe();
    EXPECT_NE(mixed.find("2 studs deep and 4 layers high."), std::string::npos) << mixed;
    EXPECT_NE(mixed.find("A layer is as high as a plate.\n"), std::string::npos) << mixed;
    EXPECT_NE(mixed.find("rows 1 to 2, layers 1 to 3. On the table."), std::string::npos) << mixed;
    EXPECT_NE(write(createTower()).find("A layer is as high as a brick.\n"), std::string::npos);
}

TEST(BookletWordsTest, SaysBelowWhichPartsASubmodelHangs)
{
    // A beam on a pillar, from which a submodel of two bricks hangs.
    std::vector<Part> parts;
    for (const std::uint16_t z : std::vector<std::uint16_t>{0, 1})
        for (const std::uint16_t x : std::vector<std::uint16_t>{0, 4})
            parts.push_back({{x, 0, z}, {2, 2, 1}, RED, 4});
    parts.push_back({{0, 0, 2}, {6, 2, 1}, BLUE, 1});
    Submodel hanging;
    hanging.steps = {createStep({1}), createStep({3})};
    const auto plan =
        BuildingPlan::create(5, {createStep({0}), createStep({2}), createStep({4}), createStep({}, {0})}, {hanging});
    const auto bricks = BrickModel::createOfParts(createPartGrid({6, 2, 3}, 1.2), parts);
    const std::string text = write({*bricks, *plan, Palette::getKnownColors()});
    EXPECT_NE(text.find("come to column 5, row 1, layer 1. Below 3.1.\n"), std::string::npos) << text;
}

TEST(BookletWordsTest, SaysWhereTheModelStandsOnABasePlate)
{
    const std::string text = write(createTower({.base = BuildingBase::PLATE}));
    for (const char* line :
         {"1 green base plate 8 x 16.\n",
          "The model stands on the base plate: on its columns 6 to 11 and rows 3 to 6.\n",
          "1.1: red brick 2 x 4, from front to back. Columns 1 to 2, rows 1 to 4, layer 1. On the base plate.\n",
          "B1.1: red brick 2 x 4, from left to right. Columns 1 to 4, rows 1 to 2, layer 1. On the table.\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "is not in\n" << text;
}

TEST(BookletWordsTest, CountsTheStepsOfTheModelAndThoseOfSubmodelsApart)
{
    const std::string text = write(createTower());
    EXPECT_NE(text.find("It has 6 parts in 3 steps, and 3 steps in submodels.\n"), std::string::npos) << text;
    EXPECT_NE(text.find("Step 1 of 3."), std::string::npos);
    const std::vector<Part> parts{{{0, 0, 0}, {2, 2, 1}, {180, 0, 0}, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, 1}, 1.2), parts);
    const std::string one = write({*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors()});
    EXPECT_NE(one.find("It has 1 part in 1 step.\n"), std::string::npos) << one;
}

TEST(BookletWordsTest, SaysWhetherTheModelOrASubmodelMustBeHeld)
{
    EXPECT_NE(write(createTower({.fallingSteps = {0}})).find("Hold the model, it does not stand by itself yet.\n"),
              std::string::npos);
    const std::string text = write(createTwins(true));
    EXPECT_NE(text.find("Hold the submodel, it does not stand by itself yet.\n", text.find("Step B2 of 5.")),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("Hold the model"), std::string::npos);
}

TEST(BookletWordsTest, SaysUntilWhichStepPiecesLieApart)
{
    // Two bricks, one on each of them, and a beam on both.
    const auto bricks = BrickModel::createOfParts(createPartGrid({4, 1, 3}, 1.2), {{{0, 0, 0}, {1, 1, 1}, RED, 4},
                                                                                   {{3, 0, 0}, {1, 1, 1}, RED, 4},
                                                                                   {{0, 0, 1}, {1, 1, 1}, RED, 4},
                                                                                   {{3, 0, 1}, {1, 1, 1}, RED, 4},
                                                                                   {{0, 0, 2}, {4, 1, 1}, RED, 4}});
    const auto describe = [&](BuildingBase base)
    {
        const auto plan =
            BuildingPlan::create(5, {createStep({0, 1}), createStep({2}), createStep({3}), createStep({4})});
        return write({*bricks, *plan, Palette::getKnownColors(), base});
    };
    const std::string text = describe(BuildingBase::TABLE);
    const std::string note = "Pieces lie apart until step 4: keep to their columns and rows.\n";
    const std::size_t place = text.find(note);
    EXPECT_LT(text.find("\n1.2: "), place) << text;
    EXPECT_LT(place, text.find("\nStep 2 of 4.")) << text;
    EXPECT_EQ(text.find(note, place + 1), std::string::npos) << text;
    EXPECT_EQ(describe(BuildingBase::PLATE).find("lie apart"), std::string::npos);
}

TEST(BookletWordsTest, DescribesEqualSubmodelsOfAStepOnce)
{
    const std::string text = write(createTwins());
    for (const char* line :
         {"\nSubmodel A, of 2 parts. Build it apart, 2 times.\n",
          "Submodel A, copy 1: its column 1, row 1 and layer 1 come to column 1, row 1, layer 2. On 1.1.\n",
          "Submodel A, copy 2: its column 1, row 1 and layer 1 come to column 3, row 1, layer 2. On 1.1.\n",
          "\nSubmodel B, of 5 parts. Build it apart.\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "is not in\n" << text;
    EXPECT_EQ(text.find("Submodel A is finished."), text.rfind("Submodel A is finished."));
}

TEST(BookletWordsTest, NamesThePartsOfCopies)
{
    // A beam on both of two equal submodels of one brick.
    const auto bricks =
        BrickModel::createOfParts(createPartGrid({8, 2, 3}, 1.2), {{{0, 0, 0}, {8, 2, 1}, {180, 0, 0}, 4},
                                                                   {{0, 0, 1}, {2, 2, 1}, {180, 0, 0}, 4},
                                                                   {{4, 0, 1}, {2, 2, 1}, {180, 0, 0}, 4},
                                                                   {{0, 0, 2}, {6, 2, 1}, {180, 0, 0}, 4}});
    const auto plan = BuildingPlan::create(4, {createStep({0}), createStep({}, {0, 1}), createStep({3})},
                                           {{{createStep({1})}}, {{createStep({2})}}});
    const std::string text = write({*bricks, *plan, Palette::getKnownColors()});
    EXPECT_NE(
        text.find("3.1: red brick 2 x 6, from left to right. Columns 1 to 6, rows 1 to 2, layer 3. On A1.1 of copy 1 "
                  "and A1.1 of copy 2."),
        std::string::npos)
        << text;
    EXPECT_EQ(Reader(text).getParts().size(), 4u);
}

TEST(BookletWordsTest, TurnsCopies)
{
    for (const UpAxis up : {UpAxis::Z, UpAxis::Y})
    {
        const TurnedCopies copies(up);
        const BookletModel model = copies.createModel();
        const std::string text = write(model);
        EXPECT_NE(text.find("Build it apart, 4 times."), std::string::npos) << text;
        EXPECT_NE(text.find("layer 4. On A1.2 of copy 4."), std::string::npos) << text;
        for (const char* degrees : {"90", "180", "270"})
            EXPECT_NE(text.find(std::string(", turned by ") + degrees), std::string::npos) << text;
        EXPECT_EQ(Reader(text).getParts(), copies.getParts()) << text;
    }
}

TEST(BookletWordsTest, TheFrontIsTheSideNearestToTheView)
{
    // Turning a model back by the quarter turns of its front, from the front to the right, gives the same model.
    for (const auto& [azimuth, turns] : std::vector<std::pair<double, int>>{
             {44.0, 0}, {46.0, 1}, {120.0, 1}, {210.0, 2}, {300.0, 3}, {-60.0, 3}, {670.0, 3}})
        for (const UpAxis up : {UpAxis::Z, UpAxis::Y})
        {
            const TurnedCopies copies(up);
            const BookletModel model = copies.createModel();
            const std::string text = write(model, {azimuth, 30.0});
            EXPECT_EQ(Reader(text).getParts(turns), copies.getParts()) << azimuth;
            EXPECT_NE(text.find(turns % 2 == 0 ? "The model is 16 studs wide, 8 studs deep"
                                               : "The model is 8 studs wide, 16 studs deep"),
                      std::string::npos)
                << text;
        }
}

TEST(BookletWordsTest, TheBasePlateTurnsWithTheView)
{
    // Three columns and one row: the margins at both sides differ.
    const auto bricks =
        BrickModel::createOfParts(createPartGrid({3, 1, 1}, 1.2), {{{0, 0, 0}, {3, 1, 1}, {180, 0, 0}, 4}});
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors(),
                             BuildingBase::PLATE);
    const auto find = [&](double azimuth)
    {
        const std::string text = write(model, {azimuth, 30.0});
        const std::string start = "The model stands on the base plate: on its ";
        const std::size_t place = text.find(start) + start.size();
        return text.substr(place, text.find('\n', place) - place);
    };
    // Of a base plate of 16 columns and 8 rows.
    EXPECT_EQ(find(30.0), "columns 7 to 9 and row 4.");
    EXPECT_EQ(find(120.0), "column 4 and rows 8 to 10.");
    EXPECT_EQ(find(210.0), "columns 8 to 10 and row 5.");
    EXPECT_EQ(find(300.0), "column 5 and rows 7 to 9.");
}

TEST(BookletWordsTest, WritesOnlySomeSteps)
{
    const BookletModel tower = createTower();
    std::ostringstream stream;
    BookletWords words(tower);
    words.setSteps(1, 2);
    words.write(stream, "Tower");
    const std::string text = stream.str();
    EXPECT_NE(text.find("\nOnly step 2 follows.\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nStep 2 of 3."), std::string::npos);
    for (const char* other : {"\nStep 1 of 3.", "\nStep 3 of 3.", "The model is finished."})
        EXPECT_EQ(text.find(other), std::string::npos) << other;
}

TEST(BookletWordsTest, AModelCanBeBuiltFromTheTextAlone)
{
    for (const char* settings : {"20,proportions=brick,parts=bricks", "16,proportions=plate,parts=bricks"})
    {
        const osg::ref_ptr<const BrickModel> bricks = legolizeOnCpu(*createRacingCar(), parseSettings(settings));
        PlanningOptions options;
        options.checksStability = false;
        const BookletModel model(*bricks, *planBuilding(*bricks, options), Palette::getKnownColors());
        ASSERT_GT(model.getChapters().size(), 1u) << "there are submodels";
        const Reader reader(write(model));
        EXPECT_EQ(reader.getParts(), partsOf(*bricks, model.getPartsList()));
        EXPECT_GT(reader.numEdges, 20);
    }
}

} // namespace osgLego::test
