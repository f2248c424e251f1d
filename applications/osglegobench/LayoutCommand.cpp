#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "LayoutCase.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct LayoutCommandOptions : BenchOptions
{
    std::string assimp = "/usr/share/assimp/models";
    std::string boundsFile;
    double boundSeconds = 60.0;
    unsigned int numRuns = 5;
    std::vector<std::string> figures;
};

constexpr double ONE_SECOND = 1000.0;

MeshSource findAssimpMesh(const LayoutCommandOptions& options, const std::string& name, const std::string& path)
{
    const std::string file = options.assimp + "/" + path;
    if (!std::filesystem::exists(file))
        throw std::runtime_error("'" + file + "' is missing; expected the models of Debian's assimp-testmodels there");
    return {name, file, UpAxis::Z};
}

LegoSettings createSettings(unsigned int resolution, Effort effort, Fill fill)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    settings.grid.proportions = Proportions::BRICK;
    settings.parts.effort = effort;
    settings.parts.fill = fill;
    return settings;
}

/** The models that have goals. */
class CaseList
{
public:
    explicit CaseList(const LayoutCommandOptions& options) :
        _bunny(options.getMesh()), _duck(findAssimpMesh(options, "duck", "Collada/duck.dae")),
        _spider(findAssimpMesh(options, "spider", "OBJ/spider.obj"))
    {
        addOneColor();
        addColored();
    }

    /** For --quick, without models that are not built in. */
    static std::vector<LayoutCase> createQuick()
    {
        LegoSettings colored = createSettings(16, Effort::NORMAL, Fill::SURFACE);
        colored.colors.palette = "ldraw";
        LegoSettings plates = createSettings(12, Effort::INSTANT, Fill::SOLID);
        plates.grid.proportions = Proportions::PLATE;
        return {
            {"small", MeshSource(), createSettings(16, Effort::NORMAL, Fill::SOLID), {1.02, 0.06, ONE_SECOND, {}, {}}},
            {"colored", MeshSource(), colored, {1.02, 0.10, 2.0 * ONE_SECOND, {}, {}}},
            {"plates", MeshSource(), plates, {{}, {}, {}, {}, 0.6}}};
    }

    std::vector<LayoutCase> cases;

private:
    void add(const std::string& figure, const MeshSource& mesh, const LegoSettings& settings, const LayoutGoals& goals)
    {
        cases.push_back({figure, mesh, settings, goals});
    }

    void addOneColor()
    {
        const LayoutGoals small{1.02, 0.06, ONE_SECOND, {}, {}};
        add("small", _bunny, createSettings(12, Effort::NORMAL, Fill::SOLID), small);
        add("small", _duck, createSettings(11, Effort::NORMAL, Fill::SOLID), small);
        add("small", MeshSource(), createSettings(20, Effort::NORMAL, Fill::SOLID), small);
        for (const MeshSource& mesh : {_bunny, _duck, MeshSource()})
            for (const unsigned int resolution : {32u, 48u, 64u})
                add("surface", mesh, createSettings(resolution, Effort::NORMAL, Fill::SURFACE),
                    {1.01, 0.07, 2.0 * ONE_SECOND, {}, {}});
        add("solid", _bunny, createSettings(48, Effort::BEST, Fill::SOLID), {1.02, 0.03, 20.0 * ONE_SECOND, {}, {}});
        add("solid", _duck, createSettings(48, Effort::BEST, Fill::SOLID), {1.02, 0.03, 20.0 * ONE_SECOND, {}, {}});
        add("shell", _bunny, createSettings(48, Effort::NORMAL, Fill::SHELL), {{}, {}, {}, 0.03, {}});
        add("shell", _duck, createSettings(48, Effort::NORMAL, Fill::SHELL), {{}, {}, {}, 0.03, {}});
        LegoSettings plates = createSettings(48, Effort::BEST, Fill::SOLID);
        plates.grid.proportions = Proportions::PLATE;
        add("plates", _bunny, plates, {{}, {}, {}, {}, 0.6});
        add("medium", _bunny, createSettings(47, Effort::NORMAL, Fill::SOLID), {1.03, {}, ONE_SECOND, {}, {}});
        add("large", _bunny, createSettings(424, Effort::NORMAL, Fill::SURFACE), {1.06, {}, 10.0 * ONE_SECOND, {}, {}});
        add("live", _bunny, createSettings(64, Effort::INSTANT, Fill::SURFACE), {1.12, {}, 50.0, {}, {}});
    }

    void addColored()
    {
        for (const MeshSource& mesh : {MeshSource(), _duck, _spider})
        {
            LegoSettings settings = createSettings(48, Effort::NORMAL, Fill::SURFACE);
            settings.colors.palette = "ldraw";
            add("colored", mesh, settings, {1.02, 0.10, 2.0 * ONE_SECOND, {}, {}});
        }
    }

    MeshSource _bunny;
    MeshSource _duck;
    MeshSource _spider;
};

