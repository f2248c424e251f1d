#include "VoxelizeReport.h"

#include "Goals.h"
#include "ReportParts.h"

#include <fmt/format.h>

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

ordered_json toJson(const ContenderResult& result)
{
    ordered_json json{{"name", result.contender}, {"hasColors", result.hasColors}};
    if (!result.failure.empty())
    {
        json["failure"] = result.failure;
        return json;
    }
    json["milliseconds"] = toJson(result.time);
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

std::string formatCsvRow(const MeshResult& mesh, const ContenderResult& result)
{
    std::string text = fmt::format("{},{},{},{},{},", quotedField(mesh.mesh), mesh.numTriangles, mesh.resolution,
                                   mesh.numCells, quotedField(result.contender));
    if (!result.failure.empty()) return text + fmt::format(",,,,,,,,,,,{}\n", quotedField(result.failure));
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
    std::string text = formatEnvironment(results.environment, "");
    text += fmt::format("runs: {}, after {} to warm up, contenders in turns\n", results.numRuns, results.numWarmUps);
    for (const MeshResult& mesh : results.meshes)
        text += formatMesh(mesh);
    return text + formatGoals(checkGoals(results));
}

std::string formatJson(const VoxelizeResults& results)
{
    ordered_json json{
        {"environment", toJson(results.environment)}, {"runs", results.numRuns}, {"warmUps", results.numWarmUps}};
    for (const MeshResult& mesh : results.meshes)
        json["meshes"].push_back(toJson(mesh));
    json["goals"] = toJson(checkGoals(results));
    return json.dump(4) + '\n';
}

std::string formatCsv(const VoxelizeResults& results)
{
    std::string text = formatCsvHead(results.environment, checkGoals(results));
    text += "mesh,triangles,resolution,coveredCells,contender,median,minimum,lowerQuartile,upperQuartile,maximum,gpu,"
            "cells,precision,recall,tunnels,colorError,failure\n";
    for (const MeshResult& mesh : results.meshes)
        for (const ContenderResult& result : mesh.contenders)
            text += formatCsvRow(mesh, result);
    return text;
}

} // namespace osgLego
