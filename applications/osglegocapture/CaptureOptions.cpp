#include "CaptureOptions.h"

#include "ExitCode.h"

#include <cstdio>
#include <map>
#include <vector>

#include <CLI/CLI.hpp>

namespace osgLego
{

namespace
{

constexpr int MAXIMUM_SIZE = 8192;

std::string readSize(const std::string& text, CaptureOptions& options)
{
    int width = 0;
    int height = 0;
    char rest = 0;
    const bool isRead = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    if (!isRead || width < 1 || height < 1 || width > MAXIMUM_SIZE || height > MAXIMUM_SIZE)
        return "bad value '" + text + "' for --size; allowed: WIDTHxHEIGHT in pixels, each 1 to 8192";
    options.width = width;
    options.height = height;
    return {};
}

std::string readView(const std::string& text, CaptureView& view)
{
    CaptureView read;
    char rest = 0;
    const int count = std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &read.azimuth, &read.elevation, &read.distance, &rest);
    const bool isFinite = std::isfinite(read.azimuth) && std::isfinite(read.elevation) && std::isfinite(read.distance);
    const bool isWhole = count == 3 || (count == 2 && text.find_last_of(',') == text.find(','));
    if (!isWhole || !isFinite || std::abs(read.elevation) > 90.0 || (count == 3 && !(read.distance > 0.0)))
        return "bad value '" + text +
               "' for --view; allowed: AZIMUTH,ELEVATION[,DISTANCE]: degrees, degrees from -90 to 90, and radii of the "
               "model above 0";
    view = read;
    return {};
}

std::string readSettings(const std::string& text, CaptureOptions& options)
{
    std::string error;
    LegoSettings settings;
    if (!LegoSettings::parse(text, settings, error)) return "--legolize: " + error;
    options.settings = settings;
    return {};
}

std::string readOcclusion(const std::string& text, CaptureOptions& options)
{
    options.hasOcclusion = text != "off";
    std::string error;
    if (!options.hasOcclusion || AmbientOcclusionSettings::parse(text, options.occlusion, error)) return {};
    return "--occlusion: " + error + " (or off alone)";
}

std::string readNumber(const char* option, const std::string& text, double minimum, const char* allowed, double& number)
{
    char rest = 0;
    double read = 0.0;
    const bool isRead = std::sscanf(text.c_str(), "%lf%c", &read, &rest) == 1;
    if (!isRead || !std::isfinite(read) || read < minimum)
        return std::string("bad value '") + text + "' for " + option + "; allowed: " + allowed;
    number = read;
    return {};
}

/** Turns a function that answers what is wrong into what CLI11 wants. */
template <typename Reader>
CLI::callback_t toCallback(const Reader& reader)
{
    return [reader](const CLI::results_t& results)
    {
        const std::string error = reader(results.front());
        if (!error.empty()) throw CLI::ValidationError(error);
        return true;
    };
}

const char* const FOOTER = R"(SETTINGS: a list of key=value; a number alone is the resolution
  resolution   1 to 1024, cells along the longest side   (64)
  proportions  cube, brick, plate                        (cube)
  up           y, z                                      (z)
  method       points, exact                             (exact)
  target       projected, addressed                      (points: projected, exact: addressed)
  fbo          16 to 8192, side of a projected target    (1024)
  edge         0.0625 to 4, longest edge left, in cells  (points: 1, exact: 2)
  device       auto, gpu, cpu, which finds the bricks    (auto: cpu for exact where OpenGL is in software)
  look         plain, full                               (full)

OCCLUSION, in the full look: a list of key=value; a quality alone needs no key
  quality      low, medium, high                         (medium)
  radius       above 0, in the mesh's units              (2.5 bricks)
  show         picture, occlusion, bent-normals, irradiance, normals

Exit codes: 0 fine, 1 --compare found a difference, 2 bad options, 3 bad input, 4 output can't be written,
5 no GL that can make bricks.)";

} // namespace

std::optional<int> readOptions(int argc, char** argv, CaptureOptions& options)
{
    CLI::App app{"Draws a mesh in bricks into a picture, without a display.", "osglegocapture"};
    app.footer(FOOTER);
    app.add_option("MESH", options.mesh, "A file that OpenSceneGraph reads; without one, the built-in racing car");
    app.add_option("-o,--output", options.output, "The picture to write; its extension is its format");
    app.add_option("--legolize", toCallback([&](const std::string& text) { return readSettings(text, options); }),
                   "Settings of the bricks, as below")
        ->type_name("SETTINGS");
    app.add_option("--size", toCallback([&](const std::string& text) { return readSize(text, options); }),
                   "Pixels of the picture (1280x720)")
        ->type_name("WxH");
    app.add_option("--view", toCallback([&](const std::string& text) { return readView(text, options.view); }),
                   "Degrees around the model, degrees above the horizon, distance in radii (30,25)")
        ->type_name("AZIMUTH,ELEVATION[,DISTANCE]");
    app.add_flag("--orthographic", options.view.orthographic, "A view without perspective");
    app.add_option("--near",
                   toCallback([&](const std::string& text)
                              { return readNumber("--near", text, 1e-6, "radii above 0", options.view.near); }),
                   "Cut off what is nearer than so many radii of the model")
        ->type_name("RADII");
    app.add_option("--occlusion", toCallback([&](const std::string& text) { return readOcclusion(text, options); }),
                   "Ambient occlusion, as below, or off (medium)")
        ->type_name("OCCLUSION");
    app.add_option("--probe", options.probe.file,
                   "The light from all around: a latitude-longitude picture, or an angular map, of high dynamic range "
                   "(a built-in sky)")
        ->type_name("FILE");
    app.add_option("--probe-turn",
                   toCallback([&](const std::string& text)
                              { return readNumber("--probe-turn", text, -1e6, "degrees", options.probe.turn); }),
                   "Turn that light around the axis that is up (0)")
        ->type_name("DEGREES");
    app.add_option(
           "--probe-intensity",
           toCallback([&](const std::string& text)
                      { return readNumber("--probe-intensity", text, 0.0, "0 or more", options.probe.intensity); }),
           "Make that light stronger or weaker (1)")
        ->type_name("FACTOR");
    app.add_flag("--original", options.original, "Draw the mesh as it is");
    app.add_option("--context", options.context, "How to get at GL: auto, egl or osmesa (auto)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, ContextKind>{{"auto", ContextKind::AUTO},
                                                                               {"egl", ContextKind::EGL},
                                                                               {"osmesa", ContextKind::OSMESA}})
                        .description(""))
        ->type_name("KIND");
    app.add_option("--stats", options.statistics, "Write counts, the grid and times as JSON")->type_name("FILE.json");
    app.add_option("--cells", options.cells, "Write every covered cell: x,y,z,red,green,blue")->type_name("FILE.csv");
    app.add_option("--compare", options.reference,
                   "Compare with a picture: print the figures, write the difference beside the output, exit with 1 if "
                   "more than 0.1 % of the pixels are off by more than 4/255")
        ->type_name("REFERENCE");

    try
    {
        app.parse(argc, argv);
        if (options.output.empty() && options.statistics.empty() && options.cells.empty() && options.reference.empty())
            throw CLI::ValidationError("nothing to do; allowed: one or more of -o, --stats, --cells and --compare");
        if (options.original && !options.cells.empty())
            throw CLI::ValidationError("--original has no cells; allowed: --cells without --original");
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