std::vector<LayoutCase> selectCases(const LayoutCommandOptions& options)
{
    const MeshSource checked = options.getMesh(); // also checks the file to write
    const std::vector<LayoutCase> all = options.isQuick ? CaseList::createQuick() : CaseList(options).cases;
    if (options.figures.empty()) return all;
    std::vector<LayoutCase> selected;
    std::string known;
    for (const LayoutCase& layoutCase : all)
    {
        if (std::find(options.figures.begin(), options.figures.end(), layoutCase.figure) != options.figures.end())
            selected.push_back(layoutCase);
        if (known.find("'" + layoutCase.figure + "'") == std::string::npos)
            known += (known.empty() ? "'" : ", '") + layoutCase.figure + "'";
    }
    if (selected.empty()) throw std::runtime_error("no figure is named so; expected some of " + known);
    return selected;
}

std::string formatRatio(const JsonValue& row)
{
    if (row.contains("ofPlates")) return fmt::format("{:.3f} of plates", row["ofPlates"].toNumber());
    if (!row.contains("ratio")) return "-";
    const JsonValue& bound = row["bound"];
    std::string text = fmt::format("{:.3f}", row["ratio"].toNumber());
    if (bound["layers"].toInteger() != bound["allLayers"].toInteger())
        text += fmt::format(", {} of {} layers", bound["layers"].toInteger(), bound["allLayers"].toInteger());
    if (const std::int64_t rest = bound["layers"].toInteger() - bound["optimalLayers"].toInteger(); rest > 0)
        text += fmt::format(", {} not proved", rest);
    return text;
}

void printRow(const JsonValue& row)
{
    fmt::print("| {} | {} {} | {} | {} | {} | {:.1f} % ({:.1f} %) | {} of {} | {:.1f} % | {} | {} | {} | {:.0f} |\n",
               row["figure"].toText(), row["mesh"].toText(), row["resolution"].toInteger(), row["cells"].toInteger(),
               row["parts"].toInteger(), formatRatio(row), 100.0 * row["stacked"].toNumber(),
               100.0 * row["stackedAtBorders"].toNumber(), row["components"].toInteger(),
               row["componentsPossible"].toInteger(), 100.0 * row["articulation"].toNumber(),
               row["floating"].toInteger(), row["colors"].toInteger(), row["unavailable"].toInteger(),
               row["milliseconds"]["median"].toNumber());
}

void printRows(const JsonValue& rows)
{
    fmt::print(
        "| figure | model | cells | parts | parts / bound | stacked (at borders) | components, possible "
        "| articulation | floating | colours | never made | ms |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const JsonValue& row : rows.getElements())
        printRow(row);
}

void printGoals(const JsonValue& rows)
{
    fmt::print("\n| figure | model | compared | measured | goal | verdict |\n|---|---|---|---|---|---|\n");
    std::size_t numGoals = 0;
    std::size_t numMissed = 0;
    for (const JsonValue& row : rows.getElements())
        for (const JsonValue& goal : row["goals"].getElements())
        {
            const bool isReached = goal["reached"].toBoolean();
            ++numGoals;
            numMissed += isReached ? 0 : 1;
            fmt::print("| {} | {} {} | {} | {:.4g} | at most {:.4g} | {} |\n", row["figure"].toText(),
                       row["mesh"].toText(), row["resolution"].toInteger(), goal["what"].toText(),
                       goal["figure"].toNumber(), goal["goal"].toNumber(), isReached ? "reached" : "MISSED");
        }
    fmt::print("\n{} goals, {} of them missed\n", numGoals, numMissed);
}

void runLayout(const LayoutCommandOptions& options)
{
    const std::vector<LayoutCase> cases = selectCases(options);
    BoundCache bounds(options.boundsFile);
    JsonValue document = createDocument("layout");
    for (const LayoutCase& layoutCase : cases)
    {
        fmt::print(stderr, "laying {} at {}, {}\n", layoutCase.mesh.name, layoutCase.settings.grid.resolution,
                   layoutCase.figure);
        const unsigned int numRuns = layoutCase.settings.parts.effort == Effort::INSTANT ? options.numRuns : 1;
        document["rows"].append(measureLayout(layoutCase, {numRuns, options.boundSeconds}, bounds));
    }
    if (!options.jsonFile.empty())
    {
        options.write(document);
        return;
    }
    printRows(document["rows"]);
    printGoals(document["rows"]);
}

} // namespace

void addLayoutCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "layout",
        "Layouts of parts: their number beside the least possible, joints, components, and the time, with verdicts");
    const auto options = std::make_shared<LayoutCommandOptions>();
    command.addFolder("--models", options->models, "Folder of bunny.ply (build/models)");
    command.addText("--assimp", options->assimp, "Folder of Debian's assimp-testmodels (" + options->assimp + ")",
                    "FOLDER");
    command.addNames("--figure", options->figures, "Only these figures, such as small,solid (all)");
    command.addText("--bounds", options->boundsFile,
                    "Keep the least numbers of parts there, which take minutes to compute (computed each time)",
                    "FILE");
    command.addNumber("--bound-seconds", options->boundSeconds,
                      "The seconds for each connected region of a layer, after which its bound is that of a linear "
                      "program (60)",
                      0.0, 86400.0);
    command.addNumber("--runs", options->numRuns, "Timed runs of layouts with effort=instant (5)", 1u, 10000u);
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (tables on standard output)", "FILE");
    command.setRun([options] { runLayout(*options); });
}

} // namespace osgLego
