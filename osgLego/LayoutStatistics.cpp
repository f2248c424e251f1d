#include <osgLego/LayoutStatistics.h>

#include <osgLego/data/BuildingLimits.h>
#include <osgLego/text/CountedNoun.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <span>
#include <sstream>
#include <vector>

namespace osgLego
{

namespace
{

std::string describe(const glm::ivec3& cell)
{
    return "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " + std::to_string(cell.z) + ")";
}

/** One sentence on the joins of pieces, and one on those that are left. */
std::string describe(const ConnectionStatistics& connection)
{
    if (std::max(connection.numPiecesBefore, connection.numPieces) <= 1)
        return "connections: the model is one piece without changes";
    const bool hasChanged = connection.numAddedCells + connection.numRecolored > 0;
    const bool remains = !hasChanged && !connection.isSupported;
    std::string text =
        "connections: " + std::to_string(remains ? connection.numPieces : connection.numPiecesBefore) + " pieces ";
    if (remains)
        text += "remain";
    else
        text += "became " + (connection.numPieces == 1 ? "one" : std::to_string(connection.numPieces));
    if (hasChanged)
        text += " by " + counted(connection.numAddedCells, "added cell", "added cells") + " and " +
                counted(connection.numRecolored, "cell", "cells") + " in another colour";
    if (connection.isSupported) text += hasChanged ? ", and by support" : " by support";
    constexpr std::size_t MOST_LISTED = 5;
    const std::size_t numLoose = connection.loose.size();
    const std::size_t numListed = numLoose <= MOST_LISTED + 1 ? numLoose : MOST_LISTED;
    for (const LoosePiece& piece : std::span(connection.loose).first(numListed))
        text += "\n  not joined: " + counted(piece.numParts, "part", "parts") + " in the cells " +
                describe(piece.lower) + " to " + describe(piece.upper);
    if (numListed < numLoose) text += "\n  not joined: " + std::to_string(numLoose - numListed) + " more pieces";
    return text;
}

/** The changes by which a model was made to stand. */
std::vector<std::string> listChanges(const SupportStatistics& support)
{
    std::vector<std::string> changes;
    if (support.isLaidAgain) changes.emplace_back("parts were laid again");
    if (support.numHiddenCells > 0)
        changes.push_back(counted(support.numHiddenCells, "hidden cell was added", "hidden cells were added"));
    if (support.numColumns > 0)
        changes.push_back(
            counted(support.numColumns, "column", "columns") + " of " +
            counted(support.numColumnParts, "part", "parts") + (support.numColumns == 1 ? " was" : " were") + " added" +
            (support.numBuildingColumns == 0
                 ? ""
                 : ", " + std::to_string(support.numBuildingColumns) + " of them for an easier building plan"));
    return changes;
}

/** One sentence on the changes by which a model was made to stand. */
std::string describe(const SupportStatistics& support)
{
    const std::vector<std::string> changes = listChanges(support);
    if (changes.empty())
        return std::string("support: ") +
               (support.stands ? "the model stands without it" : "nothing was found that helps; the model still falls");
    std::string text = "support: ";
    for (std::size_t index = 0; index < changes.size(); ++index)
        text += (index == 0 ? "" : index + 1 == changes.size() ? ", and " : ", ") + changes[index];
    if (support.numPropped > 0)
        return text + "; " +
               counted(support.numPropped, "loose piece stands on a column of its own",
                       "loose pieces stand on columns of their own");
    return text + (support.stands ? "; the model stands" : "; the model still falls");
}

/** A line on a building plan beyond the limits; empty if it keeps them. */
std::string describeBuilding(const SupportStatistics& support)
{
    const std::string excess =
        describeExcess(support.largestSubmodel, support.deepestSubmodel, support.numFallingSteps);
    if (excess.empty()) return {};
    return "\nbuilding: " + excess + ": " +
           (support.numBuildingColumns > 0 ? "no more columns were found that help"
                                           : "no columns were found that help");
}

} // namespace

std::string LayoutStatistics::toString() const
{
    std::ostringstream text;
    text << std::fixed;
    text << counted(numParts, "part", "parts") << " in " << counted(numColors, "colour", "colours") << " for "
         << counted(numCells, "cell", "cells") << ", " << numInterior << " of them inside";
    if (lowerBound) text << "; the fewest possible, layer by layer: " << *lowerBound;
    text << std::setprecision(1) << "\nsize: " << 0.1 * size.x << " cm wide, " << 0.1 * size.y << " cm deep and "
         << 0.1 * size.z << " cm high\n"
         << counted(numComponents, "piece", "pieces");
    if (numComponents > 1) text << " (these cells need at least " << numComponentsPossible << ")";
    text << "; ";
    if (numFloating > 0) text << counted(numFloating, "part floats", "parts float") << "; ";
    text << "parts without which a piece would fall apart: " << numArticulationParts << '\n';
    text << "seams above seams: " << 100.0 * stackedSeams << " %, " << counted(stackedLength, "stud", "studs")
         << " long; colour error: " << meanColorError << " on average, at most " << maximumColorError
         << " in CIEDE2000";
    if (numUnavailable > 0)
        text << '\n'
             << counted(numUnavailable, "part has a size that was never made in its colour",
                        "parts have sizes that were never made in their colour");
    if (connection) text << '\n' << describe(*connection);
    if (support) text << '\n' << describe(*support) << describeBuilding(*support);
    return text.str();
}

} // namespace osgLego
