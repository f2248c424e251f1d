#include "MemoryReport.h"

#include "Goals.h"
#include "ReportParts.h"

#include <fmt/format.h>

namespace osgLego
{

namespace
{

using nlohmann::ordered_json;

std::string formatRow(const MemoryResults& results, const MemoryRow& row)
{
    std::string text = fmt::format("| {:8} | {:6} | {:4} | ", results.mesh, row.device, row.resolution);
    if (!row.footprint) return text + "no frame could be drawn |\n";
    const SceneFootprint& footprint = *row.footprint;
    return text + fmt::format("{:8} | {:12.1f} | {:6.1f} | {:9.1f} | {:10.1f} | {:9.1f} | {} |\n",
                              footprint.numDrawnBricks, footprint.resident, footprint.gl, footprint.largestBlock,
                              footprint.getSum(), footprint.largestGl, footprint.largestGlObject);
}

ordered_json toJson(const MemoryRow& row)
{
    ordered_json json{{"device", row.device}, {"resolution", row.resolution}};
    if (!row.footprint)
    {
        json["failure"] = "no frame could be drawn";
        return json;
    }
    json["mebibytes"] = {{"resident", row.footprint->resident},
                         {"gl", row.footprint->gl},
                         {"bothSides", row.footprint->getSum()},
                         {"largestGlObject", row.footprint->largestGl},
                         {"largestBlock", row.footprint->largestBlock}};
    json["largestGlObject"] = row.footprint->largestGlObject;
    json["drawnBricks"] = row.footprint->numDrawnBricks;
    return json;
}

} // namespace

std::string formatTables(const MemoryResults& results)
{
    std::string text = formatEnvironment(results.environment, "");
    text += fmt::format(
        "\nMiB of a process of its own that reads the mesh, makes its bricks, and draws a frame of 1280 x 720 with "
        "ambient occlusion.\nResident: the peak of main memory. GL: the peak of what buffers and pictures hold, as "
        "they were asked for. Both sides: {}.\n\n",
        results.environment.isSoftware() ? "what is resident, which GL is in, since the renderer is a software one"
                                         : "the sum of the two");
    text +=
        "| mesh     | device | N    | bricks   | resident MiB | GL MiB | largest block | both sides | largest of GL "
        "| which is |\n"
        "|----------|--------|------|----------|--------------|--------|---------------|------------|---------------"
        "|----------|\n";
    for (const MemoryRow& row : results.rows)
        text += formatRow(results, row);
    return text + formatGoals(checkGoals(results));
}

std::string formatJson(const MemoryResults& results)
{
    ordered_json json{{"environment", toJson(results.environment)}, {"mesh", results.mesh}};
    for (const MemoryRow& row : results.rows)
        json["rows"].push_back(toJson(row));
    json["goals"] = toJson(checkGoals(results));
    return json.dump(4) + '\n';
}

std::string formatCsv(const MemoryResults& results)
{
    std::string text = formatCsvHead(results.environment, checkGoals(results));
    text += "mesh,device,resolution,drawnBricks,residentMiB,glMiB,bothSidesMiB,largestBlockMiB,largestGlObjectMiB,"
            "largestGlObject\n";
    for (const MemoryRow& row : results.rows)
    {
        text += fmt::format("{},{},{},", quotedField(results.mesh), row.device, row.resolution);
        if (row.footprint)
            text += fmt::format("{},{:.1f},{:.1f},{:.1f},{:.1f},{:.1f},{}", row.footprint->numDrawnBricks,
                                row.footprint->resident, row.footprint->gl, row.footprint->getSum(),
                                row.footprint->largestBlock, row.footprint->largestGl,
                                quotedField(row.footprint->largestGlObject));
        else
            text += ",,,,,,";
        text += '\n';
    }
    return text;
}

} // namespace osgLego
