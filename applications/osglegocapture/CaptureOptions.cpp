#include "CaptureOptions.h"

#include "ArgumentCheck.h"
#include "ExitCode.h"
#include "OptionReaders.h"
#include "SettingsHelp.h"

#include <cstdio>
#include <limits>

#include <osgDB/FileNameUtils>
#include <osgLego/ModelDesigner.h>
#include <osgLego/PlanningOptions.h>

#include <CLI/CLI.hpp>

namespace osgLego
{

namespace
{

/** Read the settings of the bricks; for --build, the others get values that suit parts. */
void readSettings(CaptureOptions& options)
{
    LegoSettings settings;
    if (!options.build.empty())
    {
        settings.parts.set = PartSet::BRICKS;
        settings.grid.proportions = Proportions::BRICK;
    }
    std::string error = findKeyOfOption(options.settingsText);
    if (!error.empty()) throw CLI::ValidationError("--legolize: " + error);
    const bool isEmpty = options.settingsText.empty() && !options.build.empty();
    if (!isEmpty && !LegoSettings::parse(options.settingsText, settings, error))
        throw CLI::ValidationError("--legolize: " + error);
    if (!options.build.empty() && settings.parts.set == PartSet::NONE)
        throw CLI::ValidationError("--legolize: parts=none gives no parts to build; expected parts=bricks");
    if (!options.build.empty() && (settings.view.progress < 1.0 || settings.view.show != Show::COLOR))
        throw CLI::ValidationError("--legolize: --build shows the whole model in its colours; expected no progress and "
                                   "no show");
    options.settings = settings;
}

/** Throws if --bound has no parts to count. The settings of a mesh that was given without --legolize are not known
 * before it is read. */
void checkBound(const CaptureOptions& options)
{
    if (options.original) throw CLI::ValidationError("--original has no parts; expected --bound without --original");
    if (!options.needsContext())
        throw CLI::ValidationError(
            "--bound has no report to appear in; expected one or more of -o, --stats, --cells and --compare");
    const bool isKnown = options.settings || options.mesh.empty();
    const LegoSettings settings = options.settings.value_or(LegoSettings());
    if (isKnown && (settings.parts.set == PartSet::NONE || settings.grid.proportions != Proportions::BRICK))
        throw CLI::ValidationError(
            "--bound counts bricks; expected parts=bricks and proportions=brick among the settings of --legolize");
}

/** Throws if a booklet can't be seen from the view. */
void checkInstructionsView(const CaptureOptions& options)
{
    const double elevation = options.view.elevation;
    if (options.isViewGiven && (elevation < BuildingView::LEAST_ELEVATION || elevation > BuildingView::MOST_ELEVATION))
        throw CLI::ValidationError("a booklet shows studs and layers; expected 10 to 80 degrees of elevation in --view "
                                   "with --instructions or --build");
}

/** Throws if options of a booklet can't be combined with others. */
void checkInstructions(const CaptureOptions& options)
{
    if (options.instructions.empty() && options.bookletSteps)
        throw CLI::ValidationError("--steps has no booklet; expected --instructions with it");
    if (!options.instructions.empty()) checkInstructionsView(options);
    if (options.instructions.empty() && !(options.title + options.author + options.license).empty())
        throw CLI::ValidationError(
            "--title, --author and --license have no booklet; expected --instructions or --build with them");
    if (options.instructions.empty() && options.isBookletConfirmed)
        throw CLI::ValidationError("--yes has no booklet; expected --instructions or --build with it");
    if (options.original && !options.instructions.empty())
        throw CLI::ValidationError("--original has no parts; expected --instructions without --original");
}

/** Throws if options of --build can't be combined with others. */
void checkBuild(const CaptureOptions& options)
{
    if (options.build.empty() && (options.buildParts || options.buildLength))
        throw CLI::ValidationError("--parts and --length have no model to choose; expected --build with them");
    if (options.build.empty()) return;
    if (options.buildParts && options.buildLength)
        throw CLI::ValidationError("--parts and --length both determine the size of the model; expected one of them");
    if (options.needsContext() || !options.partsList.empty() || !options.instructions.empty() || options.bound ||
        options.original || options.bookletSteps)
        throw CLI::ValidationError(
            "--build writes a picture, lists and instructions with names of its own; expected it "
            "without -o, --stats, --cells, --parts-list, --instructions, --steps, --bound, --original and --compare");
    if (!options.loads.empty() || options.tilt)
        throw CLI::ValidationError(
            "--load and --tilt judge a model that exists; expected them in a second command, with "
            "the .mpd file that --build writes and --base");
    if (options.buildParts.value_or(0) > CaptureOptions::MOST_PARTS_UNASKED && !options.isBookletConfirmed)
        throw CLI::ValidationError("a booklet of more than 2,000 parts is large; expected --yes with such --parts");
    if (osgDB::getLowerCaseFileExtension(options.mesh) == "legolize")
        throw CLI::ValidationError("--build chooses settings; expected MESH without .legolize, and settings to keep in "
                                   "--legolize");
}

/** Throws if options can't be combined. */
void checkCombination(const CaptureOptions& options, bool hasThreshold)
{
    if (hasThreshold && options.reference.empty())
        throw CLI::ValidationError("--threshold has nothing to compare; expected --compare with it");
    if (!options.readerOptions.empty() && options.mesh.empty())
        throw CLI::ValidationError("-O has no mesh to read; expected MESH with it");
    checkBuild(options);
    if (!options.build.empty()) return checkInstructionsView(options);
    if (options.tilt && !options.base) throw CLI::ValidationError("--tilt has no base; expected --base with it");
    if (!options.loads.empty() && !options.base)
        throw CLI::ValidationError("--load has nothing to stand on; expected --base with it");
    if (!options.needsContext() && options.partsList.empty() && options.instructions.empty() && !options.base)
        throw CLI::ValidationError("nothing to do; expected one or more of -o, --stats, --cells, --parts-list, --base, "
                                   "--instructions, --build and --compare");
    checkInstructions(options);
    if (options.original && !options.cells.empty())
        throw CLI::ValidationError("--original has no cells; expected --cells without --original");
    if (options.original && !options.partsList.empty())
        throw CLI::ValidationError("--original has no parts; expected --parts-list without --original");
    if (options.original && options.base)
        throw CLI::ValidationError("--original has no parts; expected --base without --original");
    if (options.bound) checkBound(options);
    if (options.statistics == CaptureOptions::STANDARD_OUTPUT && options.partsList == CaptureOptions::STANDARD_OUTPUT)
        throw CLI::ValidationError(
            "--stats and --parts-list both write to standard output; expected - for one of them");
}

/** Converts a function that returns an error message into a callback for CLI11. */
template <typename Reader>
CLI::callback_t toCallback(const Reader& reader)
{
    return [reader](const CLI::results_t& results)
    {
        for (const std::string& result : results)
            if (const std::string error = reader(result); !error.empty()) throw CLI::ValidationError(error);
        return true;
    };
}

/** Whether the value of an option is the name of a file or a folder. */
bool isFileName(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    return option.get_name() == "MESH" || type.starts_with("FILE") || type == "DIR" || type == "REFERENCE";
}

/** Throws if the name of a file is empty, such as that of a shell variable that is not set, or if an option has the
 * name of another one for its value: CLI11 takes what follows, whatever it is. */
void checkValues(const CLI::App& app)
{
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results())
        {
            if (value.empty() && isFileName(*option))
                throw CLI::ValidationError(option->get_name() + " is empty; expected the name of a file or a folder");
            if (value.starts_with('-') && app.get_option_no_throw(value))
                throw CLI::ValidationError(option->get_name() + " has no value before " + value + "; expected " +
                                           option->get_name() + " " + option->get_type_name());
        }
}

// The options of the help text, in its order, by subject.

/** The mesh, its bricks and the picture of them. */
void addPicture(CLI::App& app, CaptureOptions& options)
{
    app.add_option("MESH", options.mesh, "A file that OpenSceneGraph reads (the built-in racing car)");
    app.add_option("-O", options.readerOptions,
                   "Options for the reader of MESH, including .legolize, as osgviewer's -O")
        ->type_name("OPTIONS");
    app.add_option("-o,--output", options.output, "The picture to write; its extension is its format")
        ->type_name("FILE");
    app.add_option("--legolize", options.settingsText, "Settings of the bricks, as below")->type_name("SETTINGS");
    app.add_option("--size", toCallback([&](const std::string& text) { return readSize(text, options); }),
                   "Pixels of the picture (1280x720; for --build, as many in the shape of the model)")
        ->type_name("WxH");
}

void addCamera(CLI::App& app, CaptureOptions& options)
{
    app.add_option(
           "--view", toCallback([&](const std::string& text) { return readView(text, options); }),
           "The camera: degrees around the mesh, degrees above the horizon, and the distance from the middle of the "
           "mesh's bounding sphere in radii of that sphere. Without a distance, the mesh and its bricks just fit "
           "in (30,25). For --instructions and --build, the view of the cover and of the steps until the model is "
           "turned by quarters, 10 to 80 degrees above the horizon (33,30)")
        ->type_name("AZIMUTH,ELEVATION[,DISTANCE]");
    app.add_flag("--orthographic", options.view.orthographic, "Draw without perspective");
    app.add_option(
           "--near",
           toCallback(
               [&](const std::string& text) {
                   return readNumber("--near", text, {1e-6, MAXIMUM_NUMBER, "radii above 0"}, options.view.near);
               }),
           "Cut off everything nearer than this many radii of the mesh's bounding sphere")
        ->type_name("RADII");
}

void addLight(CLI::App& app, CaptureOptions& options)
{
    app.add_option("--occlusion", toCallback([&](const std::string& text) { return readOcclusion(text, options); }),
                   "Ambient occlusion: off, grid (by the bricks of the grid), screen (by everything in the picture) "
                   "or both; then settings, as below (grid; screen with --original)")
        ->type_name("OCCLUSION");
    app.add_option(
           "--probe", options.probe.file,
           "Environment light: a latitude-longitude picture or an angular map with high dynamic range (a built-in sky)")
        ->type_name("FILE");
    app.add_option("--probe-turn",
                   toCallback(
                       [&](const std::string& text) {
                           return readNumber("--probe-turn", text, {-1e6, 1e6, "degrees"}, options.probe.turn);
                       }),
                   "Turn the environment light about the up axis (0)")
        ->type_name("DEGREES");
    app.add_option("--probe-intensity",
                   toCallback(
                       [&](const std::string& text) {
                           return readNumber("--probe-intensity", text, {0.0, MAXIMUM_NUMBER, "0 or more"},
                                             options.probe.intensity);
                       }),
                   "Multiply the environment light (1)")
        ->type_name("FACTOR");
}

/** How the picture is drawn. */
void addDrawing(CLI::App& app, CaptureOptions& options)
{
    app.add_flag("--original", options.original,
                 "Draw the mesh instead of bricks; from the same place if --legolize is the same");
    app.add_flag(
        "--transparent", options.transparent,
        "Leave the background transparent: straight alpha in .png and .tif, colours multiplied by alpha in .exr");
    app.add_option("--context", toCallback([&](const std::string& text) { return readContext(text, options.context); }),
                   "How to create the GL context: auto, egl or osmesa (auto)")
        ->type_name("KIND");
}

/** Figures and lists beside the picture. */
void addReports(CLI::App& app, CaptureOptions& options)
{
    app.add_option("--stats", options.statistics,
                   "Write counts, the grid and times as JSON; - writes them to standard output")
        ->type_name("FILE.json");
    app.add_flag(
        "--bound", options.bound,
        "Also compute the fewest bricks (not plates) that can cover each layer by itself, for the report on parts "
        "and for --stats; takes seconds to minutes");
    app.add_option(
           "--base", toCallback([&](const std::string& text) { return readBase(text, options); }),
           "Compute whether the parts stand on a table or on a studded base plate, and print it; for --stats too")
        ->type_name("table|plate");
    app.add_flag("--tilt", options.tilt,
                 "Also compute by how many degrees the base can be tilted until the parts fall, for --base; takes "
                 "about five times as long");
    app.add_option("--load", toCallback([&](const std::string& text) { return readLoad(text, options); }),
                   "Put a weight on the part in a cell, for --base; the report names cells, and --cells lists them. "
                   "May be repeated")
        ->type_name("X,Y,Z=GRAMSg")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--cells", options.cells, "Write every covered cell: x,y,z,red,green,blue")->type_name("FILE.csv");
    app.add_option("--parts-list", options.partsList,
                   "Write the parts to order: a table as .csv, or a wanted list of BrickLink as .xml; - writes the "
                   "table to standard output")
        ->type_name("FILE");
}

void addBooklet(CLI::App& app, CaptureOptions& options)
{
    app.add_option(
           "--instructions", options.instructions,
           "Write a booklet of building instructions, DIR/NAME.html, and in words, DIR/NAME.txt; DIR is created if it "
           "does not exist")
        ->type_name("DIR");
    app.add_option("--steps", toCallback([&](const std::string& text) { return readSteps(text, options); }),
                   "For --instructions: write only these steps, for example 1-50")
        ->type_name("FIRST-LAST");
    app.add_option("--title", options.title,
                   "For --instructions and --build: the title of the booklet and of its model in LDraw's format (that "
                   "of a MESH in this format, or its name)")
        ->type_name("TEXT");
    app.add_option("--author", options.author,
                   "For --instructions and --build: the author of both (that of a MESH in LDraw's format)")
        ->type_name("TEXT");
    app.add_option("--license", options.license,
                   "For --instructions and --build: the text after !LICENSE in the model (that of a MESH in LDraw's "
                   "format, or no such line)")
        ->type_name("TEXT");
    app.add_flag("--yes", options.isBookletConfirmed,
                 "For --instructions and --build: write all steps of more than 2,000 parts");
}

/** A model with settings that the program chooses. */
void addBuild(CLI::App& app, CaptureOptions& options)
{
    app.add_option("--build", options.build,
                   "Choose the settings that make the best model to build, and write its picture, instructions, parts "
                   "lists, .mpd and a report into DIR; settings in --legolize are kept, and --base, --view, --title, "
                   "--author, --license and --yes apply")
        ->type_name("DIR");
    app.add_option("--parts", toCallback([&](const std::string& text) { return readParts(text, options); }),
                   "For --build: the most parts of the model (500)")
        ->type_name("N");
    app.add_option("--length", toCallback([&](const std::string& text) { return readLength(text, options); }),
                   "For --build: the longest side of the model, for example 20cm, instead of --parts")
        ->type_name("LENGTH");
}

void addComparison(CLI::App& app, CaptureOptions& options)
{
    app.add_option("--compare", options.reference,
                   "Compare with a picture: print the differences, write a picture of them beside the output, and exit "
                   "with 1 if more than 0.1 % of the pixels are off or the mean error is more than a quarter of "
                   "--threshold")
        ->type_name("REFERENCE");
    app.add_option("--threshold",
                   toCallback(
                       [&](const std::string& text) {
                           return readNumber("--threshold", text, {0.0, 1.0, "0 to 1"}, options.threshold);
                       }),
                   "For --compare: a pixel is off if a channel, 0 to 1, differs by more than this (0.0157, or 4/255)")
        ->type_name("DIFFERENCE");
}

/** The help text below the options. */
std::string createFooter()
{
    return "SETTINGS: a list of key=value; a number alone is the resolution\n" +
           describeKeys(LegoSettings::describe()) +
           "\nOCCLUSION, in the full look: one of these words, and a list of key=value; a quality alone needs no "
           "key\n" +
           describeKeys(AmbientOcclusionSettings::describe()) +
           "\nExit codes: 0 fine, 1 --compare found a difference, 2 bad options, 3 bad input, 4 output can't be "
           "written,\n5 no GL that can make bricks, 129, 130 and 143 cancelled by SIGHUP, SIGINT or SIGTERM.";
}

} // namespace

