#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "BorderComparison.h"
#include "ColorTimes.h"
#include "Commands.h"
#include "DitherComparison.h"

#include <osgLego/cpu/CpuVoxelizer.h>
#include <osgLego/cpu/DominantColors.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/palette/MatchingLab.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

using Color = std::array<std::uint8_t, 3>;

struct ColorsCommandOptions : BenchOptions
{
    std::string palette = "ldraw";
    unsigned int numRuns = 7;
    unsigned int numColors = Palette::MAXIMUM_COLORS;
};

double chromaOf(const glm::dvec3& place)
{
    return std::hypot(place.y, place.z);
}

/** Compares the colours that a palette gives with the best ones, by the difference with which colours are matched. */
class ColorComparison
{
public:
    explicit ColorComparison(const Palette& palette) : _palette(palette)
    {
        for (const PaletteColor& color : palette.getColors())
            _places.push_back(toMatchingLab(color.color));
    }

    void add(const Color& color)
    {
        const glm::dvec3 place = toMatchingLab(color);
        const std::size_t index = _palette.findNearest(color);
        const glm::dvec3& chosen = _places[index];
        double best = ciede2000(place, _places.front());
        for (const glm::dvec3& other : _places)
            best = std::min(best, ciede2000(place, other));
        const double excess = ciede2000(place, chosen) - best;
        ++_count;
        _error += Palette::getDifference(color, _palette.getColors()[index].color);
        _excess += excess;
        _numWorse += excess > NOTICEABLE ? 1 : 0;
        _numNeutral += chromaOf(place) <= NEUTRAL ? 1 : 0;
        _numChromatic += chromaOf(place) <= NEUTRAL && chromaOf(chosen) > CHROMATIC ? 1 : 0;
    }

    JsonValue toJson(const std::string& name) const
    {
        JsonValue row{{"colorsOf", name},
                      {"count", _count},
                      {"palette", _palette.getColors().size()},
                      {"error", mean(_error, _count)},
                      {"excess", mean(_excess, _count)},
                      {"worse", mean(_numWorse, _count)},
                      {"neutral", _numNeutral}};
        if (_numNeutral > 0) row["chromatic"] = mean(_numChromatic, _numNeutral);
        const auto addGoal = [&](const char* figure, double goal)
        {
            if (row.contains(figure))
                row["goals"].append({{"what", figure},
                                     {"figure", row[figure]},
                                     {"goal", goal},
                                     {"reached", row[figure].toNumber() <= goal}});
        };
        addGoal("excess", 0.3);
        addGoal("worse", 0.02);
        addGoal("chromatic", 0.01);
        return row;
    }

private:
    static constexpr double NOTICEABLE = 5.0; // an excess that is seen at a glance
    static constexpr double NEUTRAL = 5.0;    // the largest chroma of nearly neutral colours
    static constexpr double CHROMATIC = 10.0; // the least chroma of colours that have a clear hue

    template <typename Sum>
    static double mean(Sum sum, std::size_t count)
    {
        return count == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(count);
    }

    const Palette& _palette;
    std::vector<glm::dvec3> _places;
    std::size_t _count = 0;
    double _error = 0.0;
    double _excess = 0.0;
    std::size_t _numWorse = 0;
    std::size_t _numNeutral = 0;
    std::size_t _numChromatic = 0;
};

LegoSettings createSettings(const ColorsCommandOptions& options)
{
    LegoSettings settings;
    settings.colors.palette = options.palette;
    settings.colors.count = options.numColors;
    return settings;
}

/** Add the figures of a mesh to a document. */
void compareMesh(const MeshSource& mesh, unsigned int resolution, LegoSettings settings, unsigned int numRuns,
                 JsonValue& document)
{
    settings.grid.resolution = resolution;
    settings.grid.upAxis = mesh.upAxis;
    const osg::ref_ptr<osg::Node> node = readMesh(mesh);
    std::string error;
    const osg::ref_ptr<LegoSource> source = LegoSource::create(*SceneTriangles::create(*node), settings, error);
    if (!source) throw std::runtime_error(error);
    const Palette& palette = *source->lookup.getPalette();
    const GridTriangles& triangles = *source->triangles;
    const std::string name = fmt::format("{} {}", mesh.name, resolution);
    const osg::ref_ptr<const BrickModel> cells = voxelizeOnCpu(triangles, CellColor::DOMINANT);
    ColorComparison comparison(palette);
    for (const Brick& brick : cells->getBricks())
        if (brick.openSides != 0) comparison.add(brick.color);
    document["rows"].append(comparison.toJson(name));
    document["dither"].append(compareDithered(palette, *cells, name));
    document["borders"].append(compareBorders(palette, triangles, numRuns, name));
    document["choices"].append(measureChoice(palette, triangles, numRuns, name));
}

/** Colours spread evenly over sRGB. */
JsonValue compareGrid(const Palette& palette)
{
    ColorComparison comparison(palette);
    for (int red = 0; red < 256; red += 5)
        for (int green = 0; green < 256; green += 5)
            for (int blue = 0; blue < 256; blue += 5)
                comparison.add({static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                static_cast<std::uint8_t>(blue)});
    return comparison.toJson("grid");
}

void runColors(const ColorsCommandOptions& options)
{
    const std::vector<MeshSource> meshes = options.getMeshes();
    const LegoSettings settings = createSettings(options);
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read(settings, error);
    if (!palette) throw std::runtime_error(error);
    const unsigned int numRuns = options.isQuick ? 1 : options.numRuns;
    JsonValue document = createDocument("colors");
    document["rows"].append(compareGrid(*palette));
    document["dither"].append(compareDitheredMixtures(*palette));
    document["dither"].append(compareDitheredNeutrals(*palette));
    document["tables"].append(measureTables(*palette, numRuns, options.palette));
    document["tables"].append(measureLargestTables(numRuns));
    for (const MeshSource& mesh : meshes)
        for (const unsigned int resolution : options.getResolutions({24}, {48}))
            compareMesh(mesh, resolution, settings, numRuns, document);
    options.write(document);
}

} // namespace

void addColorsCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "colors",
        "Differences (CIEDE2000) between colours and those that a palette gives them, their excess over the best "
        "of the palette, dithered colours, borders between colours, and the times that palettes take");
    const auto options = std::make_shared<ColorsCommandOptions>();
    options->addTo(command, "48");
    command.addText("--palette", options->palette, "ldraw, or a .csv or .ldr file (ldraw)", "PALETTE");
    command.addNumber("--colors", options->numColors, "Only this number of its colours, chosen for each mesh (all)", 1u,
                      static_cast<unsigned int>(Palette::MAXIMUM_COLORS));
    command.addNumber("--runs", options->numRuns, "Timed runs (7)", 1u, 1000u);
    command.setRun([options] { runColors(*options); });
}

} // namespace osgLego
