#include "VoxelizeReport.h"

#include "Goals.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace osgLego
{

namespace
{

using nlohmann::ordered_json;

constexpr std::string_view GPU_STAGE = "gpu";

/** The GPU's own time where there is one. */
std::string formatGpuTime(const ContenderResult& result, const char* none)
{
    for (const auto& [name, time] : result.stages)
        if (name == GPU_STAGE) return fmt::format("{:.2f}", time);
    return none;
}

std::string formatStages(const ContenderResult& result)
{
    std::string text;
    for (const auto& [name, time] : result.stages)
        if (name != GPU_STAGE) text += fmt::format("{}{} {:.2f}", text.empty() ? "" : ", ", name, time);
    return text;
}

std::string formatRow(const ContenderResult& result)
{
    if (!result.failure.empty()) return fmt::format("| {:17} | {} |\n", result.contender, result.failure);
    const VoxelQuality& quality = result.quality;
    const std::string color = quality.colorError ? fmt::format("{:.2f}", *quality.colorError) : "none";
    return fmt::format("| {:17} | {:9.2f} | {:9.2f} | {:9.2f} to {:9.2f} | {:>7} | {:7} | {:9.5f} | {:8.5f} | {:7} | "
                       "{:>12} | {} |\n",
                       result.contender, result.time.median, result.time.minimum, result.time.lowerQuartile,
                       result.time.upperQuartile, formatGpuTime(result, "-"), quality.numCells, quality.precision,
                       quality.recall, quality.numTunnels, color, formatStages(result));
}

std::string formatMesh(const MeshResult& mesh)
{
    std::string text = fmt::format(
        "\n{}, {} triangles, at {} ({} x {} x {}): {} cells that triangles overlap\n\n"
        "| contender         | median ms | least ms  | quartiles              | gpu ms  | cells   | precision "
        "| recall   | tunnels | colour error | parts, ms |\n"
        "|-------------------|-----------|-----------|------------------------|---------|---------|-----------"
        "|----------|---------|--------------|-----------|\n",
        mesh.mesh, mesh.numTriangles, mesh.resolution, mesh.dimensions.x, mesh.dimensions.y, mesh.dimensions.z,
        mesh.numCells);
    for (const ContenderResult& result : mesh.contenders)
        text += formatRow(result);
    return text;
}

std::string formatGoals(const std::vector<Goal>& goals)
{
    if (goals.empty()) return {};
    std::string text = "\nGoals, ratios of medians of this run\n\n"
                       "| what                                     | mesh                     | ratio   | goal    | "
                       "reached |\n"
                       "|------------------------------------------|--------------------------|---------|---------|"
                       "---------|\n";
    for (const Goal& goal : goals)
        text += fmt::format("| {:40} | {:24} | {:7.2f} | {:7} | {:7} |\n", goal.text, goal.where, goal.ratio,
                            goal.getBoundText(), goal.isReached ? "yes" : "no");
    return text;
}

ordered_json toJson(const ContenderResult& result)
{
    ordered_json json{{"name", result.contender}, {"hasColors", result.hasColors}};
    if (!result.failure.empty())
    {
        json["failure"] = result.failure;
        return json;
    }
    const Spread& time = result.time;
    json["milliseconds"] = {{"median", time.median},
                            {"minimum", time.minimum},
                            {"lowerQuartile", time.lowerQuartile},
                            {"upperQuartile", time.upperQuartile},
                            {"maximum", time.maximum}};
    for (const auto& [name, median] : result.stages)
        json["parts"][name] = median;
    json["cells"] = result.quality.numCells;
    json["precision"] = result.quality.precision;
    json["recall"] = result.quality.recall;
    json["tunnels"] = result.quality.numTunnels;
    if (result.quality.colorError) json["colorError"] = *result.quality.colorError;
    return json;
}

ordered_json toJson(const MeshResult& mesh)
{
    ordered_json json{{"mesh", mesh.mesh},
                      {"triangles", mesh.numTriangles},
                      {"resolution", mesh.resolution},
                      {"dimensions", {mesh.dimensions.x, mesh.dimensions.y, mesh.dimensions.z}},
                      {"coveredCells", mesh.numCells}};
    for (const ContenderResult& result : mesh.contenders)
        json["contenders"].push_back(toJson(result));
    return json;
}

ordered_json toJson(const Goal& goal)
{
    return {{"what", goal.text},
            {"mesh", goal.where},
            {"ratio", goal.ratio},
            {"goal", goal.getBoundText()},
            {"reached", goal.isReached}};
}

/** A text as a field of CSV. */
std::string quoted(std::string text)
{
    for (auto place = text.find('"'); place != std::string::npos; place = text.find('"', place + 2))
        text.insert(place, 1, '"');
    return '"' + text + '"';
}

std::string formatCsvRow(const MeshResult& mesh, const ContenderResult& result)
{
    std::string text = fmt::format("{},{},{},{},{},", quoted(mesh.mesh), mesh.numTriangles, mesh.resolution,
                                   mesh.numCells, quoted(result.contender));
    if (!result.failure.empty()) return text + fmt::format(",,,,,,,,,,,{}\n", quoted(result.failure));
    const Spread& time = result.time;
    const VoxelQuality& quality = result.quality;
    text += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},", time.median, time.minimum, time.lowerQuartile,
                        time.upperQuartile, time.maximum, formatGpuTime(result, ""));
    return text + fmt::format("{},{:.8f},{:.8f},{},{},\n", quality.numCells, quality.precision, quality.recall,
                              quality.numTunnels, quality.colorError ? fmt::format("{:.4f}", *quality.colorError) : "");
}

} // namespace

std::string formatTables(const VoxelizeResults& results)
{
    std::string text;
    for (const auto& [name, value] : results.environment.toFields())
        text += fmt::format("{}: {}\n", name, value);
    text += fmt::format("runs: {}, after {} to warm up, contenders in turns\n", results.numRuns, results.numWarmUps);
    for (const MeshResult& mesh : results.meshes)
        text += formatMesh(mesh);
    return text + formatGoals(checkGoals(results));
}

std::string formatJson(const VoxelizeResults& results)
{
    ordered_json json;
    for (const auto& [name, value] : results.environment.toFields())
        json["environment"][name] = value;
    json["runs"] = results.numRuns;
    json["warmUps"] = results.numWarmUps;
    for (const MeshResult& mesh : results.meshes)
        json["meshes"].push_back(toJson(mesh));
    json["goals"] = ordered_json::array();
    for (const Goal& goal : checkGoals(results))
        json["goals"].push_back(toJson(goal));
    return json.dump(4) + '\n';
}

std::string formatCsv(const VoxelizeResults& results)
{
    std::string text;
    for (const auto& [name, value] : results.environment.toFields())
        text += fmt::format("# {}: {}\n", name, value);
    text += "mesh,triangles,resolution,coveredCells,contender,median,minimum,lowerQuartile,upperQuartile,maximum,gpu,"
            "cells,precision,recall,tunnels,colorError,failure\n";
    for (const MeshResult& mesh : results.meshes)
        for (const ContenderResult& result : mesh.contenders)
            text += formatCsvRow(mesh, result);
    return text;
}

} // namespace osgLego