bool CaptureOptions::needsContext() const
{
    return !output.empty() || !statistics.empty() || !cells.empty() || !reference.empty();
}

std::optional<int> readOptions(int argc, char** argv, CaptureOptions& options)
{
    CLI::App app{"Draws a mesh in bricks into a picture, without a display.", "osglegocapture"};
    app.footer(createFooter());
    app.set_version_flag("--version", "osglegocapture " OSGLEGO_VERSION, "Print the version and exit");
    addPicture(app, options);
    addCamera(app, options);
    addLight(app, options);
    addDrawing(app, options);
    addReports(app, options);
    addBooklet(app, options);
    addBuild(app, options);
    addComparison(app, options);

    try
    {
        checkArguments(app, argc, argv);
        app.parse(argc, argv);
        checkValues(app);
        if (app.count("--legolize") > 0 || !options.build.empty()) readSettings(options);
        checkCombination(options, app.count("--threshold") > 0);
        // A mesh has no grid.
        if (!options.isOcclusionGiven) options.hasOcclusion = options.original;
    }
    catch (const CLI::Success& success)
    {
        return app.exit(success);
    }
    catch (const CLI::ParseError& error)
    {
        std::fprintf(stderr, "osglegocapture: %s\n", error.what());
        return EXIT_BAD_OPTIONS;
    }
    return std::nullopt;
}

} // namespace osgLego
