#include "FrameReport.h"

#include "Goals.h"
#include "ReportParts.h"

#include <fmt/format.h>

namespace osgLego
{

namespace
{

using nlohmann::ordered_json;

std::string formatTime(const Spread& time)
{
    return fmt::format("{:.1f} ({:.1f} to {:.1f})", time.median, time.lowerQuartile, time.upperQuartile);
}

std::string formatRow(const FrameRow& row)
{
    const FrameComparison& comparison = row.comparison;
    const FrameDifference& difference = comparison.difference;
    return fmt::format(
        "| {:6} | {:3} | {:7} | {:9} | {:>23} | {:>22} | {:5.2f} | {:14} | {:6.3f} | {:6} of {:6} | {} |\n", row.mesh,
        row.resolution, row.view, row.look, formatTime(comparison.reference), formatTime(comparison.present),
        comparison.getRatio(), difference.largest, difference.rootMeanSquare, difference.numPixels, difference.numDrawn,
        difference.isSame() ? "same" : "different");
}

std::string formatUnchanged(const FrameResults& results)
{
    if (results.unchanged.empty()) return {};
    std::string text = fmt::format(
        "\n{} frames in which nothing has changed, {}: what happens in all of them together; and, to compare, in "
        "frames "
        "in which the bricks are made anew\n\n"
        "| drawn                   | look  | legolizations | waits for the renderer | allocations | in this thread |\n"
        "|-------------------------|-------|---------------|------------------------|-------------|----------------|\n",
        results.unchanged.front().numFrames, results.unchangedMesh);
    for (const UnchangedFrames& frames : results.unchanged)
        text += fmt::format("| {:23} | {:5} | {:13} | {:22} | {:11} | {:14} |\n", frames.name, frames.look,
                            frames.numPasses, frames.numWaits, frames.numAllocations, frames.numOwnAllocations);
    return text;
}

ordered_json toJson(const FrameRow& row)
{
    const FrameDifference& difference = row.comparison.difference;
    return {{"mesh", row.mesh},
            {"resolution", row.resolution},
            {"view", row.view},
            {"look", row.look},
            {"referenceMilliseconds", toJson(row.comparison.reference)},
            {"presentMilliseconds", toJson(row.comparison.present)},
            {"ratio", row.comparison.getRatio()},
            {"difference",
             {{"largest", difference.largest},
              {"rootMeanSquare", difference.rootMeanSquare},
              {"pixels", difference.numPixels},
              {"drawnPixels", difference.numDrawn},
              {"same", difference.isSame()}}}};
}

ordered_json toJson(const UnchangedFrames& frames)
{
    return {{"drawn", frames.name},
            {"look", frames.look},
            {"frames", frames.numFrames},
            {"legolizations", frames.numPasses},
            {"waits", frames.numWaits},
            {"allocations", frames.numAllocations},
            {"allocationsInThisThread", frames.numOwnAllocations}};
}

/** What both lines of a row begin with. */
std::string formatCsvTime(const FrameRow& row, const char* drawn, const Spread& time)
{
    return fmt::format("{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", quotedField(row.mesh), row.resolution,
                       row.view, row.look, drawn, time.median, time.minimum, time.lowerQuartile, time.upperQuartile,
                       time.maximum);
}

} // namespace

std::string formatTables(const FrameResults& results)
{
    std::string text = formatEnvironment(results.environment, "");
    text += fmt::format(
        "\nMilliseconds a frame at {} x {}, medians and quartiles of {}: the reference, every face and stud drawn, "
        "of 16 sides; and the present way\n\n",
        results.size.x, results.size.y, results.numFrames);
    text +=
        "| mesh   | N   | view    | look      | reference               | present                | ratio | largest of "
        "255 | RMSE   | off by more than 2 | picture |\n"
        "|--------|-----|---------|-----------|-------------------------|------------------------|-------|-----------"
        "-----|--------|------------------|---------|\n";
    for (const FrameRow& row : results.rows)
        text += formatRow(row);
    return text + formatUnchanged(results) + formatGoals(checkGoals(results));
}

std::string formatJson(const FrameResults& results)
{
    ordered_json json{{"environment", toJson(results.environment)},
                      {"width", results.size.x},
                      {"height", results.size.y},
                      {"frames", results.numFrames}};
    for (const FrameRow& row : results.rows)
        json["rows"].push_back(toJson(row));
    json["unchanged"]["mesh"] = results.unchangedMesh;
    for (const UnchangedFrames& frames : results.unchanged)
        json["unchanged"]["rows"].push_back(toJson(frames));
    json["goals"] = toJson(checkGoals(results));
    return json.dump(4) + '\n';
}

std::string formatCsv(const FrameResults& results)
{
    std::string text = formatCsvHead(results.environment, checkGoals(results));
    text += "mesh,resolution,view,look,drawn,median,minimum,lowerQuartile,upperQuartile,maximum,largestDifference,"
            "rootMeanSquare,pixels,drawnPixels,frames,legolizations,waits,allocations,allocationsInThisThread\n";
    for (const FrameRow& row : results.rows)
    {
        const FrameDifference& difference = row.comparison.difference;
        text += formatCsvTime(row, "reference", row.comparison.reference) + ",,,,,,,,,\n";
        text += formatCsvTime(row, "present", row.comparison.present) +
                fmt::format(",{},{:.4f},{},{},,,,,\n", difference.largest, difference.rootMeanSquare,
                            difference.numPixels, difference.numDrawn);
    }
    for (const UnchangedFrames& frames : results.unchanged)
        text += fmt::format("{},,,{},{},,,,,,,,,,{},{},{},{},{}\n", quotedField(results.unchangedMesh), frames.look,
                            quotedField(frames.name), frames.numFrames, frames.numPasses, frames.numWaits,
                            frames.numAllocations, frames.numOwnAllocations);
    return text;
}

} // namespace osgLego
